#include "collision_forge/planner_test/trials/weaknesses.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

const UntilHitOptions kOptions{100, 1.0};

PlannerTestResult hit(double impact_speed, bool at_fault = false,
                      ContactPlace place = ContactPlace::kLane) {
  PlannerTestResult result;
  result.status = "OK";
  PlannerRow row;
  row.planner = "pdm";
  row.attacker.policy = PolicyKind::kAdaptive;
  PlannerContact contact;
  contact.is_attacker = true;
  contact.impact_speed = impact_speed;
  contact.at_fault = at_fault;
  contact.place = place;
  row.outcome.contact = contact;
  result.rows = {row};
  return result;
}

std::vector<Weakness> weaknessesOf(const std::vector<PlannerTestResult>& results,
                                   const std::vector<Manoeuvre>& manoeuvres) {
  return findWeaknesses(
      results, [&](std::size_t index) { return manoeuvres.at(index); }, kOptions);
}

TEST(Weaknesses, GroupHitsOfOneKindHardestFirstAtEqualSeverity) {
  const auto found =
      weaknessesOf({hit(3.0), hit(9.0), hit(5.0)}, std::vector<Manoeuvre>(3, Manoeuvre::kCutIn));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].results, (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_EQ(found[0].manoeuvre, Manoeuvre::kCutIn);
  EXPECT_EQ(found[0].row.planner, "pdm");
}

TEST(Weaknesses, HaveTheHitWithTheLikeliestSevereInjuryFirst) {
  std::vector<PlannerTestResult> results = {hit(9.0), hit(3.0), hit(5.0)};
  results[1].rows[0].outcome.contact->severity.other.mais3 = 0.3;  // a pedestrian, say
  results[2].rows[0].outcome.contact->severity.ego.mais3 = 0.1;
  const auto found = weaknessesOf(results, std::vector<Manoeuvre>(3, Manoeuvre::kCutIn));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].results, (std::vector<std::size_t>{1, 2, 0}));
}

TEST(Weaknesses, DifferByManoeuvreFaultPlaceAndPlanner) {
  std::vector<PlannerTestResult> results = {
      hit(3.0), hit(9.0, true), hit(5.0, false, ContactPlace::kJunction), hit(2.0), hit(1.5)};
  results[4].rows[0].planner = "idm";
  const auto found = weaknessesOf(results, {Manoeuvre::kCutIn, Manoeuvre::kCutIn, Manoeuvre::kCutIn,
                                            Manoeuvre::kMerge, Manoeuvre::kCutIn});
  ASSERT_EQ(found.size(), 5u);
  EXPECT_TRUE(found[0].at_fault) << "the most severe hit";
  EXPECT_EQ(found[1].place, ContactPlace::kJunction);
  EXPECT_EQ(found[3].manoeuvre, Manoeuvre::kMerge);
  EXPECT_EQ(found[4].row.planner, "idm");
}

TEST(Weaknesses, CountOnlyFairHardHitsWithinTheAttackersLimits) {
  std::vector<PlannerTestResult> results(8, hit(5.0));
  results[0].rows[0].is_fair = false;
  results[1].rows[0].outcome.contact->is_attacker = false;
  results[2].rows[0].outcome.contact->impact_speed = 0.9;
  results[3].rows[0].attacker.broken_limit = "max_jerk";
  results[4].rows[0].attacker.touched = "somebody";
  results[6].rows[0].attacker.phase = AttackerPhase::kDrivingOn;
  results[5].rows[0].outcome.failure = PlannerFailure::kOffMap;
  const auto found = weaknessesOf(results, std::vector<Manoeuvre>(8, Manoeuvre::kDrift));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].results, std::vector<std::size_t>{7});
}

TEST(Weaknesses, CountFollowersOnlyIfThePlannerIsAtFault) {
  const auto found = weaknessesOf({hit(5.0), hit(4.0, true)},
                                  std::vector<Manoeuvre>(2, Manoeuvre::kFollowerCloses));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].at_fault);
}

}  // namespace
}  // namespace forge
