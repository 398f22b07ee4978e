#include "collision_forge/io/logs/recording_repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Positions at 10 m/s along x, every `interval` s.
struct Drive {
  explicit Drive(std::size_t count, double interval) {
    for (std::size_t i = 0; i < count; ++i) {
      times.push_back(static_cast<double>(i) * interval);
      positions.emplace_back(10.0 * times.back(), 0.0);
    }
  }
  std::vector<double> times;
  std::vector<Vector2> positions;
};

std::vector<std::size_t> jumpsIn(const Drive& drive) {
  return jumpsOf(drive.times, drive.positions);
}

TEST(JumpsOf, NothingJumpsInHardBrakingOrNoise) {
  Drive drive(40, 0.5);
  for (std::size_t i = 0; i < 40; ++i) {
    const double time = drive.times[i];
    drive.positions[i].x() = time < 4.0 ? 25.0 * time - 4.5 * time * time : 28.0;
    drive.positions[i].y() = i % 2 == 0 ? 0.4 : -0.4;
  }
  EXPECT_THAT(jumpsIn(drive), IsEmpty());
}

TEST(JumpsOf, FindsPositionsFarOffAnywhereInATrack) {
  for (const double interval : {0.1, 0.5}) {
    for (const std::size_t first : {0U, 1U, 20U, 37U}) {
      Drive drive(40, interval);
      drive.positions[first].x() -= 40.0;
      drive.positions[first + 1].x() -= 40.0;
      EXPECT_THAT(jumpsIn(drive), ElementsAre(first, first + 1)) << interval;
    }
  }
}

TEST(JumpsOf, FindsASinglePositionBesideItsNeighbours) {
  for (const double interval : {0.1, 0.5}) {
    Drive drive(12, interval);
    drive.positions[6].y() += 3.0;
    EXPECT_THAT(jumpsIn(drive), ElementsAre(6)) << interval;
  }
}

TEST(JumpsOf, KeepsTheLongerPartOfATrackThatChangesItsPlace) {
  Drive drive(10, 0.1);
  for (std::size_t i = 7; i < 10; ++i) drive.positions[i].y() += 30.0;
  EXPECT_THAT(jumpsIn(drive), ElementsAre(7, 8, 9));
}

/// Frames and ego poses every 0.5 s; the ego at 10 m/s along x, one car 20 m beside it.
class RecordingRepairTest : public testing::Test {
 protected:
  RecordingRepairTest() {
    options_.ego_vehicle = {{4.0, 2.0}, 0.0};
    options_.categories = {{"car", AgentClass::kCar}};
    recording_.name = "scene";
    for (int i = 0; i < 10; ++i) {
      const std::int64_t time = 1000000 + 500000 * i;
      recording_.ego_poses.push_back({time, {5.0 * i, 0.0, 0.0}});
      recording_.frames.push_back({"", time, {annotation("car", 5.0 * i, 20.0)}});
    }
  }

  static NuScenesAnnotation annotation(const char* id, double x, double y) {
    NuScenesAnnotation annotation;
    annotation.instance = id;
    annotation.category = "vehicle.car";
    annotation.translation = {x, y, 0.0};
    annotation.size = {4.5, 1.9, 1.5};
    annotation.velocity = {10.0, 0.0, 0.0};
    return annotation;
  }

  std::vector<std::string> warningsOfRepair() {
    std::vector<std::string> warnings;
    repair(recording_, options_, &warnings);
    return warnings;
  }

  DataOptions options_;
  NuScenesRecording recording_;
};

TEST_F(RecordingRepairTest, KeepsAValidRecording) {
  EXPECT_THAT(warningsOfRepair(), IsEmpty());
  EXPECT_EQ(recording_.ego_poses.size(), 10U);
  for (const NuScenesFrame& frame : recording_.frames) ASSERT_EQ(frame.annotations.size(), 1U);
}

TEST_F(RecordingRepairTest, AnEgoPoseThatJumpsIsLeftOutWithItsTime) {
  recording_.ego_poses[4].translation.y() = 40.0;
  EXPECT_THAT(warningsOfRepair(), ElementsAre(HasSubstr("1 pose of 10 of the ego left out as jumps "
                                                        "(first: 2.00 s after the start")));
  EXPECT_EQ(recording_.ego_poses.size(), 9U);
}

TEST_F(RecordingRepairTest, AStateThatJumpsIsLeftOutAndVelocitiesAreDerivedAgain) {
  recording_.frames[5].annotations[0].translation.x() -= 40.0;
  recording_.frames[4].annotations[0].velocity.x() = -30.0;
  EXPECT_THAT(warningsOfRepair(),
              ElementsAre("1 state of 1 agent left out as jumps (first: car, 2.50 s after the "
                          "start)"));
  EXPECT_TRUE(recording_.frames[5].annotations.empty());
  EXPECT_DOUBLE_EQ(recording_.frames[4].annotations.at(0).velocity.x(), 10.0);
}

TEST_F(RecordingRepairTest, AnAgentAtThePlaceOfTheEgoIsLeftOut) {
  for (std::size_t i = 0; i < 10; ++i) {
    const double x = recording_.ego_poses[i].translation.x();
    recording_.frames[i].annotations.push_back(annotation("hero", x + 1.4, 0.2));
    recording_.frames[i].annotations.push_back(annotation("lead", x + 6.0, 0.0));
  }
  EXPECT_THAT(warningsOfRepair(),
              ElementsAre("1 agent at the place of the ego left out as the ego itself (first: hero "
                          "in 10 of 10 frames)"));
  EXPECT_EQ(recording_.frames[3].annotations.size(), 2U);
}

TEST_F(RecordingRepairTest, AnAgentHasItsMedianSize) {
  recording_.frames[0].annotations[0].size = {1.2, 1.5, 1.0};
  EXPECT_THAT(warningsOfRepair(),
              ElementsAre(HasSubstr("1 agent whose first size is not typical of the track "
                                    "(first: car)")));
  EXPECT_EQ(recording_.frames[0].annotations[0].size, Eigen::Vector3d(4.5, 1.9, 1.5));
}

TEST_F(RecordingRepairTest, NamesOfOtherDataSetsBecomeCategoriesAndTheRestIsCounted) {
  for (NuScenesFrame& frame : recording_.frames) {
    frame.annotations[0].category = "Car";
    frame.annotations.push_back(annotation("a", 0.0, 60.0));
    frame.annotations.back().category = "ufo";
  }
  EXPECT_THAT(warningsOfRepair(), ElementsAre(HasSubstr("static objects: 1 of \"ufo\"")));
  EXPECT_EQ(recording_.frames[0].annotations[0].category, "vehicle.car");
}

}  // namespace
}  // namespace forge
