#include "collision_forge/study/evaluation/motion_windows.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

constexpr double kBeforeContact = 1.5;  // s

TEST(RecordedWindows, AreAllSequencesOfSevenStates) {
  const Track track = straightTrack("car", kCarSize, {}, 5.0, 0.0, 0.0, 4.5);
  const auto windows = recordedWindows("scene", track);
  ASSERT_EQ(windows.size(), 4u);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    EXPECT_EQ(windows[i].scene, "scene");
    EXPECT_EQ(windows[i].id, "car");
    EXPECT_EQ(windows[i].generated, 0u);
    EXPECT_EQ(windows[i].samples.front().time, track.states[i].time);
    EXPECT_EQ(windows[i].samples.back().time, track.states[i + 6].time);
    EXPECT_EQ(windows[i].samples.back().pose.x, track.states[i + 6].pose.x);
  }
}

TEST(RecordedWindows, DoNotSpanAMissingState) {
  Track track = straightTrack("car", kCarSize, {}, 5.0, 0.0, 0.0, 8.0);
  ASSERT_EQ(track.states.size(), 17u);
  track.states.erase(track.states.begin() + 8);
  const auto windows = recordedWindows("scene", track);
  EXPECT_EQ(windows.size(), 4u);  // two of eight states before the gap, two after it
  for (const MotionWindow& window : windows) {
    EXPECT_NEAR(window.samples.back().time - window.samples.front().time, 3.0, 1e-9);
  }
}

TEST(RecordedWindows, OmitStandingVehicles) {
  EXPECT_EQ(recordedWindows("scene", straightTrack("car", kCarSize, {}, 0.4, 0.0, 0.0, 3.0)).size(),
            1u);
  EXPECT_TRUE(
      recordedWindows("scene", straightTrack("car", kCarSize, {}, 0.3, 0.0, 0.0, 3.0)).empty());
}

/// Recorded on y = 0; the trajectory continues with an offset of 0.2 m.
struct AttackCase {
  Track recorded = pastTrack("attacker", kCarSize, {}, 10.0);
  AttackerTrajectory trajectory = straightDrive({0.0, 0.2, 0.0}, 10.0, 8.0);

  std::optional<MotionWindow> window(double contact) const {
    return attackWindow("scene", recorded, trajectory, kNow + contact, kBeforeContact);
  }
};

TEST(AttackWindow, EndsBeforeTheContact) {
  for (const double contact : {2.0, 3.0, 4.5, 6.0, 7.5}) {
    const auto window = AttackCase().window(contact);
    ASSERT_TRUE(window) << contact;
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
      const WindowSample& sample = window->samples[i];
      EXPECT_NEAR(sample.time, kNow + contact - kBeforeContact - kWindowStep * (6.0 - i), 1e-9)
          << contact;
      EXPECT_NEAR(sample.pose.x, 10.0 * (sample.time - kNow), 1e-6) << contact;
    }
  }
}

TEST(AttackWindow, IsRecordedUpToT0AndGeneratedAfterwards) {
  for (const double contact : {2.0, 3.0, 4.0, 6.0}) {
    const auto window = AttackCase().window(contact);
    ASSERT_TRUE(window) << contact;
    std::size_t generated = 0;
    for (const WindowSample& sample : window->samples) {
      const bool later = sample.time > kNow + 1e-9;
      EXPECT_EQ(sample.pose.y, later ? 0.2 : 0.0) << contact << ", " << sample.time;
      generated += later;
    }
    EXPECT_EQ(window->generated, generated);
  }
}

TEST(AttackWindow, StaysOnTheGridForAContactBetweenSamples) {
  const auto window = AttackCase().window(3.3);
  ASSERT_TRUE(window);
  EXPECT_NEAR(window->samples.back().time, kNow + 1.5, 1e-9);
  EXPECT_NEAR(AttackCase().window(3.49)->samples.back().time, kNow + 1.5, 1e-9);
  EXPECT_NEAR(AttackCase().window(3.5)->samples.back().time, kNow + 2.0, 1e-9);
}

TEST(AttackWindow, IsEmptyWithoutThePast) {
  AttackCase late;
  late.recorded.states.erase(late.recorded.states.begin(), late.recorded.states.end() - 3);
  EXPECT_FALSE(late.window(3.0));  // needs 1.5 s
  EXPECT_TRUE(late.window(3.5));   // needs 1 s
}

}  // namespace
}  // namespace forge
