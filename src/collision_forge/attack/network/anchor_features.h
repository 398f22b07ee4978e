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

inline constexpr int kGroupFeatures = 21;  ///< of the way that anchors lie on
inline constexpr int kAnchorFeatures = 12;

/// Where the ego may stand at an instant. Anchors of a group lie together, `group_size` a group.
struct AnchorFeatures {
  int group_size = 0;
  RowMatrix groups;             ///< [groups, kGroupFeatures]
  RowMatrix anchors;            ///< [groups * group_size, kAnchorFeatures]
  RowMatrix poses;              ///< [.., 4]: x, y (m), cos, sin in the frame of the ego now
  Eigen::VectorXf prior;        ///< [..]: added to the score; kAbsent: there is no such anchor
  float along_scale = 1.0F;     ///< m, of offsets and spreads along an anchor's heading
  float across_scale = 1.0F;    ///< m, across it
  Eigen::VectorXf arc_lengths;  ///< [..]: m along the way; empty for anchors that are on no way
};
inline constexpr float kAbsent = -1e4F;

/// The ways of the ego with what is ahead on them, likeliest first, `max_ways` at most.
struct EgoWays {
  EgoNow ego;
  std::vector<EgoPath> paths;
  std::vector<WayAhead> ahead;  ///< one a path, with the vehicle ahead
};
EgoWays egoWays(const Snapshot& observed, const LaneIndex& lanes, double horizon, int max_ways);

/// The anchors for the ego `tta` seconds from now, of the head that the options name.
AnchorFeatures anchorFeatures(const EgoWays& ways, const LaneIndex& lanes, double tta,
                              const PatternFeatureOptions& options);

}  // namespace forge
