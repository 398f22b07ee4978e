#include "collision_forge/study/motion_windows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/test_scenes.h"
#include "study/test_windows.h"

namespace forge {
namespace {

const MotionOptions kOptions = shippedScorecardOptions().motion;

double timeOf(std::size_t sample) { return kWindowStep * (static_cast<double>(sample) - 3.0); }

/// x, y and yaw as cubics in the time from the middle, from the power 0 up.
MotionWindow cubicWindow(const double (&x)[4], const double (&y)[4], const double (&yaw)[4]) {
  MotionWindow window{"scene", "car", AgentClass::kCar, kCarSize, {}, 0};
  const auto value = [](const double(&c)[4], double t) {
    return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
  };
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const double t = timeOf(i);
    window.samples[i] = {50.0 + t, {value(x, t), value(y, t), wrapAngle(value(yaw, t))}};
  }
  return window;
}

TEST(MotionOf, KnownCubicIsFound) {
  // Over the jump of the yaw at pi.
  const double x[4] = {1000.0, -6.0, 0.7, 0.2}, y[4] = {-500.0, 4.0, -0.3, 0.1},
               yaw[4] = {M_PI, 0.3, -0.2, 0.05};
  const WindowMotion motion = motionOf(cubicWindow(x, y, yaw), kOptions);
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const double t = timeOf(i);
    const Vector2 velocity(-6.0 + 1.4 * t + 0.6 * t * t, 4.0 - 0.6 * t + 0.3 * t * t);
    const Vector2 acceleration(1.4 + 1.2 * t, -0.6 + 0.6 * t);
    const Vector2 jerk(1.2, 0.6);
    const Vector2 ahead = velocity.normalized();
    EXPECT_NEAR(motion[i].speed, velocity.norm(), 1e-8);
    EXPECT_NEAR(motion[i].acceleration, acceleration.dot(ahead), 1e-8);
    EXPECT_NEAR(motion[i].jerk, jerk.dot(ahead), 1e-8);
    EXPECT_NEAR(motion[i].yaw_rate, 0.3 - 0.4 * t + 0.15 * t * t, 1e-8);
    EXPECT_NEAR(motion[i].yaw_acceleration, -0.4 + 0.3 * t, 1e-8);
    EXPECT_NEAR(motion[i].lateral_acceleration, velocity.norm() * motion[i].yaw_rate, 1e-8);
  }
}

TEST(MotionOf, UnevenSamplesAreFittedAtTheirOwnTimes) {
  MotionWindow window = simpleWindow("scene", 8.0, 0.0);
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const double t = timeOf(i) + (i % 2 == 0 ? 0.05 : -0.05);
    window.samples[i] = {100.0 + t, {8.0 * t, 0.0, 0.0}};
  }
  for (const MotionState& state : motionOf(window, kOptions)) {
    EXPECT_NEAR(state.speed, 8.0, 1e-9);
    EXPECT_NEAR(state.acceleration, 0.0, 1e-9);
  }
}

TEST(MotionOf, SteeringIsThatOfTheSingleTrack) {
  // v = 8 + t, yaw rate .3 + .1 t.
  const double x[4] = {0.0, 8.0, 0.5, 0.0}, y[4] = {}, yaw[4] = {0.0, 0.3, 0.05, 0.0};
  const double wheelbase = kOptions.wheelbase_share * kCarSize.length;
  const auto angle = [&](double t) { return std::atan(wheelbase * (0.3 + 0.1 * t) / (8.0 + t)); };
  const WindowMotion motion = motionOf(cubicWindow(x, y, yaw), kOptions);
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const double t = timeOf(i), h = 1e-5;
    ASSERT_TRUE(motion[i].steering);
    EXPECT_NEAR(motion[i].steering->angle, angle(t), 1e-9);
    EXPECT_NEAR(motion[i].steering->rate, (angle(t + h) - angle(t - h)) / (2.0 * h), 1e-7);
  }
}

TEST(MotionOf, SlowVehiclesHaveNoSteering) {
  const double slow = 0.9 * kOptions.min_steering_speed;
  EXPECT_FALSE(motionOf(simpleWindow("scene", slow, 0.0), kOptions)[3].steering);
  EXPECT_TRUE(motionOf(simpleWindow("scene", slow + 1.0, 0.0), kOptions)[3].steering);
}

TEST(RecordedWindows, AreAllRunsOfSevenStates) {
  const Track track = straightTrack("car", kCarSize, {}, 5.0, 0.0, 0.0, 4.5);
  const auto windows = recordedWindows("scene", track, kOptions);
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
  const auto windows = recordedWindows("scene", track, kOptions);
  EXPECT_EQ(windows.size(), 4u);  // two of eight states before the gap, two after it
  for (const MotionWindow& window : windows) {
    EXPECT_NEAR(window.samples.back().time - window.samples.front().time, 3.0, 1e-9);
  }
}

TEST(RecordedWindows, LeaveOutWhoIsSlowAtASample) {
  Track track = straightTrack("car", kCarSize, {}, 5.0, 0.0, 0.0, 3.0);
  EXPECT_EQ(recordedWindows("scene", track, kOptions).size(), 1u);
  for (AgentState& state : track.states) {  // 5 m/s to 0.8 m/s, evenly
    const double t = state.time;
    state.pose.x = 5.0 * t - 0.7 * t * t;
  }
  EXPECT_TRUE(recordedWindows("scene", track, kOptions).empty());
}

TEST(RecordedWindows, LeaveOutWhoCannotAttack) {
  Track track = straightTrack("walker", kCarSize, {}, 5.0, 0.0, 0.0, 3.0);
  track.agent_class = AgentClass::kPedestrian;
  EXPECT_TRUE(recordedWindows("scene", track, kOptions).empty());
}

/// Recorded on y = 0; made to drive on 0.2 m beside it.
struct AttackCase {
  Track recorded = pastTrack("attacker", kCarSize, {}, 10.0);
  AttackerTrajectory trajectory = straightDrive({0.0, 0.2, 0.0}, 10.0, 8.0);

  std::optional<MotionWindow> window(double contact) const {
    return attackWindow("scene", recorded, trajectory, kNow + contact, kOptions);
  }
};

TEST(AttackWindow, LastsUntilAWhileBeforeTheContact) {
  for (const double contact : {2.0, 3.0, 4.5, 6.0, 7.5}) {
    const auto window = AttackCase().window(contact);
    ASSERT_TRUE(window) << contact;
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
      const WindowSample& sample = window->samples[i];
      EXPECT_NEAR(sample.time, kNow + contact - 1.5 - kWindowStep * (6.0 - i), 1e-9) << contact;
      EXPECT_NEAR(sample.pose.x, 10.0 * (sample.time - kNow), 1e-6) << contact;
    }
  }
}

TEST(AttackWindow, IsRecordedUpToNowAndGeneratedAfterIt) {
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

TEST(AttackWindow, StaysOnTheGridOfTheRecordingWhenTheContactIsBetween) {
  const auto window = AttackCase().window(3.3);
  ASSERT_TRUE(window);
  EXPECT_NEAR(window->samples.back().time, kNow + 1.5, 1e-9);
  EXPECT_NEAR(AttackCase().window(3.49)->samples.back().time, kNow + 1.5, 1e-9);
  EXPECT_NEAR(AttackCase().window(3.5)->samples.back().time, kNow + 2.0, 1e-9);
}

TEST(AttackWindow, IsEmptyWhereThePastIsMissing) {
  AttackCase late;
  late.recorded.states.erase(late.recorded.states.begin(), late.recorded.states.end() - 3);
  EXPECT_FALSE(late.window(3.0));  // needs 1.5 s
  EXPECT_TRUE(late.window(3.5));   // needs 1 s
}

TEST(AttackWindow, IsEmptyWhereNothingIsGenerated) {
  EXPECT_FALSE(AttackCase().window(1.9));
  AttackCase none;
  none.trajectory.points.clear();
  EXPECT_FALSE(none.window(4.0));
}

TEST(AttackWindow, IsEmptyForWhoStands) {
  AttackCase standing;
  standing.recorded = pastTrack("attacker", kCarSize, {}, 0.0);
  standing.trajectory = straightDrive({}, 0.0, 8.0);
  EXPECT_FALSE(standing.window(4.0));
}

/// At even times what a cubic cannot follow: the binomials of the order six, with changing signs.
constexpr double kBeyondCubic[kWindowSamples] = {1, -6, 15, -20, 15, -6, 1};

/// A drive towards the upper left whose positions are `size` times that to its left.
MotionWindow zigzag(double size) {
  MotionWindow window = simpleWindow("scene", 8.0, 1.0);
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    Pose2& pose = window.samples[i].pose;
    pose = compose({5.0, 7.0, 2.0}, compose(pose, {0.0, size * kBeyondCubic[i], 0.0}));
  }
  return window;
}

TEST(FitResiduals, AreWhatACubicCannotFollow) {
  const auto residuals = fitResiduals(zigzag(0.01));
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    EXPECT_NEAR(residuals[i].x(), 0.0, 1e-9);
    EXPECT_NEAR(residuals[i].y(), 0.01 * kBeyondCubic[i], 1e-9);
  }
}

TEST(WithRecordedNoise, MovesTheGeneratedSamplesAlone) {
  MotionWindow window = simpleWindow("scene", 8.0, 0.0, 0.1);
  window.generated = 3;
  std::mt19937_64 generator(1);
  const auto noisy = withRecordedNoise({window}, {zigzag(0.01)}, generator);
  ASSERT_EQ(noisy.size(), 1u);
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const Pose2 moved = relativeTo(window.samples[i].pose, noisy[0].samples[i].pose);
    EXPECT_NEAR(moved.yaw, 0.0, 1e-12);
    EXPECT_NEAR(moved.x, 0.0, 1e-9);
    EXPECT_EQ(std::abs(moved.y) > 1e-3, i >= 4) << i;
  }
}

TEST(WithRecordedNoise, IsAsLargeAsThatOfTheRecording) {
  constexpr std::uint64_t kSeed = 2;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 generator(kSeed);
  std::normal_distribution<double> along(0.0, 0.2), across(0.0, 0.05);
  std::vector<MotionWindow> recorded;
  const MotionWindow smooth = simpleWindow("scene", 8.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    recorded.push_back(smooth);
    for (WindowSample& sample : recorded.back().samples) {
      sample.pose.x += along(generator);
      sample.pose.y += across(generator);
    }
  }
  Vector2 squares(0.0, 0.0);
  const std::vector<MotionWindow> attacks(2000, smooth);
  for (const MotionWindow& noisy : withRecordedNoise(attacks, recorded, generator)) {
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
      const Pose2 moved = relativeTo(smooth.samples[i].pose, noisy.samples[i].pose);
      squares += moved.position().cwiseAbs2() / (2000.0 * kWindowSamples);
    }
  }
  EXPECT_NEAR(std::sqrt(squares.x()), 0.2, 0.01);
  EXPECT_NEAR(std::sqrt(squares.y()), 0.05, 0.0025);
}

TEST(WithRecordedNoise, AddsNothingWithoutARecording) {
  std::mt19937_64 generator(3);
  const MotionWindow window = simpleWindow("scene", 8.0, 0.0);
  EXPECT_EQ(withRecordedNoise({window}, {}, generator)[0].samples[6].pose.x,
            window.samples[6].pose.x);
}

}  // namespace
}  // namespace forge
