#include "collision_forge/planner_test/report/compact_motion.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(Differences, AddUpToTheValuesWithinHalfAUnit) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(400.0 * std::sin(0.01 * i));
  const std::vector<double> steps = differences(values, 0.01);
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(steps[i], std::round(steps[i]));
    sum += steps[i];
    EXPECT_NEAR(0.01 * sum, values[i], 0.005001);
  }
}

TEST(WriteTrajectory, HasTimesFromTheOriginInWholeUnits) {
  JsonLineWriter writer;
  writer.beginObject();
  writeTrajectory(
      writer, "motion",
      {{10.0, {1.0, 2.0, 0.5}, 3.0, -1.0, 0.0}, {10.1, {1.5, 2.0, 0.5}, 3.0, -2.0, 0.0}}, 9.0);
  writer.endObject();
  EXPECT_EQ(writer.line(), R"({"motion":{"t":[1000,100],"x":[100,50],"y":[200,0],"yaw":[500,0],)"
                           R"("v":[300,0],"a":[-100,-100]}})");
}

}  // namespace
}  // namespace forge
