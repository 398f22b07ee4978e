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

/// Returns the time (s, scene clock) of the first point at which a box of `size` centred there
/// overlaps one of `others` at that time; empty if there is none. Tests the points only, not the
/// motion between them; a track without a state at a point's time does not count there. The points'
/// times must ascend.
std::optional<double> firstTouch(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                                 const std::vector<const Track*>& others);

/// A vehicle that continues as normal traffic. Holds references: the referenced objects must
/// outlive it.
struct DriveOnInput {
  const Track& vehicle;     ///< only class, size and id are used
  const DriveState& state;  ///< at `time`
  double time = 0.0;        ///< s, scene clock
  std::size_t steps = 0;    ///< number of points to return, SearchOptions::step apart; at least 1
  /// other agents, and the ego if it is known (else without states); the vehicle's own track is
  /// ignored
  const Future& future;
  const LaneIndex& lanes;
};

/// Returns a motion (box centres) of input.steps points that continues as normal traffic, within
/// the limits of the vehicle's class, first point at `time`: back to the middle of the nearest lane
/// (within kMaxDeparture and kOnLaneHeading) within 3 s, or straight on without a lane. Tries
/// shares of the present speed in order, from all of it (calmest style alone) to 0, each with every
/// style of kDrivingStyles, first with the box enlarged by 0.2 m on all sides, then without, and
/// returns the first motion without contact in the predicted future. If there is none, returns the
/// motion with the latest contact, and among equals the one with the strongest braking. Agents that
/// overlap the vehicle at `time` are ignored.
std::vector<TrajectoryPoint> driveOn(const DriveOnInput& input, const AttackOptions& attack);

}  // namespace forge
