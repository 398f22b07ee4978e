#include "collision_forge/planner_test/report/coverage_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::vector<CatalogueEntry> catalogue() {
  CatalogueEntry cut_in{"set/cut_in", "a car <cuts> in", "", "", {}, {}};
  cut_in.cells = {
      {"set/cut_in speed=1", {}}, {"set/cut_in speed=2", {}}, {"set/cut_in speed=3", {}}};
  return {cut_in,
          {"set/doors", "a door opens", "", "doors do not open", {}, {}},
          {"other/x", "not asked for", "", "", {}, {{"other/x", {}}}}};
}

Scenario scenarioOf(const std::string& name, StatusCode code) {
  Scenario scenario;
  scenario.asked.name = name;
  scenario.answer.status.code = code;
  return scenario;
}

PlannerTestResult testOf(const std::string& name, bool is_hit, bool is_avoidable) {
  PlannerTestResult result;
  result.name = name;
  result.status = "OK";
  PlannerRow& row = result.rows.emplace_back();
  row.planner = "idm";
  if (is_hit) {
    row.outcome.contact.emplace();
    row.outcome.contact->is_attacker = true;
    row.evasion.emplace().is_avoidable = is_avoidable;
  }
  return result;
}

/// Returns the table row of a cell.
std::string rowOf(const std::string& page, const std::string& cell) {
  const std::size_t begin = page.find("<td>" + cell + "</td>");
  return begin == std::string::npos ? "" : page.substr(begin, page.find("</tr>", begin) - begin);
}

TEST(Coverage, CountsRequestsAttacksAndTestsByCell) {
  Coverage coverage;
  coverage.add(scenarioOf("set/cut_in speed=1", StatusCode::kOk), "a:1");
  coverage.add(scenarioOf("set/cut_in speed=1", StatusCode::kOk), "a:2");
  coverage.add(scenarioOf("set/cut_in speed=1", StatusCode::kRoadDoesNotAllow), "a:3");
  coverage.add(scenarioOf("set/cut_in speed=2", StatusCode::kNoCandidate), "a:4");
  coverage.add(testOf("a:1", true, true));
  coverage.add(testOf("a:2", false, false));
  coverage.add(testOf("b:1", true, true));
  const std::string page = coverage.page(catalogue());
  EXPECT_THAT(page, AllOf(HasSubstr("set: 1 of 3 cells generated"), HasSubstr("a car &lt;cuts> in"),
                          HasSubstr("cannot be requested: doors do not open"),
                          Not(HasSubstr("not asked for"))));
  EXPECT_THAT(rowOf(page, "cut_in speed=1"),
              HasSubstr("<td>3</td><td>2</td><td>2</td><td>1 (1) / 1</td><td class=\"reason\">1 "
                        "ROAD_DOES_NOT_ALLOW</td>"));
  EXPECT_THAT(rowOf(page, "cut_in speed=2"), HasSubstr("<td>1</td><td>1</td><td>0</td><td></td>"));
  EXPECT_THAT(rowOf(page, "cut_in speed=3"), HasSubstr("no request"));
}

TEST(Coverage, IsEmptyWithoutARequestOfACatalogue) {
  Coverage coverage;
  coverage.add(scenarioOf("", StatusCode::kOk), "a:1");
  EXPECT_TRUE(coverage.empty());
}

}  // namespace
}  // namespace forge
