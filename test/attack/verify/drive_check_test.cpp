#include "collision_forge/attack/verify/drive_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

constexpr double kStep = 0.1;
constexpr BoxSize kCar{4.6, 1.9};

const DriveLimitOptions& rows() {
  static const DriveLimitOptions options = shippedOptions().verification.drivable;
  return options;
}

DriveLimits carLimits() { return driveLimitsOf(AgentClass::kCar, kCar, rows()); }

/// Controls of a hand-made single track over time.
struct Controls {
  std::function<double(double)> steering = [](double) { return 0.0; };
  std::function<double(double)> acceleration = [](double) { return 0.0; };
};

/// Integrates the single track in small steps, four seconds long.
std::vector<TrajectoryPoint> driven(const DriveState& start, const Controls& controls,
                                    const DriveLimits& limits) {
  constexpr int kSubsteps = 200;
  constexpr int kSteps = 40;
  std::vector<TrajectoryPoint> points;
  DriveState state = start;
  for (int i = 0; i <= kSteps; ++i) {
    const double begin = i * kStep;
    const Pose2 middle = compose(state.axle, {limits.axle_to_middle, 0.0, 0.0});
    points.push_back({kNow + begin, middle, state.speed, controls.acceleration(begin),
                      std::tan(controls.steering(begin)) / limits.wheelbase});
    for (int j = 0; j < kSubsteps; ++j) {
      const double small = kStep / kSubsteps;
      const double time = begin + (j + 0.5) * small;
      const double speed = state.speed + 0.5 * small * controls.acceleration(time);
      const double turn = speed * std::tan(controls.steering(time)) / limits.wheelbase * small;
      const double yaw = state.axle.yaw + 0.5 * turn;
      state.axle = {state.axle.x + speed * small * std::cos(yaw),
                    state.axle.y + speed * small * std::sin(yaw), state.axle.yaw + turn};
      state.speed += small * controls.acceleration(time);
    }
  }
  return points;
}

DriveState startAt(double speed) {
  DriveState start;
  start.axle = {10.0, -5.0, 0.7};
  start.speed = speed;
  return start;
}

std::string brokenBy(const std::vector<TrajectoryPoint>& points, const DriveState& start,
                     const DriveLimits& limits = carLimits()) {
  const auto broken = findBrokenDrive(points, start, kNow + 10.0, limits);
  return broken ? broken->name : "";
}

double ramp(double time, double rate, double most) { return std::min(most, rate * time); }

TEST(DriveCheck, AcceptsASingleTrackAtItsLimits) {
  const DriveLimits limits = carLimits();
  Controls controls;
  controls.steering = [&](double t) { return ramp(t, limits.max_steering_rate, 0.2); };
  controls.acceleration = [&](double t) { return -ramp(t, limits.max_jerk, 2.0); };
  const DriveState start = startAt(9.0);
  EXPECT_EQ(brokenBy(driven(start, controls, limits), start), "");
}

struct Breach {
  const char* name;
  double speed;
  std::function<double(double)> steering;
  std::function<double(double)> acceleration;
};

TEST(DriveCheck, NamesTheViolatedLimit) {
  const auto zero = [](double) { return 0.0; };
  const Breach breaches[] = {
      {"max_steering_rate", 8.0, [](double t) { return 0.1 * std::sin(6.0 * t); }, zero},
      {"max_steering_angle", 2.0, [](double t) { return ramp(t, 0.38, 0.7); }, zero},
      {"max_lateral_acceleration", 15.0, [](double t) { return ramp(t, 0.3, 0.15); }, zero},
      {"max_forward_acceleration", 4.0, zero, [](double t) { return ramp(t, 15.0, 6.0); }},
      {"max_braking", 35.0, zero, [](double t) { return -ramp(t, 18.0, 9.0); }},
      {"max_jerk", 20.0, zero, [](double t) { return -ramp(std::max(0.0, t - 1.0), 30.0, 6.0); }},
      {"max_speed", 35.0, zero, [](double t) { return ramp(t, 5.0, 1.1); }},
      {"no_reversing", 1.0, zero, [](double t) { return -ramp(t, 5.0, 1.0); }},
  };
  for (const Breach& breach : breaches) {
    const DriveState start = startAt(breach.speed);
    const Controls controls{breach.steering, breach.acceleration};
    EXPECT_EQ(brokenBy(driven(start, controls, carLimits()), start), breach.name);
  }
}

TEST(DriveCheck, PowerLimitsTheAccelerationAtSpeed) {
  Controls controls;
  controls.acceleration = [](double t) { return ramp(t, 10.0, 3.0); };
  const DriveState slow = startAt(2.0);
  EXPECT_EQ(brokenBy(driven(slow, controls, carLimits()), slow), "") << "40 W/kg are 3 m/s2 at 13";
  const DriveState fast = startAt(16.0);
  EXPECT_EQ(brokenBy(driven(fast, controls, carLimits()), fast), "max_forward_acceleration");
}

TEST(DriveCheck, TheWrittenAccelerationKeepsTheForwardLimit) {
  const DriveLimits limits = carLimits();
  Controls controls;
  controls.acceleration = [&](double t) { return ramp(t, 10.0, limits.max_forward_acceleration); };
  const DriveState start = startAt(0.0);
  auto points = driven(start, controls, limits);
  points.resize(16);
  ASSERT_LT(points.back().speed, limits.switching_speed);
  EXPECT_EQ(brokenBy(points, start), "");
  points[10].acceleration += 0.2;  // less than written_acceleration allows
  EXPECT_EQ(brokenBy(points, start), "max_forward_acceleration");
}

TEST(DriveCheck, BusesHaveLowerLimitsThanCars) {
  const BoxSize size{12.0, 2.9};
  const DriveLimits bus = driveLimitsOf(AgentClass::kBus, size, rows());
  Controls controls;
  controls.acceleration = [](double t) { return ramp(t, 5.0, 2.0); };
  const DriveState start = startAt(2.0);
  EXPECT_EQ(brokenBy(driven(start, controls, carLimits()), start), "");
  EXPECT_EQ(brokenBy(driven(start, controls, bus), start, bus), "max_forward_acceleration");
}

TEST(DriveCheck, MotionMustContinueFromItsStart) {
  Controls controls;
  const DriveState start = startAt(10.0);
  const auto points = driven(start, controls, carLimits());
  DriveState other = start;
  other.speed = 9.0;
  EXPECT_EQ(brokenBy(points, other), "continues_speed");
  other = start;
  other.acceleration = -4.0;
  EXPECT_EQ(brokenBy(points, other), "continues_speed");
  other = start;
  other.steering = 0.1;
  EXPECT_EQ(brokenBy(points, other), "max_steering_rate");
  other = start;
  other.axle.x += 0.2;
  EXPECT_EQ(brokenBy(points, other), "continues_pose");
}

TEST(DriveCheck, StoredValuesMustMatchThePoses) {
  const DriveState start = startAt(10.0);
  const auto points = driven(start, {}, carLimits());
  auto changed = points;
  changed[20].speed += 1.0;
  EXPECT_EQ(brokenBy(changed, start), "written_speed");
  changed = points;
  changed[20].acceleration += 1.0;
  EXPECT_EQ(brokenBy(changed, start), "written_acceleration");
  changed = points;
  changed[20].curvature += 0.05;
  EXPECT_EQ(brokenBy(changed, start), "written_curvature");
  changed = points;
  changed[20].pose.x = std::nan("");
  EXPECT_EQ(brokenBy(changed, start), "finite");
}

TEST(DriveCheck, ABoxThatTurnsAboutItsCentreSlips) {
  const DriveState start = startAt(8.0);
  Controls controls;
  controls.steering = [](double t) { return ramp(t, 0.3, 0.2); };
  const DriveLimits limits = carLimits();
  auto points = driven(start, controls, limits);
  // The same path with the rear axle where the middle should be.
  for (TrajectoryPoint& point : points) {
    point.pose = compose(point.pose, {-limits.axle_to_middle, 0.0, 0.0});
  }
  DriveState behind = start;
  behind.axle = compose(start.axle, {-limits.axle_to_middle, 0.0, 0.0});
  EXPECT_EQ(brokenBy(points, behind), "no_slip");
}

TEST(DriveLimits, PickUpsAreVansAndLongTrucksPullTrailers) {
  const auto row = [](AgentClass agent_class, double length) {
    return std::string(toString(vehicleClassOf(agent_class, {length, 2.0}, rows())));
  };
  EXPECT_EQ(row(AgentClass::kCar, 4.6), "car");
  EXPECT_EQ(row(AgentClass::kCar, 6.0), "van");
  EXPECT_EQ(row(AgentClass::kTruck, 5.5), "van");
  EXPECT_EQ(row(AgentClass::kTruck, 8.0), "truck");
  EXPECT_EQ(row(AgentClass::kTruck, 16.0), "articulated");
  EXPECT_EQ(row(AgentClass::kBus, 12.0), "bus");
  EXPECT_EQ(row(AgentClass::kEmergencyVehicle, 6.0), "emergency");
  EXPECT_EQ(row(AgentClass::kConstructionVehicle, 7.0), "construction");
  EXPECT_EQ(row(AgentClass::kMotorcycle, 2.1), "motorcycle");
}

TEST(DriveLimits, StateOfARecordedMotion) {
  const DriveLimits limits = carLimits();
  const DriveState state = driveStateOf(Motion{{1.0, 2.0, 0.0}, 10.0, -1.0, 0.1}, limits);
  EXPECT_NEAR(state.axle.x, 1.0 - limits.axle_to_middle, 1e-12);
  EXPECT_EQ(state.speed, 10.0);
  EXPECT_EQ(state.acceleration, -1.0);
  EXPECT_NEAR(state.steering, std::atan(limits.wheelbase * 0.01), 1e-12);
  const DriveState braking = driveStateOf(Motion{{}, 20.0, -30.0, 0.0}, limits);
  EXPECT_EQ(braking.acceleration, -limits.max_braking);
  const DriveState wild = driveStateOf(Motion{{}, 20.0, -30.0, 2.0}, limits);
  EXPECT_NEAR(std::hypot(wild.acceleration, limits.max_lateral_acceleration), limits.max_braking,
              1e-9);
  EXPECT_NEAR(std::tan(wild.steering) * 400.0 / limits.wheelbase, limits.max_lateral_acceleration,
              1e-9);
  const DriveState standing = driveStateOf(Motion{{}, 0.3, 1.0, 0.5}, limits);
  EXPECT_EQ(standing.speed, 0.0);
  EXPECT_EQ(standing.steering, 0.0);
}

}  // namespace
}  // namespace forge
