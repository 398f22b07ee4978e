#include "collision_forge/attack/search/added_vehicle.h"

#include <gtest/gtest.h>

#include <string>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/realizer.h"

namespace forge {
namespace {

/// Twelve seconds at 2 Hz up to kNow.
Track longPast(const std::string& id, const BoxSize& size, const Pose2& now, double speed) {
  return straightTrack(id, size, now, speed, kNow, kNow - 12.0, kNow);
}

/// The ego alone, eastbound at 8 m/s through a junction of two lanes each way.
struct Case {
  AttackOptions options = shippedOptions();
  std::shared_ptr<LaneMap> map = fourWayJunction();
  Pose2 ego{-40.0, -1.75, 0.0};
  double speed = 8.0;
  std::vector<Track> others;  // up to now
  bool live = false;
  CollisionRequest request = believableRequestFor(CollisionType::kRearEnd);

  Snapshot past() const { return snapshotOf(longPast(kEgoId, kEgoSize, ego, speed), others, map); }
  Snapshot snapshot() const {
    return snapshotOf(pastTrack(kEgoId, kEgoSize, ego, speed), others, map);
  }
  Future future() const {
    Future future;
    future.ego = futureTrack(kEgoId, kEgoSize, ego, speed);
    return future;
  }
  AddedVehicles vehicles() const {
    const Snapshot all = past();
    const Snapshot now = snapshot();
    return addVehicles({now, live ? nullptr : &all, future(), request, LaneIndex(map)}, options);
  }
  Realization resultIn(const Future& known,
                       SearchedMotion motion = SearchedMotion::kByRoutes) const {
    const Snapshot all = past();
    const Snapshot now = snapshot();
    const LaneIndex lanes(map);
    const AddedVehicleInput input{now, live ? nullptr : &all, known, request, lanes};
    return realizeByAdded(addVehicles(input, options), input, options, SearchRealizer(options),
                          motion);
  }
  Realization result() const { return resultIn(future()); }
};

/// Rejects every task and counts the calls.
class CountingRealizer : public TrajectoryRealizer {
 public:
  Realization realize(const RealizationTask&) const override {
    ++calls;
    return declined({StatusCode::kNoAttackWithinLimits, "is only counted"});
  }
  mutable int calls = 0;
};

TEST(AddedVehicle, AllCarsAreRealisedInOneCall) {
  Case scene;
  scene.request.type = CollisionType::kRearEnd;
  const Snapshot all = scene.past();
  const Snapshot now = scene.snapshot();
  const Future known = scene.future();
  const LaneIndex lanes(scene.map);
  const AddedVehicleInput input{now, &all, known, scene.request, lanes};
  const AddedVehicles vehicles = addVehicles(input, scene.options);
  ASSERT_GT(vehicles.found.size(), 3u);
  ASSERT_TRUE(isCarLike(vehicles.found.back().track.agent_class));
  const CountingRealizer realizer;
  realizeByAdded(vehicles, input, scene.options, realizer, SearchedMotion::kByRoutes);
  EXPECT_EQ(realizer.calls, 1);
}

TEST(AddedVehicle, HitsAnEgoWithoutOtherTrafficAsRequested) {
  Case scene;
  for (const CollisionType type : {CollisionType::kRearEnd, CollisionType::kOppositeDirection,
                                   CollisionType::kJunctionCrossing}) {
    scene.request.type = type;
    // The ego is in the middle of the junction 5 s from now.
    scene.request.tta = type == CollisionType::kJunctionCrossing ? 5.0 : 3.0;
    const Realization answer = scene.result();
    ASSERT_EQ(answer.status.code, StatusCode::kOk)
        << toString(type) << ": " << answer.status.message;
    EXPECT_TRUE(isAsAsked(answer.report, scene.request)) << toString(type);
    EXPECT_TRUE(answer.trajectory.isAdded());
    EXPECT_EQ(answer.trajectory.past.back().time, kNow);
    const Pose2& now = answer.trajectory.points.front().pose;
    EXPECT_NEAR(answer.trajectory.past.back().pose.x, now.x, 1e-6);
    EXPECT_NEAR(answer.trajectory.past.back().pose.y, now.y, 1e-6);
  }
}

TEST(AddedVehicle, PullsOutWhereTheEgoHasTheOnlyLane) {
  Case scene;
  scene.map = twoLaneRoad();
  scene.map->drivable_area.push_back(rectangle(-200.0, -5.25, 200.0, -1.0));
  scene.ego = {-40.0, 0.0, 0.0};
  scene.request = believableRequestFor(CollisionType::kLaneChange);
  const Realization answer = scene.result();
  ASSERT_EQ(answer.status.code, StatusCode::kOk) << answer.status.message;
  for (const AgentState& state : answer.trajectory.past) {
    EXPECT_NEAR(state.pose.x, answer.trajectory.past.back().pose.x, 1e-6) << "is parked";
  }
}

TEST(AddedVehicle, UsesAMotorcycleWhereNoCarCanPark) {
  Case scene;
  scene.map = twoLaneRoad();
  scene.ego = {-40.0, 0.0, 0.0};
  scene.request = believableRequestFor(CollisionType::kLaneChange);
  const Realization answer = scene.result();
  ASSERT_EQ(answer.status.code, StatusCode::kOk) << answer.status.message;
  EXPECT_EQ(answer.trajectory.agent_class, AgentClass::kMotorcycle);
  EXPECT_EQ(answer.report.manoeuvre, Manoeuvre::kDrift);
  EXPECT_GE(answer.effort, kRidingCost);
  scene.request.attacker_class = AgentClass::kMotorcycle;
  const Realization asked = scene.result();
  ASSERT_EQ(asked.status.code, StatusCode::kOk) << asked.status.message;
  EXPECT_EQ(asked.trajectory.agent_class, AgentClass::kMotorcycle);
  scene.request.attacker_class = AgentClass::kBus;
  scene.request.manoeuvre = Manoeuvre::kDrift;
  EXPECT_EQ(scene.result().status.code, StatusCode::kNoCandidate) << "too wide";
}

TEST(AddedVehicle, DrivesTheWrongWayOnRequest) {
  Case scene;
  scene.map = emptyMap();
  scene.map->lanes = {straightLane("one_way", {-200.0, 0.0}, {200.0, 0.0})};
  scene.ego = {-40.0, 0.0, 0.0};
  scene.request = believableRequestFor(CollisionType::kOppositeDirection);
  EXPECT_EQ(scene.result().status.code, StatusCode::kRoadDoesNotAllow) << "nobody comes there";
  scene.request.manoeuvre = Manoeuvre::kWrongWay;
  const Realization answer = scene.result();
  ASSERT_EQ(answer.status.code, StatusCode::kOk) << answer.status.message;
  EXPECT_TRUE(isAsAsked(answer.report, scene.request));
  EXPECT_TRUE(answer.report.believable()) << answer.report.unbelievable;
  EXPECT_EQ(answer.report.road.wrong_way, 1.0) << "is told as it is";
  EXPECT_EQ(answer.report.road.on_lane, 0.0);
  for (const AgentState& state : answer.trajectory.past) {
    EXPECT_NEAR(std::abs(state.pose.yaw), M_PI, 0.2);
    EXPECT_NEAR(state.pose.y, 0.0, 1.0) << "keeps to the lane";
  }
}

TEST(AddedVehicle, HasAPastAtAllFramesUpToNow) {
  const Case scene;
  const AddedVehicles vehicles = scene.vehicles();
  ASSERT_FALSE(vehicles.found.empty()) << vehicles.status.message;
  const std::vector<AgentState> frames = scene.past().ego.states;
  EXPECT_EQ(vehicles.found.front().track.states.size(), frames.size()) << "from the first on";
  for (const AddedVehicle& vehicle : vehicles.found) {
    const std::vector<AgentState>& states = vehicle.track.states;
    ASSERT_LE(states.size(), frames.size());
    EXPECT_GE(kNow - states.front().time, scene.options.added.least_past);
    for (std::size_t i = 1; i <= states.size(); ++i) {
      EXPECT_EQ(states[states.size() - i].time, frames[frames.size() - i].time);
    }
    EXPECT_FALSE(vehicle.patterns.empty());
    for (const CollisionPattern& pattern : vehicle.patterns) {
      EXPECT_EQ(pattern.attacker_id, vehicle.track.id);
    }
  }
}

TEST(AddedVehicle, TouchesNoRecordedAgent) {
  Case scene;
  // An agent stands in the lane behind the ego, where followers would come from.
  scene.others = {longPast("standing", kCarSize, {-70.0, -1.75, 0.0}, 0.0)};
  const Snapshot past = scene.past();
  const AddedVehicles vehicles = scene.vehicles();
  ASSERT_FALSE(vehicles.found.empty()) << vehicles.status.message;
  for (const AddedVehicle& vehicle : vehicles.found) {
    for (double time = vehicle.track.states.front().time; time < kNow; time += 0.05) {
      const auto state = stateAt(vehicle.track, time);
      ASSERT_TRUE(state);
      for (const Track* other : {&past.ego, &past.agents.front()}) {
        EXPECT_FALSE(
            overlaps(boxAt(vehicle.track, state->pose), boxAt(*other, stateAt(*other, time)->pose)))
            << vehicle.track.id << " " << vehicle.track.size.length << " at " << state->pose.x
            << ", " << state->pose.y << " yaw " << state->pose.yaw << " touches " << other->id
            << " " << time - kNow << " s from now, known from "
            << vehicle.track.states.front().time - kNow;
      }
    }
  }
}

TEST(AddedVehicle, NeverAppearsInTheEgosView) {
  Case scene;
  // Lanes begin 45 m behind the ego: a follower did not exist at the first frame.
  scene.map->lanes[0] = straightLane("east_in", {-85.0, -1.75}, {-10.0, -1.75}, {"east_through"});
  const Snapshot past = scene.past();
  const AddedVehicles vehicles = scene.vehicles();
  ASSERT_FALSE(vehicles.found.empty()) << vehicles.status.message;
  for (const AddedVehicle& vehicle : vehicles.found) {
    const AgentState& first = vehicle.track.states.front();
    if (first.time == past.ego.states.front().time) continue;
    const auto ego = stateAt(past.ego, first.time);
    EXPECT_GT((ego->pose.position() - first.pose.position()).norm(),
              scene.options.added.sensing_range);
  }
}

TEST(AddedVehicle, LiveIsUnobservedAtNow) {
  Case scene;
  scene.live = true;
  scene.request.tta = 6.0;
  scene.request.type = CollisionType::kOppositeDirection;
  const AddedVehicles vehicles = scene.vehicles();
  ASSERT_FALSE(vehicles.found.empty()) << vehicles.status.message;
  for (const AddedVehicle& vehicle : vehicles.found) {
    EXPECT_GT((vehicle.track.states.back().pose.position() - scene.ego.position()).norm(),
              scene.options.added.sensing_range);
  }
  scene.request.tta = 2.0;
  scene.request.type = CollisionType::kRearEnd;
  const AddedVehicles none = scene.vehicles();
  EXPECT_TRUE(none.found.empty());
  EXPECT_EQ(none.status.code, StatusCode::kNoCandidate);
  EXPECT_NE(none.status.message.find("appear in the ego's view"), std::string::npos)
      << none.status.message;
}

TEST(AddedVehicle, HasTheRequestedClass) {
  Case scene;
  for (const AgentClass asked : {AgentClass::kBus, AgentClass::kEmergencyVehicle}) {
    scene.request.attacker_class = asked;
    const AddedVehicles vehicles = scene.vehicles();
    ASSERT_FALSE(vehicles.found.empty()) << vehicles.status.message;
    for (const AddedVehicle& vehicle : vehicles.found) {
      EXPECT_EQ(vehicle.track.agent_class, asked);
    }
  }
}

TEST(AddedVehicle, NeedsALaneThatFitsTheType) {
  Case scene;
  scene.ego.x = -150.0;
  scene.request.type = CollisionType::kJunctionCrossing;
  EXPECT_EQ(scene.vehicles().status.code, StatusCode::kRoadDoesNotAllow);
}

}  // namespace
}  // namespace forge
