#pragma once

#include <Eigen/Core>
#include <set>
#include <string>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/network/row_matrix.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

inline constexpr int kAgentVector = 8;  ///< x, y, cos, sin, vx, vy, time, is ego
/// x, y, cos, sin, is_connector, is_intersection, position along the lane; then the lane's links:
/// numbers of successors and predecessors, turns of the leftmost and the rightmost successor,
/// whether a successor is in an intersection.
inline constexpr int kLaneVector = 12;
inline constexpr int kEgoFeatures = 9;  ///< five past speeds, three accelerations, turn rate

/// Returns the snapshot without information from later frames: velocities are backward differences
/// (recorded ones may look ahead; a track's first state takes the velocity of its second), and of
/// agents in `hidden` only the newest state remains.
Snapshot observedSnapshot(const Snapshot& snapshot, const std::set<std::string>& hidden);

/// A scene as network input of fixed size (PatternFeatureOptions), in the ego's frame at t0, scaled
/// to order one. Missing entries have mask 0 and value 0.
struct SceneFeatures {
  RowMatrix agents;            ///< [(1 + max_agents) * history_frames, kAgentVector], ego first
  Eigen::VectorXf agent_mask;  ///< [rows of agents]
  RowMatrix lanes;             ///< [max_lanes * lane_points, kLaneVector]
  Eigen::VectorXf lane_mask;   ///< [rows of lanes]
  Eigen::VectorXf ego;         ///< [kEgoFeatures]
};

/// Encodes the ego, the agents present at t0 nearest to it and the nearest lanes. `observed` must
/// come from observedSnapshot(). Throws std::invalid_argument, naming the agent, for a number that
/// is not finite, and if the snapshot has no ego state at its time.
SceneFeatures sceneFeatures(const Snapshot& observed, const LaneIndex& lanes,
                            const PatternFeatureOptions& options);

}  // namespace forge
