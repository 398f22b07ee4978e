#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/attack/forecast/ego_futures.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/attack/search/search_method.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

inline constexpr double kNow = 100.0;  // s
inline constexpr BoxSize kEgoSize{4.084, 1.730};
inline constexpr BoxSize kCarSize{4.6, 1.9};

/// The options of config/.
inline AttackOptions shippedOptions() {
  static const AttackOptions options = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").attack;
  return options;
}

inline BelievabilityOptions shippedBelievability() {
  static const BelievabilityOptions options = shippedOptions().verification.believability;
  return options;
}

/// The crash definition of config/.
inline CrashDefinition shippedCrash() {
  static const CrashDefinition crash = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").crash;
  return crash;
}

/// A request for any attacker in history mode, by config/.
inline CollisionRequest believableRequestFor(CollisionType type, double tta = 4.0) {
  CollisionRequest request;
  request.type = type;
  request.tta = tta;
  request.crash = shippedCrash();
  return request;
}

/// The same within the strict limits, plausible or not.
inline CollisionRequest requestFor(CollisionType type = CollisionType::kRearEnd, double tta = 4.0) {
  CollisionRequest request = believableRequestFor(type, tta);
  request.crash.limits = LimitSet::kStrict;
  request.crash.believable = false;
  return request;
}

inline EgoFutureOptions shippedEgoFutureOptions() { return shippedOptions().ego_futures; }

/// A predictor without recorded speeds.
inline KinematicPatternPredictor kinematicPredictor(const AttackOptions& options) {
  return {options, std::make_shared<KinematicEgoFutures>(options.ego_futures, nullptr)};
}

/// The default method with kinematicPredictor().
inline SearchMethod searchMethod(const AttackOptions& options) {
  return {options, std::make_shared<KinematicPatternPredictor>(kinematicPredictor(options))};
}

/// Straight on from `pose` at time `at`, one state each `interval` from `first` to `last`.
inline Track straightTrack(const std::string& id, const BoxSize& size, const Pose2& pose,
                           double speed, double at, double first, double last,
                           double interval = 0.5) {
  Track track{id, AgentClass::kCar, size, {}};
  for (int i = 0; first + i * interval <= last + 1e-9; ++i) {
    const double time = first + i * interval;
    const Pose2 there = compose(pose, {speed * (time - at), 0.0, 0.0});
    track.states.push_back({time, there, speed * pose.heading()});
  }
  return track;
}

/// Eight frames at 2 Hz, the newest at kNow.
inline Track pastTrack(const std::string& id, const BoxSize& size, const Pose2& now, double speed) {
  return straightTrack(id, size, now, speed, kNow, kNow - 3.5, kNow);
}

/// Ten seconds at 2 Hz from kNow on.
inline Track futureTrack(const std::string& id, const BoxSize& size, const Pose2& now,
                         double speed) {
  return straightTrack(id, size, now, speed, kNow, kNow, kNow + 10.0);
}

/// The trajectory of a vehicle that drives straight at constant speed from kNow.
inline AttackerTrajectory straightDrive(const Pose2& now, double speed, double duration,
                                        double step = 0.1) {
  AttackerTrajectory trajectory{"attacker", AgentClass::kCar, kCarSize, {}};
  for (int i = 0; i * step <= duration + 1e-9; ++i) {
    const Pose2 pose = compose(now, {speed * step * i, 0.0, 0.0});
    trajectory.points.push_back({kNow + step * i, pose, speed, 0.0, 0.0});
  }
  return trajectory;
}

inline Lane straightLane(const std::string& id, const Vector2& from, const Vector2& to,
                         std::vector<std::string> outgoing = {}) {
  Lane lane;
  lane.id = id;
  lane.outgoing = std::move(outgoing);
  const Vector2 span = to - from;
  const int pieces = static_cast<int>(std::ceil(span.norm() / 5.0));
  for (int i = 0; i <= pieces; ++i) {
    const Vector2 point = from + span * i / pieces;
    lane.centerline.push_back({point.x(), point.y(), std::atan2(span.y(), span.x())});
  }
  return lane;
}

inline Polygon rectangle(double min_x, double min_y, double max_x, double max_y) {
  return {{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}};
}

inline std::shared_ptr<LaneMap> emptyMap() { return std::make_shared<LaneMap>(); }

/// Along x from -200 to 200 m: eastbound on y = 0, westbound on y = 3.5; drivable 7 m wide.
inline std::shared_ptr<LaneMap> twoLaneRoad() {
  auto map = emptyMap();
  map->lanes = {straightLane("east", {-200.0, 0.0}, {200.0, 0.0}),
                straightLane("west", {200.0, 3.5}, {-200.0, 3.5})};
  map->drivable_area = {rectangle(-200.0, -1.75, 200.0, 5.25)};
  return map;
}

/// Two such roads that cross; right-hand traffic, lane centres 1.75 m off the axes.
inline std::shared_ptr<LaneMap> fourWayJunction() {
  auto map = emptyMap();
  map->lanes = {straightLane("east_in", {-200.0, -1.75}, {-10.0, -1.75}, {"east_through"}),
                straightLane("east_through", {-10.0, -1.75}, {10.0, -1.75}, {"east_out"}),
                straightLane("east_out", {10.0, -1.75}, {200.0, -1.75}),
                straightLane("west", {200.0, 1.75}, {-200.0, 1.75}),
                straightLane("north", {1.75, -200.0}, {1.75, 200.0}),
                straightLane("south", {-1.75, 200.0}, {-1.75, -200.0})};
  map->drivable_area = {rectangle(-200.0, -3.5, 200.0, 3.5), rectangle(-3.5, -200.0, 3.5, 200.0)};
  return map;
}

inline Snapshot snapshotOf(Track ego, std::vector<Track> agents, std::shared_ptr<LaneMap> map) {
  return {kNow, std::move(ego), std::move(agents), std::move(map)};
}

}  // namespace forge
