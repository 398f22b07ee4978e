#include "collision_forge/planner_test/report/options.h"

#include <gtest/gtest.h>

#include "collision_forge/base/config/section.h"

namespace forge {
namespace {

TEST(ReportOptions, OutlinesAreLessOffThanALaneLineIsWide) {
  ReportOptions options;
  readConfigFile(COLLISION_FORGE_SOURCE_DIR "/config", "report", options);
  EXPECT_LE(options.map_tolerance, 0.2);
  EXPECT_GT(options.map_margin, 30.0);
}

}  // namespace
}  // namespace forge
