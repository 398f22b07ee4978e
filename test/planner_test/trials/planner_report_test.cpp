#include "collision_forge/planner_test/trials/planner_report.h"

#include <gtest/gtest.h>
#include <set>

namespace forge {
namespace {

PlannerRow row(const std::string& planner, std::optional<double> impact_speed,
               bool is_attacker = true) {
  PlannerRow found{planner, {}, {}};
  found.outcome.progress = 5.0;
  found.outcome.recorded_progress = 10.0;
  if (impact_speed) {
    PlannerContact contact;
    contact.is_attacker = is_attacker;
    contact.impact_speed = *impact_speed;
    found.outcome.contact = contact;
  }
  return found;
}

PlannerTestResult result(const std::string& scene, bool is_avoidable,
                         std::vector<PlannerRow> rows) {
  PlannerTestResult one;
  one.name = scene;
  one.source = "history";
  one.scene = scene;
  one.tta = 4.0;
  one.status = "OK";
  one.avoidability.is_avoidable = is_avoidable;
  one.rows = std::move(rows);
  return one;
}

/// Results of "idm": two hits at 4 and 8 m/s (one unavoidable), a contact with another agent, no
/// contact, a failure.
std::vector<PlannerTestResult> results() {
  std::vector<PlannerTestResult> found = {
      result("a", true, {row("idm", 4.0)}), result("b", false, {row("idm", 8.0)}),
      result("c", true, {row("idm", 6.0, false)}), result("d", true, {row("idm", {})}),
      result("e", true, {row("idm", {})})};
  found[4].rows[0].outcome.failure = PlannerFailure::kEmpty;
  PlannerTestResult rejection = result("f", false, {});
  rejection.status = "NO_CANDIDATE";
  found.push_back(rejection);
  return found;
}

Rate rateOf(const std::vector<PlannerTestResult>& all, const std::string& measure,
            std::size_t method = 0) {
  for (const PlannerTable& entry : plannerTables(all, {"idm"})) {
    if (entry.table.measure.name == measure) return entry.table.rates.at(method).back();
  }
  throw std::out_of_range(measure);
}

TEST(PlannerReport, TablesHaveDistinctNames) {
  std::set<std::string> names;
  for (const PlannerTable& entry : plannerTables(results(), {"idm"})) {
    EXPECT_TRUE(names.insert(entry.table.measure.name).second) << entry.table.measure.name;
  }
}

TEST(PlannerReport, CountsContactsWithTheAttacker) {
  EXPECT_EQ(rateOf(results(), "collision").trials, 4);
  EXPECT_DOUBLE_EQ(rateOf(results(), "collision").value, 0.5);
  EXPECT_EQ(rateOf(results(), "collision_avoidable").trials, 3);
  EXPECT_NEAR(rateOf(results(), "collision_avoidable").value, 1.0 / 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(rateOf(results(), "other").value, 0.25);
}

TEST(PlannerReport, CountsSoftAndAtFaultCollisions) {
  std::vector<PlannerTestResult> all = results();
  all[0].rows[0].outcome.contact->impact_speed = 0.49;
  all[1].rows[0].outcome.contact->at_fault = true;
  all[2].rows[0].outcome.contact->at_fault = true;  // with another
  EXPECT_EQ(rateOf(all, "soft").trials, 2);
  EXPECT_DOUBLE_EQ(rateOf(all, "soft").value, 0.5);
  EXPECT_EQ(rateOf(all, "collision_at_fault").trials, 2);
  EXPECT_DOUBLE_EQ(rateOf(all, "collision_at_fault").value, 0.5);
}

TEST(PlannerReport, WorstCasesAreTheMostSevereFairHitsOnePerScene) {
  auto all = results();
  PlannerTestResult again = result("b", true, {row("idm", 7.0)});
  all.push_back(again);
  const auto worst = worstCases(all, {"idm"}, 5);
  ASSERT_EQ(worst.size(), 2u);
  EXPECT_EQ(worst[0].result, 1u);
  EXPECT_EQ(worst[1].result, 0u);
  EXPECT_EQ(worstCases(all, {"idm"}, 1).size(), 1u);
  all[1].rows[0].is_fair = false;
  all.back().rows[0].is_fair = false;
  EXPECT_EQ(worstCases(all, {"idm"}, 5).front().result, 0u);
}

TEST(PlannerReport, CountsCollisionsThatACarefulDriverAvoids) {
  auto all = results();
  all[0].rows[0].outcome.careful_drivers = {{"cc_driver", true, {}}, {"rss", false, {}}};
  EXPECT_EQ(rateOf(all, "avoided_by_cc_driver").trials, 2);
  EXPECT_DOUBLE_EQ(rateOf(all, "avoided_by_cc_driver").value, 0.5);
  EXPECT_DOUBLE_EQ(rateOf(all, "avoided_by_rss").value, 0.0);
}

TEST(PlannerReport, UnfairCollisionsAreNotCounted) {
  auto all = results();
  all[1].rows[0].is_fair = false;
  EXPECT_EQ(rateOf(all, "collision_fair").trials, 3);
  EXPECT_NEAR(rateOf(all, "collision_fair").value, 1.0 / 3.0, 1e-12);
}

TEST(PlannerReport, CountsAvoidableCollisions) {
  auto all = results();
  EXPECT_EQ(rateOf(all, "evasion").trials, 0);
  all[0].rows[0].evasion = AvoidabilitySummary{true, {}, EvasiveManoeuvre::kBraking, 1.0, 0.0};
  all[1].rows[0].evasion = AvoidabilitySummary{};
  EXPECT_EQ(rateOf(all, "evasion").trials, 2);
  EXPECT_DOUBLE_EQ(rateOf(all, "evasion").value, 0.5);
}

}  // namespace
}  // namespace forge
