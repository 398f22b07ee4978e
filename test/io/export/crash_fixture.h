#pragma once

#include <memory>

#include "collision_forge/io/export/crash_record.h"
#include "collision_forge/io/export/crash_writer.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

inline constexpr double kNow = 1533153458.4;  // s on the scene's clock

inline const Config& shippedConfig() {
  static const Config config = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config;
}

/// A track at rest or moving along x, from `first` to `last` s after t0, a state every 0.5 s.
inline Track straightTrack(const std::string& id, AgentClass agent_class, const Pose2& at_now,
                           double speed, double first, double last) {
  Track track{id, agent_class, {4.0, 1.7}, {}};
  for (double time = first; time <= last + 1e-9; time += 0.5) {
    track.states.push_back(
        {kNow + time, {at_now.x + speed * time, at_now.y, at_now.yaw}, {speed, 0.0}});
  }
  return track;
}

/// The ego drives along x at 10 m/s, from 3 s before to 6 s after t0. Car "a" is at rest 32 m ahead
/// of it up to t0. Other agents: a pedestrian, a bicycle that is out of sight for a time, and a bus
/// far away. Two consecutive lanes along x; lane "far" is far away.
inline IndexedScene straightScene() {
  IndexedScene indexed;
  Scene& scene = indexed.scene;
  scene.name = "scene-0001";
  scene.ego = straightTrack(kEgoId, AgentClass::kCar, {}, 10.0, -3.0, 6.0);
  scene.agents = {
      straightTrack("a", AgentClass::kCar, {32.0, 0.0, 0.0}, 0.0, -1.0, 6.0),
      straightTrack("walker", AgentClass::kPedestrian, {10.0, 6.0, 0.0}, 1.0, -3.0, 6.0),
      straightTrack("bus", AgentClass::kBus, {900.0, 3.5, 0.0}, 0.0, -3.0, 6.0),
      straightTrack("bicycle", AgentClass::kBicycle, {5.0, -4.0, 0.0}, 3.0, -3.0, -1.0)};
  const Track later =
      straightTrack("bicycle", AgentClass::kBicycle, {5.0, -4.0, 0.0}, 3.0, 1.0, 2.0);
  Track& bicycle = scene.agents.back();
  bicycle.states.insert(bicycle.states.end(), later.states.begin(), later.states.end());
  auto map = std::make_shared<LaneMap>();
  map->location = "embedded-right";
  map->lanes = {{"first", false, false, {{-50, 0, 0}, {20, 0, 0}}, {}, {}, {"second"}, {}},
                {"second", false, false, {{20, 0, 0}, {90, 0, 0}}, {}, {"first"}, {}, 13.9},
                {"far", false, false, {{-50, 500, 0}, {20, 500, 0}}, {}, {}, {}, {}}};
  scene.map = map;
  indexed.lanes = std::make_shared<LaneIndex>(map);
  return indexed;
}

/// Car "a" drives at 2 m/s from t0 on: the ego's front reaches its rear 3.5 s later.
inline Scenario slowCar() {
  Scenario scenario;
  scenario.asked.scene = "scene-0001";
  scenario.asked.now = kNow;
  scenario.asked.request.tta = 3.5;
  scenario.asked.request.seed = 7;
  scenario.ego = {{4.0, 1.7}, 1.4};
  AttackerTrajectory& trajectory = scenario.answer.trajectory;
  trajectory.attacker_id = "a";
  trajectory.size = {4.0, 1.7};
  for (int i = 0; i <= 50; ++i) {
    trajectory.points.push_back({kNow + 0.1 * i, {32.0 + 0.2 * i, 0.0, 0.0}, 2.0, 0.0, 0.0});
  }
  return scenario;
}

/// The record of slowCar() in straightScene(), with `history` seconds before t0.
inline CrashRecord slowCarRecord(double history = 2.0, const Scenario& scenario = slowCar()) {
  static const IndexedScene indexed = straightScene();
  static const LaneArcs no_arcs;
  const Config& config = shippedConfig();
  return crashRecord(scenario, 17, history,
                     {indexed, no_arcs, config.exports, config.attack.verification});
}

inline ExportPlan planFor(const std::string& folder, bool ego_free = false) {
  const Config& config = shippedConfig();
  return {folder, ego_free, config.exports, config.attack.verification.drivable,
          readCatalogue(std::string(COLLISION_FORGE_SOURCE_DIR "/config"), "all")};
}

}  // namespace forge
