#include "collision_forge/attack/policy/recorded_drive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// Records the frames that it observes.
class Witness : public AttackerPolicy {
 public:
  std::unique_ptr<AttackerPolicy> clone() const override {
    return std::make_unique<Witness>(*this);
  }
  explicit Witness(double duration) : trajectory_(straightDrive({0.0, 0.0, 0.0}, 1.0, duration)) {}
  void observe(const Frame& seen) override { seen_.push_back(seen); }
  const AttackerTrajectory& trajectory() const override { return trajectory_; }
  AttackerPhase phase() const override { return AttackerPhase::kAttacking; }
  const std::vector<AttackerPlan>& plans() const override { return plans_; }
  const std::vector<Frame>& seen() const { return seen_; }

 private:
  AttackerTrajectory trajectory_;
  std::vector<AttackerPlan> plans_;
  std::vector<Frame> seen_;
};

Scene recording() {
  Scene scene;
  scene.ego = futureTrack(kEgoId, kEgoSize, {0.0, 0.0, 0.0}, 5.0);
  scene.agents = {straightTrack("a", kCarSize, {9.0, 0.0, 0.0}, 2.0, kNow, kNow + 1.0, kNow + 2.0)};
  for (int i = 0; i <= 20; ++i) scene.frame_times.push_back(kNow + 0.5 * i);
  return scene;
}

TEST(DriveOverRecording, ObservesTheFramesAfterNowUpToTheTrajectorysEnd) {
  Witness witness(3.2);
  const auto times = driveOverRecording(witness, recording(), kNow + 0.5);
  ASSERT_EQ(witness.seen().size(), 5u);
  EXPECT_EQ(times.size(), 5u);
  EXPECT_EQ(witness.seen().front().time, kNow + 1.0);
  EXPECT_EQ(witness.seen().back().time, kNow + 3.0);
  EXPECT_NEAR(witness.seen().front().ego.x, 5.0, 1e-9);
}

TEST(FrameAt, HasTheAgentsRecordedThenWithOneState) {
  const Scene scene = recording();
  EXPECT_TRUE(frameAt(scene, kNow + 0.5).agents.empty());
  const Frame frame = frameAt(scene, kNow + 1.5);
  ASSERT_EQ(frame.agents.size(), 1u);
  ASSERT_EQ(frame.agents[0].states.size(), 1u);
  EXPECT_EQ(frame.agents[0].states[0].time, kNow + 1.5);
}

TEST(FrameAt, WithoutAnEgoItsPoseIsNotFinite) {
  EXPECT_FALSE(frameAt(recording(), kNow + 11.0).ego.isFinite());
}

}  // namespace
}  // namespace forge
