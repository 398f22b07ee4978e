#pragma once

#include <memory>
#include <string>
#include <vector>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/added_paths.h"

namespace forge {

/// On twoLaneRoad() for twelve seconds: the ego alone, eastbound at 8 m/s, 40 m before the origin
/// now.
struct AddedScene {
  std::shared_ptr<LaneMap> map = twoLaneRoad();
  std::vector<Track> others;  // up to now
  CollisionRequest request = believableRequestFor(CollisionType::kRearEnd);
  Snapshot past;
  Future future;
  std::unique_ptr<LaneIndex> lanes;

  static constexpr double kEgoX = -40.0;
  static constexpr double kEgoSpeed = 8.0;

  static Track longPast(const std::string& id, const BoxSize& size, const Pose2& now,
                        double speed) {
    return straightTrack(id, size, now, speed, kNow, kNow - 12.0, kNow);
  }

  /// Adds an agent that drives straight on before and after kNow.
  void add(const std::string& id, const Pose2& now, double speed) {
    others.push_back(longPast(id, kCarSize, now, speed));
    future.agents.push_back(futureTrack(id, kCarSize, now, speed));
  }

  AddedVehicleInput input() {
    past = snapshotOf(longPast(kEgoId, kEgoSize, {kEgoX, 0.0, 0.0}, kEgoSpeed), others, map);
    future.ego = futureTrack(kEgoId, kEgoSize, {kEgoX, 0.0, 0.0}, kEgoSpeed);
    lanes = std::make_unique<LaneIndex>(map);
    return {past, &past, future, request, *lanes};
  }
};

}  // namespace forge
