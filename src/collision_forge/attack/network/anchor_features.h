#pragma once

#include <Eigen/Core>
#include <vector>

#include "collision_forge/attack/forecast/ego_paths.h"
#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/network/row_matrix.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Number of features of a path, shared by the anchors on it, in order: log probability; whether it
/// is on lanes; the six fields of RoadAhead; lateral offset and yaw of its start in the ego's
/// frame; start and end of its first junction (at most 80 m ahead), whether there is one, whether
/// the path starts in it; the ego's speed over the last kProfileStep; turn from the path's start to
/// 5, 10, 20, 30, 45 and 60 m. A lane (kTargetPoints) has the first alone: 1 for a connector, else
/// 0. With kRegression all are 0.
inline constexpr int kGroupFeatures = 21;
/// Number of features of one anchor. On a path, in order: mean speed to the anchor minus the ego's
/// speed; mean speed; place in the group (0 at constant speed or for the anchor that stands, about
/// -1 and 1 at the ends); whether it stands; acceleration needed; gap left to the vehicle ahead if
/// that keeps its speed; distance beyond the start of the junction; the absolute value of that, up
/// to 10 m; lateral acceleration in the bends over kComfortableLateralAcceleration; distance
/// driven; y and sin yaw of the anchor. With the other heads: the first two (mean speed from the
/// straight distance), x, y, cos and sin yaw, then zeros.
inline constexpr int kAnchorFeatures = 12;

/// Candidate positions (anchors) of the ego's box centre at one time, as network input. A group is
/// a candidate path (in the order of EgoPathSet) or lane (nearest first); its anchors are
/// contiguous, `group_size` per group. Rows without an anchor are 0.
struct AnchorFeatures {
  int group_size = 0;  ///< number of anchors per group, missing ones included
  RowMatrix groups;    ///< [groups, kGroupFeatures], scaled to order one
  RowMatrix anchors;   ///< [groups * group_size, kAnchorFeatures], scaled to order one
  RowMatrix poses;     ///< [anchors, 4]: x, y (m), cos, sin in the ego's frame at t0
  /// [anchors]: log probability of the path, 0 if anchors lie on no path; added to the score;
  /// kAbsent: no such anchor
  Eigen::VectorXf prior;
  float along_scale = 1.0F;   ///< m, unit of offsets and spreads along an anchor's heading
  float across_scale = 1.0F;  ///< m, the same across it
  /// [anchors]: m along the path, from the ego's place at t0; empty if anchors lie on no path
  Eigen::VectorXf arc_lengths;
};
inline constexpr float kAbsent = -1e4F;  ///< prior of a missing anchor

/// The ego's candidate paths, most probable first, with weights that sum to 1 (rescaled after the
/// choice).
struct EgoPathSet {
  EgoNow ego;  ///< state and recent motion at t0
  std::vector<EgoPath> paths;
  std::vector<RoadAhead> ahead;  ///< one per path: roadAhead(), with the vehicle ahead
};
/// Returns the ego's most probable candidate paths, at most `max_ways` (at least one), long enough
/// for `horizon` s. `observed` comes from observedSnapshot(). Throws std::invalid_argument if the
/// ego has no states.
EgoPathSet egoPathSet(const Snapshot& observed, const LaneIndex& lanes, double horizon,
                      int max_ways);

/// Returns the anchors of the ego `tta` s after t0 for options.head: on paths, the first one of
/// each group stands and the others lie `along_scale` apart around the place reached at constant
/// speed, absent where that is behind the ego; every target_spacing or more on lanes, or one
/// straight ahead if no lane is in reach; or a single one straight ahead at constant speed. `lanes`
/// is used by the head kTargetPoints only. Throws std::invalid_argument if `tta` is not positive
/// and finite.
AnchorFeatures anchorFeatures(const EgoPathSet& ways, const LaneIndex& lanes, double tta,
                              const PatternFeatureOptions& options);

}  // namespace forge
