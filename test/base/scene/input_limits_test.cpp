#include "collision_forge/base/scene/input_limits.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>

#include "base/scene/shipped_limits.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string errorOf(const std::function<void()>& check) {
  try {
    check();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

Track car(const std::string& id) {
  return {id,
          AgentClass::kCar,
          {4.0, 2.0},
          {{10.0, {1.0, 2.0, 0.0}, {5.0, 0.0}}, {10.5, {3.5, 2.0, 0.0}, {5.0, 0.0}}}};
}

LaneMap oneLane() {
  LaneMap map;
  Lane lane;
  lane.id = "a";
  lane.centerline = {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}};
  lane.polygon = {{0.0, -2.0}, {10.0, -2.0}, {10.0, 2.0}};
  map.lanes = {lane};
  map.drivable_area = {{{{0.0, -2.0}, {10.0, -2.0}, {10.0, 2.0}}, {}}};
  return map;
}

Scene scene() {
  Scene scene;
  scene.ego = car(kEgoId);
  scene.agents = {car("a"), car("b"), car("c")};
  scene.frame_times = {10.0, 10.5};
  scene.map = std::make_shared<const LaneMap>(oneLane());
  return scene;
}

AttackerTrajectory trajectory() {
  AttackerTrajectory trajectory{"a", AgentClass::kCar, {4.0, 2.0}, {}, car("a").states};
  trajectory.points = {{10.5, {3.5, 2.0, 0.0}, 5.0}, {10.6, {4.0, 2.0, 0.0}, 5.0}};
  return trajectory;
}

std::string errorOfMap(const std::function<void(LaneMap&)>& spoil) {
  LaneMap map = oneLane();
  spoil(map);
  return errorOf([&] { checkMap(map, shippedLimits(), "town"); });
}

std::string errorOfScene(const std::function<void(Scene&)>& spoil) {
  Scene spoilt = scene();
  spoil(spoilt);
  return errorOf([&] { checkScene(spoilt, shippedLimits(), "log"); });
}

std::string errorOfTrajectory(const std::function<void(AttackerTrajectory&)>& spoil) {
  AttackerTrajectory spoilt = trajectory();
  spoil(spoilt);
  return errorOf([&] { checkTrajectory(spoilt, shippedLimits(), "attack"); });
}

TEST(InputLimits, ErrorsInMapsNameThePoint) {
  EXPECT_EQ(errorOfMap([](LaneMap& map) { map.lanes[0].centerline[1].x = 1e9; }),
            "town: lane \"a\": centerline[1].x = 1000000000 is outside -100000 to 100000, "
            "max_coordinate in input_limits.yaml");
  EXPECT_EQ(errorOfMap([](LaneMap& map) { map.lanes[0].centerline[0].yaw = kNan; }),
            "town: lane \"a\": centerline[0].yaw = nan is not finite");
  EXPECT_THAT(errorOfMap([](LaneMap& map) { map.lanes[0].polygon[2].y() = -100001.0; }),
              StartsWith("town: lane \"a\": polygon[2].y = -100001 is"));
  EXPECT_THAT(errorOfMap([](LaneMap& map) { map.drivable_area[0].exterior[0].x() = kNan; }),
              StartsWith("town: drivable_area[0].exterior[0].x = nan is"));
  EXPECT_THAT(errorOfMap([](LaneMap& map) { map.lanes[0].speed_limit = 1e3; }),
              StartsWith("town: lane \"a\": speed_limit = 1000 is outside 0 to 150, max_speed in "
                         "input_limits.yaml"));
}

TEST(InputLimits, ChecksEgoAndFramesOfAScene) {
  EXPECT_EQ(errorOfScene([](Scene& scene) { scene.ego.states[1].pose.y = -1.6e5; }),
            "log: ego: states[1].y = -160000 is outside -100000 to 100000, max_coordinate in "
            "input_limits.yaml");
  EXPECT_THAT(errorOfScene([](Scene& scene) { scene.ego.states[1].velocity.x() = 200.0; }),
              StartsWith("log: ego: states[1].speed = 200 is outside 0 to 150"));
  EXPECT_THAT(errorOfScene([](Scene& scene) { scene.ego.states[0].time = 11.0; }),
              StartsWith("log: ego: states[1].time = 10.5 is not after 11"));
  EXPECT_THAT(errorOfScene([](Scene& scene) { scene.ego.size.length = 0.0; }),
              StartsWith("log: ego.length = 0 is outside 0.1 to 50"));
  EXPECT_THAT(errorOfScene([](Scene& scene) { scene.frame_times[0] = -1.0; }),
              StartsWith("log: frames[0].time = -1 is outside 0 to 4294967295"));
  EXPECT_THAT(
      errorOfScene([](Scene& scene) { scene.agents.resize(20001); }),
      StartsWith(
          "log: agents: 20001 is above the limit of 20000, max_agents in input_limits.yaml"));
  EXPECT_THAT(errorOfScene([](Scene& scene) {
                LaneMap map = oneLane();
                map.lanes[0].centerline[1].x = 1e9;
                scene.map = std::make_shared<const LaneMap>(map);
              }),
              StartsWith("log: lane \"a\""));
}

TEST(InputLimits, StampsOfAnotherUnitOrClockAreAnError) {
  const auto everyStates = [](Scene& scene, double interval) {
    scene.ego.states.resize(4, scene.ego.states.front());
    for (int i = 0; i < 4; ++i) scene.ego.states[i].time = 10.0 + interval * i;
  };
  EXPECT_THAT(errorOfScene([&](Scene& scene) { everyStates(scene, 50.0); }),
              StartsWith("log: ego: the median interval of its states, 50 s, is outside 0.0002 to "
                         "1.1 s: check the unit of the stamps"));
  EXPECT_THAT(errorOfScene([&](Scene& scene) { everyStates(scene, 5e-5); }), HasSubstr("the unit"));
  EXPECT_EQ(errorOfScene([&](Scene& scene) { everyStates(scene, 1.0); }), "");
  EXPECT_EQ(
      errorOfScene([](Scene& scene) {
        scene.frame_times = {1000.0, 1000.5};
      }),
      "log: stamps of agents (1000 to 1000.5 s) and of the ego (10 to 10.5 s) do not overlap: "
      "both must have one clock");
}

TEST(InputLimits, RemovesAgentsBeyondTheLimitsWithAWarningPerKind) {
  Scene spoilt = scene();
  spoilt.agents.push_back(car("d"));
  spoilt.agents[0].size.width = 0.05;
  spoilt.agents[1].states[0].pose.x = kNan;
  spoilt.agents[3].size.length = 51.0;
  std::vector<std::string> warnings;
  checkScene(spoilt, shippedLimits(), "log", &warnings);
  ASSERT_EQ(spoilt.agents.size(), 1u);
  EXPECT_EQ(spoilt.agents[0].id, "c");
  EXPECT_THAT(warnings,
              ElementsAre("2 agents with a box beyond the input limits left out (first: a)",
                          "1 agents with a motion beyond the input limits left out (first: b)"));
}

TEST(InputLimits, ChecksSnapshotsAndFutures) {
  Snapshot snapshot{10.5, car(kEgoId), {car("a"), car("b")}, nullptr};
  snapshot.agents[0].states[1].pose.x = 1e9;
  EXPECT_NO_THROW(checkSnapshot(snapshot, shippedLimits(), "scene"));
  ASSERT_EQ(snapshot.agents.size(), 1u);
  EXPECT_EQ(snapshot.agents[0].id, "b");
  snapshot.ego.states[1].pose.x = 1e9;
  EXPECT_THAT(errorOf([&] { checkSnapshot(snapshot, shippedLimits(), "scene"); }),
              StartsWith("scene: ego: states[1].x = 1000000000 is outside"));
  Future future{car(kEgoId), {car("a")}, {car(kEgoId)}};
  future.agents[0].size.width = 1e9;
  EXPECT_NO_THROW(checkFuture(future, shippedLimits(), "future"));
  EXPECT_TRUE(future.agents.empty());
  future.ego_samples[0].states[0].time = kNan;
  EXPECT_THAT(errorOf([&] { checkFuture(future, shippedLimits(), "future"); }),
              StartsWith("future: ego_samples[0]: states[0].time = nan is outside"));
}

TEST(InputLimits, RejectsAFutureWithoutStatesOfTheEgo) {
  Future future{car(kEgoId), {car("a"), car("b")}, {car(kEgoId), car(kEgoId)}};
  future.agents[0].states.clear();
  EXPECT_NO_THROW(checkFuture(future, shippedLimits(), "future"));
  ASSERT_EQ(future.agents.size(), 1u);
  EXPECT_EQ(future.agents[0].id, "b");
  future.ego_samples[1].states.clear();
  EXPECT_EQ(errorOf([&] { checkFuture(future, shippedLimits(), "future"); }),
            "future: ego_samples[1]: states is empty");
  future.ego.states.clear();
  EXPECT_EQ(errorOf([&] { checkFuture(future, shippedLimits(), "future"); }),
            "future: ego: states is empty");
}

TEST(InputLimits, ErrorsInTrajectoriesNamePointAndField) {
  EXPECT_EQ(errorOfTrajectory([](auto& spoilt) { spoilt.size.length = 1e9; }),
            "attack: attacker \"a\": size.length = 1000000000 is outside 0.1 to 50");
  EXPECT_THAT(errorOfTrajectory([](auto& spoilt) { spoilt.points.clear(); }),
              HasSubstr("points is empty"));
  EXPECT_THAT(errorOfTrajectory([](auto& spoilt) { spoilt.points.resize(5001); }),
              HasSubstr("points: 5001 is above the limit of 5000"));
  EXPECT_THAT(errorOfTrajectory([](auto& spoilt) { spoilt.points[1].time = 80.0; }),
              HasSubstr("points[1].time from the first point = 69.5 is outside 0 to 60"));
  EXPECT_THAT(errorOfTrajectory([](auto& spoilt) { spoilt.points[1].time = 10.5; }),
              HasSubstr("points[1].time = 10.5 is not after 10.5"));
  EXPECT_THAT(errorOfTrajectory([](auto& spoilt) { spoilt.points[1].pose.yaw = INFINITY; }),
              HasSubstr("points[1].yaw = inf is not finite"));
  EXPECT_THAT(errorOfTrajectory([](auto& spoilt) { spoilt.points[0].curvature = kNan; }),
              HasSubstr("points[0] is not finite"));
  EXPECT_THAT(errorOfTrajectory([](auto& spoilt) { spoilt.past[1].pose.x = 1e9; }),
              HasSubstr("past[1].x = 1000000000 is outside"));
}

TEST(InputLimits, PatternsMustBeWithinTheLimits) {
  const CollisionPattern good{CollisionType::kRearEnd, "a", 12.0, {{1.0, 2.0, 0.0}, {4.0, 2.0}},
                              {-4.0, 0.0, 0.0},        5.0};
  EXPECT_NO_THROW(checkPattern(good, shippedLimits(), "answer"));
  CollisionPattern pattern = good;
  pattern.attacker_speed = kNan;
  EXPECT_THAT(errorOf([&] { checkPattern(pattern, shippedLimits(), "answer"); }),
              StartsWith("answer: pattern attacker_speed = nan is outside -150 to 150"));
  pattern = good;
  pattern.ego.size.width = 0.0;
  EXPECT_THAT(errorOf([&] { checkPattern(pattern, shippedLimits(), "answer"); }),
              StartsWith("answer: pattern ego.width = 0 is outside"));
}

TEST(InputLimits, PlansMustHaveFewPointsNearby) {
  std::vector<TrajectoryPoint> plan(5000);
  plan[7].pose.x = kNan;
  EXPECT_EQ(errorOf([&] { checkPlan(plan, shippedLimits(), "plan"); }), "");
  plan[3].pose.y = -1.6e5;
  EXPECT_EQ(errorOf([&] { checkPlan(plan, shippedLimits(), "plan"); }),
            "plan: points[3].y = -160000 is outside -100000 to 100000, max_coordinate in "
            "input_limits.yaml");
  plan.emplace_back();
  EXPECT_EQ(errorOf([&] { checkPlan(plan, shippedLimits(), "plan"); }),
            "plan: points: 5001 is above the limit of 5000");
}

}  // namespace
}  // namespace forge
