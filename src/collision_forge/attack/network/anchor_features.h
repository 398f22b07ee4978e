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

/// Features of a path, shared by the anchors on it.
inline constexpr int kGroupFeatures = 21;
inline constexpr int kAnchorFeatures = 12;  ///< features of one anchor

/// Candidate positions (anchors) of the ego at one time, as network input. Anchors of a group are
/// contiguous, `group_size` per group.
struct AnchorFeatures {
  int group_size = 0;
  RowMatrix groups;             ///< [groups, kGroupFeatures]
  RowMatrix anchors;            ///< [groups * group_size, kAnchorFeatures]
  RowMatrix poses;              ///< [anchors, 4]: x, y (m), cos, sin in the ego's frame at t0
  Eigen::VectorXf prior;        ///< [anchors]: added to the score; kAbsent: no such anchor
  float along_scale = 1.0F;     ///< m, unit of offsets and spreads along an anchor's heading
  float across_scale = 1.0F;    ///< m, the same across it
  Eigen::VectorXf arc_lengths;  ///< [anchors]: m along the path; empty if anchors lie on none
};
inline constexpr float kAbsent = -1e4F;  ///< prior of a missing anchor

/// The ego's candidate paths, most probable first.
struct EgoPathSet {
  EgoNow ego;
  std::vector<EgoPath> paths;
  std::vector<WayAhead> ahead;  ///< one per path, with the vehicle ahead
};
/// Returns the ego's most probable candidate paths, at most `max_ways`, long enough for `horizon`
/// s.
EgoPathSet egoPathSet(const Snapshot& observed, const LaneIndex& lanes, double horizon,
                      int max_ways);

/// Returns the anchors of the ego `tta` s after t0 for options.head. Throws std::invalid_argument
/// if `tta` is not positive and finite.
AnchorFeatures anchorFeatures(const EgoPathSet& ways, const LaneIndex& lanes, double tta,
                              const PatternFeatureOptions& options);

}  // namespace forge
