#include "collision_forge/planner_test/report/junit_file.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "planner_test/trials/made_results.h"

namespace forge {
namespace {

TEST(JunitFile, HasACasePerResultAndPerCriterion) {
  PlannerTestResult skipped = result("s:3", "a", {});
  skipped.status = "NO_ATTACK";
  const std::vector<PlannerTestResult> results = {result("s:1", "a", {row("idm", 4.0)}),
                                                  result("s:2", "a", {row("idm", {})}), skipped};
  const std::vector<Criterion> criteria = {parseCriterion("avoidable_hits > 0"),
                                           parseCriterion("failures > 0")};
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(
      junitText(results, criteria, judge(criteria, results, {"idm"}), {"idm"}).c_str()));
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  EXPECT_STREQ(suite.attribute("name").value(), "idm");
  EXPECT_EQ(suite.attribute("tests").as_int(), 5);
  EXPECT_EQ(suite.attribute("failures").as_int(), 2);
  EXPECT_EQ(suite.attribute("skipped").as_int(), 1);
  const auto entry = [&](const char* name) {
    return suite.find_child_by_attribute("testcase", "name", name);
  };
  EXPECT_TRUE(entry("s:1").child("failure"));
  EXPECT_FALSE(entry("s:2").first_child());
  EXPECT_TRUE(entry("s:3").child("skipped"));
  EXPECT_TRUE(entry("fails if avoidable_hits > 0").child("failure"));
  EXPECT_FALSE(entry("fails if failures > 0").first_child());
}

}  // namespace
}  // namespace forge
