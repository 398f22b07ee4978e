#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "attack/search/test_scenes.h"
#include "collision_forge/planner_test/trials/crash_scenario.h"
#include "collision_forge/planner_test/trials/rollout.h"
#include "planner_test/planners/planner_scenes.h"

namespace forge {

/// A scenario: the ego drives east along y = 0 on the two-lane road from the origin; `attacker` and
/// the other agents are given.
inline CrashScenario roadScenario(double ego_speed, AttackerTrajectory attacker,
                                  std::vector<std::pair<Track, Track>> others = {},
                                  std::shared_ptr<LaneMap> map = twoLaneRoad()) {
  CrashScenario scenario;
  scenario.ego = {kEgoSize, shippedConfig().ego_vehicle.center_offset};
  scenario.snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, {}, ego_speed), {}, map);
  scenario.recorded.ego = futureTrack(kEgoId, kEgoSize, {}, ego_speed);
  const TrajectoryPoint& start = attacker.points.front();
  scenario.snapshot.agents.push_back(
      pastTrack(attacker.attacker_id, attacker.size, start.pose, start.speed));
  scenario.attacker = std::move(attacker);
  for (auto& [past, future] : others) {
    scenario.snapshot.agents.push_back(std::move(past));
    scenario.recorded.agents.push_back(std::move(future));
  }
  scenario.lanes = std::make_shared<const LaneIndex>(std::move(map));
  return scenario;
}

/// Past and future of a car that drives straight on.
inline std::pair<Track, Track> straightCar(const std::string& id, const Pose2& now, double speed) {
  return {pastTrack(id, kCarSize, now, speed), futureTrack(id, kCarSize, now, speed)};
}

inline RolloutSetup shippedSetup(Background background = Background::kReplay) {
  return {shippedConfig().planners, shippedConfig().attack, shippedConfig().crash, background};
}

}  // namespace forge
