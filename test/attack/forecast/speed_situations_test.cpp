#include "collision_forge/attack/forecast/speed_situations.h"

#include <gtest/gtest.h>

#include <limits>

namespace forge {
namespace {

void addScene(std::vector<SpeedProfileRow>& rows, const std::string& name, int frames, double speed,
              double gain) {
  for (int i = 0; i < frames; ++i) rows.push_back({name, i, speed + i * gain, {}});
}

TEST(SpeedSituations, FeaturesAreDifferencesOfSpeedsAndTheWayAhead) {
  const DrivingSituation situation{{8.0, 7.5, 7.3, 7.2, 6.3}, {0.1, -1.5, 0.2, 0.03, 0.4, 0.5}};
  Eigen::ArrayXd expected(kSpeedFeatures);
  expected << 8.0, 1.0, 0.4, 1.0, 0.1, -1.5, 0.2, 0.3, 0.4, 0.5;
  EXPECT_TRUE(featuresOf(situation).isApprox(expected, 1e-12));
}

TEST(SpeedSituations, EachRowKnowsItsPastAndWhatFollowed) {
  std::vector<SpeedProfileRow> rows;
  addScene(rows, "a", 4, 5.0, 0.5);
  addScene(rows, "b", 2, 9.0, -1.0);
  rows[3].ahead.closing = 0.7;
  const SpeedSituations recorded(rows);
  ASSERT_EQ(recorded.size(), 6);
  EXPECT_EQ(recorded.scenes(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(recorded.sceneNumber("b"), 1);
  EXPECT_EQ(recorded.sceneNumber("c"), -1);
  EXPECT_EQ(recorded.sceneOf(3), 0);
  EXPECT_EQ(recorded.sceneOf(4), 1);
  for (int row = 0; row < 6; ++row) EXPECT_EQ(recorded.lasts(row), row < 4 ? 3 - row : 5 - row);
  EXPECT_EQ(recorded.gain(0, 0), 0.5);
  EXPECT_EQ(recorded.gain(0, 2), 1.5);
  EXPECT_EQ(recorded.gain(4, 0), -1.0);
  // Before the first frame of a scene its speed is taken.
  EXPECT_EQ(recorded.situation(2).past_speeds, (std::array<double, 5>{6.0, 5.5, 5.0, 5.0, 5.0}));
  EXPECT_EQ(recorded.situation(4).past_speeds, (std::array<double, 5>{9.0, 9.0, 9.0, 9.0, 9.0}));
  EXPECT_EQ(recorded.situation(3).ahead.closing, 0.7);
  EXPECT_EQ(recorded.features()(3, 9), 0.7);
  EXPECT_EQ(recorded.features()(2, 1), 1.0);
}

TEST(SpeedSituations, AGapEndsAProfileAndThePast) {
  std::vector<SpeedProfileRow> rows;
  addScene(rows, "a", 4, 5.0, 0.5);
  rows[2].frame = 3;
  rows[3].frame = 4;
  const SpeedSituations recorded(rows);
  EXPECT_EQ(recorded.lasts(0), 1);
  EXPECT_EQ(recorded.lasts(1), 0);
  EXPECT_EQ(recorded.situation(2).past_speeds, (std::array<double, 5>{6.0, 6.0, 6.0, 6.0, 6.0}));
}

TEST(SpeedSituations, RefusesDisorderAndNumbersThatAreNone) {
  std::vector<SpeedProfileRow> rows;
  addScene(rows, "a", 3, 5.0, 0.0);
  std::vector<SpeedProfileRow> repeated = rows;
  repeated[2].frame = 1;
  EXPECT_THROW(SpeedSituations{repeated}, std::invalid_argument);
  std::vector<SpeedProfileRow> torn = rows;
  addScene(torn, "b", 2, 5.0, 0.0);
  torn.push_back({"a", 7, 5.0, {}});
  EXPECT_THROW(SpeedSituations{torn}, std::invalid_argument);
  rows[1].ahead.closing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(SpeedSituations{rows}, std::invalid_argument);
}

}  // namespace
}  // namespace forge
