#pragma once

#include <Eigen/Core>
#include <set>
#include <string>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/network/row_matrix.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

inline constexpr int kAgentVector = 8;  ///< x, y, cos, sin, vx, vy, time, is the ego
/// x, y, cos, sin, is_connector, is_intersection, place; then what follows the lane: numbers of
/// successors and predecessors, the turns of the leftmost and the rightmost successor, whether a
/// successor is in an intersection
inline constexpr int kLaneVector = 12;
inline constexpr int kEgoFeatures = 9;  ///< five past speeds, three accelerations, turn rate

/// What was observed, made safe for networks: every velocity is the difference to the state before
/// (recorded ones may look ahead), that of a track's first state the one of its second, and of
/// agents whose history is hidden only the newest state is left (its velocity stays).
Snapshot observedSnapshot(const Snapshot& snapshot, const std::set<std::string>& hidden);

/// A scene as network input, in the frame of the ego now, numbers of order one. Made to fixed sizes
/// of PatternFeatureOptions; what is missing has the mask 0 and the value 0.
struct SceneFeatures {
  RowMatrix agents;  ///< [(1 + max_agents) * frames, kAgentVector], the ego first
  Eigen::VectorXf agent_mask;
  RowMatrix lanes;  ///< [max_lanes * lane_points, kLaneVector]
  Eigen::VectorXf lane_mask;
  Eigen::VectorXf ego;  ///< [kEgoFeatures]
};

/// Agents nearest to the ego and seen now, and lanes nearest to it. `observed` as of
/// observedSnapshot(). Throws std::invalid_argument, naming the agent, for a number that is not
/// finite, and for a snapshot without an ego at now.
SceneFeatures sceneFeatures(const Snapshot& observed, const LaneIndex& lanes,
                            const PatternFeatureOptions& options);

}  // namespace forge
