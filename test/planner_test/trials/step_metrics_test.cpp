#include "collision_forge/planner_test/trials/step_metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "planner_test/trials/rear_end_case.h"
#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

/// The ego drives east at a speed (m/s) and turns left at 0.2 rad/s, its acceleration grows by 10
/// m/s3. An attacker 30 m ahead drives at 2 m/s, a car stands 10 m beside the ego.
std::vector<StepMetrics> stepsAt(double speed, double y = 0.0) {
  const CrashScenario scenario = roadScenario(5.0, straightDrive({30.0, 0.0, 0.0}, 2.0, 6.0),
                                              {straightCar("beside", {0.0, 10.0, 0.0}, 0.0)});
  PlannerRow row;
  row.outcome.attacker = scenario.attacker;
  for (int i = 0; i <= 2; ++i) {
    row.outcome.driven.push_back({kNow + 0.1 * i, {0.5 * i, y, 0.02 * i}, speed, 1.0 * i, 0.0});
  }
  return stepMetrics(scenario, row);
}

TEST(StepMetrics, DeriveFromTheMotions) {
  const auto steps = stepsAt(5.0);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_FALSE(steps[0].jerk);
  EXPECT_FALSE(steps[0].lateral_acceleration);
  EXPECT_NEAR(*steps[1].jerk, 10.0, 1e-6);
  EXPECT_NEAR(*steps[1].lateral_acceleration, 5.0 * 0.2, 1e-6);
}

TEST(StepMetrics, MeasureGapAndTimeToTheAttacker) {
  const StepMetrics step = stepsAt(5.0)[0];
  const double gap = 30.0 - 0.5 * (kEgoSize.length + kCarSize.length);
  EXPECT_NEAR(*step.attacker_gap, gap, 1e-6);
  EXPECT_NEAR(*step.attacker_ttc, gap / (5.0 - 2.0), 1e-2);
  EXPECT_EQ(step.nearest, "beside");
  EXPECT_NEAR(*step.nearest_gap, 10.0 - 0.5 * (kEgoSize.width + kCarSize.width), 1e-6);
  EXPECT_FALSE(stepsAt(1.0)[0].attacker_ttc) << "the attacker gets away";
}

TEST(StepMetrics, NameTheLaneAndTheRoad) {
  EXPECT_EQ(stepsAt(5.0)[0].lane, twoLaneRoad()->lanes[0].id);
  EXPECT_EQ(stepsAt(5.0)[0].on_road, true);
  EXPECT_EQ(stepsAt(5.0, -40.0)[0].lane, "");
  EXPECT_EQ(stepsAt(5.0, -40.0)[0].on_road, false);
}

TEST(StepsCsv, HasARowPerStepOfEveryRollout) {
  const PlannerTestResult result = tested();
  std::istringstream text(stepsCsv(rearEnd(), result));
  std::string header;
  std::getline(text, header);
  std::size_t rows = 0;
  for (std::string line; std::getline(text, line); ++rows) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','),
              std::count(header.begin(), header.end(), ','));
  }
  EXPECT_EQ(rows, result.rows[0].outcome.driven.size() + result.rows[1].outcome.driven.size());
}

}  // namespace
}  // namespace forge
