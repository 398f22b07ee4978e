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

}  // namespace
}  // namespace forge
