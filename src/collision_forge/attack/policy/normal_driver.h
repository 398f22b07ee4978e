#pragma once

#include <optional>
#include <vector>

#include "collision_forge/attack/policy/options.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Returns the first of the points' times (s) at which a box of `size` moving along `points`
/// overlaps one of `others`; empty if there is none.
std::optional<double> firstTouch(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                                 const std::vector<const Track*>& others);

/// A vehicle that continues as normal traffic.
struct DriveOnInput {
  const Track& vehicle;     ///< only class and size are used
  const DriveState& state;  ///< at `time`
  double time = 0.0;        ///< s, scene clock
  std::size_t steps = 0;    ///< number of points, SearchOptions::step apart; at least 1
  const Future& future;     ///< other agents, and the ego if it is known
  const LaneIndex& lanes;
};

/// Returns a motion that continues as normal traffic, within the limits of the vehicle's class,
/// first point at `time`: back to the middle of the nearest lane, or straight on without a lane.
/// Tries the speed shares of `options` in order, each with every style of `attack.route`, first
/// with the box enlarged by options.clearance, then without, and returns the first motion without
/// contact in the predicted future. If there is none, returns the motion with the latest contact,
/// of equals the one with the strongest braking. Agents that overlap the vehicle at `time` are
/// ignored.
std::vector<TrajectoryPoint> driveOn(const DriveOnInput& input, const DriveOnOptions& options,
                                     const AttackOptions& attack);

}  // namespace forge
