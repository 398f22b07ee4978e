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

/// When a box that drives the points first touches one of the others, at one of the points' times;
/// empty if it does not.
std::optional<double> firstTouch(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                                 const std::vector<const Track*>& others);

/// A vehicle that is to drive on without touching anybody.
struct DriveOnInput {
  const Track& vehicle;     ///< class and size count
  const DriveState& state;  ///< at `time`
  double time = 0.0;        ///< s, the scene's clock
  std::size_t steps = 0;    ///< points that are wanted, SearchOptions::step apart
  const Future& future;     ///< of the ego, if it is known, and the others
  const LaneIndex& lanes;
};

/// Drives as drivers do who want nothing of anybody: back to the middle of the nearest lane, or
/// straight on where there is none, at the present speed, or as much slower as it takes to touch
/// nobody: of some shares of speed and kDrivingStyles the first at which the box, grown
/// by the clearance or as it is, stays clear of everybody in the likeliest future. Where none does,
/// the one that touches somebody latest, of equals that which brakes hardest. Within the limits of
/// the vehicle's class, the first point at `time`.
std::vector<TrajectoryPoint> driveOn(const DriveOnInput& input, const AttackOptions& attack);

}  // namespace forge
