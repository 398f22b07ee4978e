#include "collision_forge/planner_test/trials/kept_drives.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "collision_forge/planner_test/trials/planner_result_file.h"
#include "io/logs/nuscenes_fixture.h"
#include "planner_test/trials/rear_end_case.h"

namespace forge {
namespace {

TEST(KeptDrives, ARowComesWithItsMotionsAndTheAttackersBox) {
  const TemporaryFolder folder;
  const PlannerTestResult result = tested();
  PlannerTestResult before = result;
  before.rows.clear();
  folder.write("results.jsonl",
               plannerResultLine(before) + "\n" + plannerResultLine(result) + "\n");
  const KeptDrives drives(folder.path() + "/results.jsonl");
  const PlannerCase one = rearEnd();
  const PlannerRow row = drives.rowOf(one, 1, {"idm"});
  const RolloutOutcome& outcome = row.outcome;
  EXPECT_EQ(outcome.driven.size(), result.rows[0].outcome.driven.size());
  EXPECT_EQ(outcome.attacker.size.length, one.scenario.attacker.size.length);
  EXPECT_EQ(outcome.attacker.points.size(), result.rows[0].outcome.attacker.points.size());
  EXPECT_THROW(drives.rowOf(one, 0, {"idm"}), std::out_of_range);
  EXPECT_THROW(drives.rowOf(one, 2, {"idm"}), std::out_of_range);
}

TEST(KeptDrives, AMissingFileIsNamed) {
  EXPECT_THROW(KeptDrives("nowhere.jsonl"), std::runtime_error);
}

}  // namespace
}  // namespace forge
