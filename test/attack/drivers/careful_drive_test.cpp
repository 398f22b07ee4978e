#include "collision_forge/attack/drivers/careful_drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace forge {
namespace {

constexpr double kNow = 100.0;  // s
constexpr double kEnd = 8.0;    // s after t0
const BoxSize kBox{4.3, 1.9};

using PoseAt = std::function<Pose2(double)>;

/// States every 0.1 s from t0 on; `place` gives the pose by the time after t0.
std::vector<AgentState> statesOf(const PoseAt& place, double end = kEnd) {
  std::vector<AgentState> states;
  for (double t = 0.0; t <= end + 1e-9; t += 0.1) {
    const Vector2 step = place(t + 0.05).position() - place(t - 0.05).position();
    states.push_back({kNow + t, place(t), step / 0.1});
  }
  return states;
}

AttackerTrajectory attackerOn(const PoseAt& place) {
  AttackerTrajectory attacker{"a", AgentClass::kCar, kBox, {}};
  for (const AgentState& state : statesOf(place)) {
    attacker.points.push_back({state.time, state.pose, state.velocity.norm(), 0.0, 0.0});
  }
  return attacker;
}

Track egoOn(const PoseAt& place) { return {kEgoId, AgentClass::kCar, kBox, statesOf(place)}; }

PoseAt straight(double speed, double start = 0.0) {
  return [=](double t) { return Pose2{start + speed * t, 0.0, 0.0}; };
}

/// Comes from the left lane into the ego's from 1 s on, at 1 m/s to the side.
PoseAt cutIn(double gap, double speed) {
  return [=](double t) {
    const double aside = 3.5 - std::clamp(t - 1.0, 0.0, 3.5);
    const double yaw = t > 1.0 && t < 4.5 ? std::atan2(-1.0, speed) : 0.0;
    return Pose2{gap + kBox.length + speed * t, aside, yaw};
  };
}

const CarefulDrive& of(const std::vector<CarefulDrive>& drives, DriverModel model) {
  for (const CarefulDrive& drive : drives) {
    if (drive.driver == toString(model)) return drive;
  }
  throw std::logic_error("no drive of this model");
}

TEST(CarefulDrive, AvoidsACutInThatTheRecordedEgoDoesNot) {
  const auto drives = driveCarefully({egoOn(straight(15.0)), {}, {}}, attackerOn(cutIn(22.0, 9.0)));
  ASSERT_EQ(drives.size(), 4u);
  for (const DriverModel model : {DriverModel::kCcDriver, DriverModel::kRss, DriverModel::kFsm}) {
    const CarefulDrive& drive = of(drives, model);
    EXPECT_TRUE(drive.avoids) << drive.driver;
    ASSERT_TRUE(drive.brakes_at) << drive.driver;
    EXPECT_GT(*drive.brakes_at, kNow + 0.7) << drive.driver << ": not before its delay";
    EXPECT_LT(*drive.brakes_at, kNow + 4.0) << drive.driver;
  }
  EXPECT_TRUE(isAvoidedBy(drives, DriverModel::kCcDriver));
  EXPECT_EQ(avoiders({{"rss", true, {}}, {"fsm", false, {}}, {"cc_driver", true, {}}}, ", "),
            "rss, cc_driver");
}

TEST(CarefulDrive, CannotAvoidACutInRightBeforeTheEgo) {
  const auto drives = driveCarefully({egoOn(straight(25.0)), {}, {}}, attackerOn(cutIn(58.0, 5.0)));
  EXPECT_FALSE(of(drives, DriverModel::kCcDriver).avoids);
}

TEST(CarefulDrive, NoDriverBrakesForAFollower) {
  const auto drives =
      driveCarefully({egoOn(straight(5.0)), {}, {}}, attackerOn(straight(12.0, -20.0)));
  for (const CarefulDrive& drive : drives) {
    EXPECT_FALSE(drive.avoids) << drive.driver;
    EXPECT_FALSE(drive.brakes_at) << drive.driver;
  }
}

PoseAt crossing(double speed, double meet) {
  return [=](double t) { return Pose2{40.0, speed * (t - meet), M_PI_2}; };
}

TEST(CarefulDrive, AvoidsAVisibleCrossingVehicle) {
  const auto drives =
      driveCarefully({egoOn(straight(10.0)), {}, {}}, attackerOn(crossing(10.0, 4.0)));
  EXPECT_TRUE(of(drives, DriverModel::kCcDriver).avoids);
  const CarefulDrive& driver = of(drives, DriverModel::kCcDriver);
  ASSERT_TRUE(driver.brakes_at);
  const DriverOptions options;
  EXPECT_NEAR(*driver.brakes_at - kNow,
              3.6 - options.conflict_horizon + options.risk_evaluation + options.cc_delay, 0.3)
      << "3.6 s to the first touch";
}

TEST(CarefulDrive, CannotAvoidACrossingVehicleThatTurnsUpTooLate) {
  const PoseAt hidden = [](double t) {
    return t < 2.6 ? Pose2{40.0, -60.0, M_PI_2} : Pose2{40.0, -14.0 + 10.0 * (t - 2.6), M_PI_2};
  };
  const auto drives = driveCarefully({egoOn(straight(10.0)), {}, {}}, attackerOn(hidden));
  EXPECT_FALSE(of(drives, DriverModel::kCcDriver).avoids);
}

TEST(CarefulDrive, OtherAgentsCountUnlessTheyRunIntoTheEgosRear) {
  const auto drives = [](const PoseAt& other) {
    const Track agent{"b", AgentClass::kCar, kBox, statesOf(other)};
    return driveCarefully({egoOn(straight(15.0)), {agent}, {}}, attackerOn(cutIn(22.0, 9.0)));
  };
  EXPECT_TRUE(of(drives(straight(15.0, -12.0)), DriverModel::kCcDriver).avoids)
      << "a follower does not react";
  const PoseAt across = [](double t) { return Pose2{54.0, 5.0 * (t - 6.0), M_PI_2}; };
  EXPECT_FALSE(of(drives(across), DriverModel::kCcDriver).avoids)
      << "crosses where the recorded ego has been long before";
}

TEST(CarefulDrive, BrakesAtLeastAsHardAsTheRecordedEgo) {
  const PoseAt braking = [](double t) {
    const double moved = std::min(t, 3.0);
    return Pose2{12.0 * moved - 2.0 * moved * moved, 0.0, 0.0};
  };
  const Track queue{"q", AgentClass::kCar, kBox, statesOf([](double) {
                      return Pose2{18.0 + kBox.length + 0.5, 0.0, 0.0};
                    })};
  const auto drives = driveCarefully({egoOn(braking), {queue}, {}}, attackerOn(cutIn(60.0, 4.0)));
  for (const CarefulDrive& drive : drives) EXPECT_TRUE(drive.avoids) << drive.driver;
}

TEST(CarefulDrive, AStandingEgoStays) {
  const PoseAt standing = [](double) { return Pose2{0.0, 0.0, 0.0}; };
  const auto drives = driveCarefully({egoOn(standing), {}, {}}, attackerOn([](double t) {
                                       return Pose2{40.0 - 8.0 * t, 0.0, M_PI};
                                     }));
  for (const CarefulDrive& drive : drives) EXPECT_FALSE(drive.avoids) << drive.driver;
}

TEST(CarefulDrive, IsTheSameForAnEgoThatIsKnownUpToTheContact) {
  Track ego = egoOn(straight(15.0));
  const AttackerTrajectory attacker = attackerOn(cutIn(22.0, 9.0));
  const auto whole = driveCarefully({ego, {}, {}}, attacker);
  while (ego.states.back().time > kNow + 4.0) ego.states.pop_back();
  const auto known = driveCarefully({ego, {}, {}}, attacker);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(whole[i].avoids, known[i].avoids);
    EXPECT_EQ(whole[i].brakes_at, known[i].brakes_at);
  }
}

}  // namespace
}  // namespace forge
