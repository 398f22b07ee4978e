#include "collision_forge/planner_test/trials/pass_criteria.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "planner_test/trials/made_results.h"

namespace forge {
namespace {

using testing::HasSubstr;

std::string errorOf(const std::string& text) {
  try {
    parseCriteria(text);
    return "none";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

std::vector<PlannerTestResult> twoHitsOfThree() {
  std::vector<PlannerTestResult> results = {result("s:1", "a", {row("idm", 4.0)}),
                                            result("s:2", "a", {row("idm", 9.0)}),
                                            result("s:3", "b", {row("idm", {})})};
  results[0].rows[0].is_fair = false;
  RolloutOutcome& second = results[1].rows[0].outcome;
  second.nuplan.total = 0.25;
  second.careful_drivers = {{"rss", true, {}}, {"cc_driver", true, {}}};
  results[0].rows[0].outcome.careful_drivers = {{"rss", true, {}}};
  second.contact->severity.ego.delta_v = 6.0;
  second.contact->severity.ego.most_class = 1;
  second.contact->severity.other.mais3 = 0.2;
  second.contact->severity.other.most_class = 2;
  return results;
}

TEST(PassCriteria, CompareCountsMaximaAndMeans) {
  for (const auto& [text, is_failed] : {std::pair("hits > 1", true),
                                        {"hits > 2", false},
                                        {"avoidable_hits >= 1", true},
                                        {"avoidable_hits > 1", false},
                                        {"careful_avoidable_hits >= 1", true},
                                        {"careful_avoidable_hits > 1", false},
                                        {"delta_v > 5.9", true},
                                        {"mais3 > 0.19", true},
                                        {"mais3 > 0.2", false},
                                        {"iso_26262_class >= 2", true},
                                        {"iso_26262_class >= 3", false},
                                        {"impact_speed > 8.5", true},
                                        {"impact_speed >= 9.5", false},
                                        {"score < 0.8", true},
                                        {"score<=0.7", false},
                                        {"worst_score < 0.3", true},
                                        {"failures > 0", false}}) {
    const auto verdicts = judge({parseCriterion(text)}, twoHitsOfThree(), {"idm"});
    ASSERT_EQ(verdicts.size(), 1u);
    EXPECT_EQ(verdicts[0].is_failed, is_failed) << text << ": " << verdicts[0].value;
  }
}

TEST(PassCriteria, JudgeEachRowByEachCriterion) {
  const auto verdicts = judge({parseCriterion("hits > 0"), parseCriterion("failures > 0")},
                              twoHitsOfThree(), {"idm", "pdm"});
  ASSERT_EQ(verdicts.size(), 4u);
  EXPECT_EQ(verdicts[2].row, "pdm");
  EXPECT_FALSE(verdicts[2].is_failed);
  EXPECT_THAT(verdictText(verdicts), HasSubstr("FAILED  idm: fails if hits > 0; hits = 2\n"));
}

TEST(PassCriteria, NameTheError) {
  EXPECT_THAT(errorOf("speed > 1"), HasSubstr("unknown measure \"speed\"; known measures: hits"));
  for (const char* text :
       {"hits", "hits > ", "hits = 3", "hits > three", "hits > 3 4", "a b > 3", ""}) {
    EXPECT_THAT(errorOf(text), HasSubstr("is not a criterion")) << text;
  }
  EXPECT_THAT(errorOf("@/no/such/file"), HasSubstr("/no/such/file: cannot be read"));
}

TEST(PassCriteria, AreReadFromAFileWithComments) {
  const std::string path = testing::TempDir() + "criteria.txt";
  std::ofstream(path) << "# limits\n\n  hits > 3  # too many\nscore < 0.5\n";
  const auto criteria = parseCriteria("@" + path);
  ASSERT_EQ(criteria.size(), 2u);
  EXPECT_EQ(criteria[0].text, "hits > 3");
  EXPECT_EQ(criteria[1].bound, 0.5);
  std::ofstream(path) << "hits > 3\nhits\n";
  EXPECT_THAT(errorOf("@" + path), HasSubstr("criteria.txt:2: "));
  std::remove(path.c_str());
}

TEST(PassCriteria, FailTheRowsThatAMeasureCounts) {
  const auto results = twoHitsOfThree();
  const std::vector<Criterion> criteria = {parseCriterion("avoidable_hits > 5"),
                                           parseCriterion("impact_speed > 3.5")};
  EXPECT_EQ(failedBy(criteria, results[0].rows[0]), "impact_speed > 3.5");
  EXPECT_EQ(failedBy(criteria, results[1].rows[0]), "avoidable_hits > 5");
  EXPECT_EQ(failedBy(criteria, results[2].rows[0]), "");
}

}  // namespace
}  // namespace forge
