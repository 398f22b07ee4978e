#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "attack/search/test_scenes.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/planner_test/planners/lane_graph.h"
#include "collision_forge/planner_test/planners/planner.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// Returns the shipped configuration.
inline const Config& shippedConfig() {
  static const Config config = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config;
}

/// Creates a lane 3.5 m wide.
inline Lane outlinedLane(const std::string& id, const Vector2& from, const Vector2& to,
                         std::vector<std::string> outgoing = {}) {
  Lane lane = straightLane(id, from, to, std::move(outgoing));
  const Vector2 span = to - from;
  const Vector2 left = 1.75 * Vector2(-span.y(), span.x()).normalized();
  lane.polygon = {from - left, to - left, to + left, from + left};
  return lane;
}

/// A road along x from -200 to 400 m: eastbound lanes at y = 0 ("right") and 3.5 ("left"), a
/// westbound one at y = 7 ("oncoming"); drivable from y = -1.75 to 8.75.
inline std::shared_ptr<const LaneIndex> threeLaneRoad() {
  auto map = std::make_shared<LaneMap>();
  map->lanes = {outlinedLane("right", {-200.0, 0.0}, {400.0, 0.0}),
                outlinedLane("left", {-200.0, 3.5}, {400.0, 3.5}),
                outlinedLane("oncoming", {400.0, 7.0}, {-200.0, 7.0})};
  map->drivable_area = {rectangle(-200.0, -1.75, 400.0, 8.75)};
  return std::make_shared<const LaneIndex>(map);
}

/// A road east along y = 0 to x = 0, then a quarter circle of `radius` metres to the left, then
/// north; drivable 5 m to either side.
inline std::shared_ptr<const LaneIndex> bentRoad(double radius) {
  auto map = std::make_shared<LaneMap>();
  Lane lane;
  lane.id = "bend";
  for (int x = -100; x < 0; x += 2) lane.centerline.push_back({1.0 * x, 0.0, 0.0});
  const int pieces = 40;
  for (int i = 0; i <= pieces; ++i) {
    const double turned = 0.5 * M_PI * i / pieces;
    lane.centerline.push_back(
        {radius * std::sin(turned), radius * (1.0 - std::cos(turned)), turned});
  }
  for (int y = 2; y <= 150; y += 2) lane.centerline.push_back({radius, radius + y, 0.5 * M_PI});
  map->lanes = {lane};
  map->drivable_area = {rectangle(-100.0, -5.0, radius + 5.0, radius + 150.0)};
  return std::make_shared<const LaneIndex>(map);
}

/// Returns the points of a centreline.
inline std::vector<Vector2> routeAlong(const LaneIndex& lanes, std::size_t lane) {
  return lanes.centerline(lane)->points();
}

inline DrivingTask taskOn(std::shared_ptr<const LaneIndex> lanes, std::size_t lane = 0) {
  DrivingTask task;
  task.route = routeAlong(*lanes, lane);
  task.lanes = std::move(lanes);
  task.ego = shippedConfig().ego_vehicle;
  task.wheelbase = shippedConfig().planners.car.wheelbase;
  return task;
}

/// A track with one state at time 0 that drives along its heading.
inline Track agentAt(const std::string& id, const Pose2& pose, double speed,
                     const BoxSize& size = kCarSize, AgentClass agent_class = AgentClass::kCar) {
  return {id, agent_class, size, {{0.0, pose, speed * pose.heading()}}};
}

/// The ego at time 0 with the middle of its box at `pose`.
inline TrajectoryPoint egoAt(const Pose2& pose, double speed) {
  return {0.0, pose, speed, 0.0, 0.0};
}

}  // namespace forge
