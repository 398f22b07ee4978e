#pragma once

#include <Eigen/Core>
#include <set>
#include <string>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/network/row_matrix.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Numbers per agent and frame: x, y (kPlaceScale), cos yaw, sin yaw, vx, vy (kSpeedScale), time
/// since t0 (4 s; at most 0; frames count as 0.5 s apart), is ego (1 or 0). In brackets, here and
/// below: the unit of the number, by which the value in m, s, m/s or m/s2 is divided.
inline constexpr int kAgentVector = 8;
/// Numbers per lane point: x, y (kPlaceScale), cos yaw, sin yaw, is_connector, is_intersection,
/// index of the point over lane_points; then the lane's links: numbers of successors and
/// predecessors (3), turns (rad, left positive, from the lane's end to the successor's end) of the
/// leftmost and the rightmost successor (0 without a successor), whether a successor is in an
/// intersection (1 or 0).
inline constexpr int kLaneVector = 12;
/// Numbers of the ego: five past speeds (EgoNow; kSpeedScale), the three newest accelerations
/// between them (newest first; kAccelerationScale), turn rate (kTurnRateScale, clamped to
/// kMaxFeature).
inline constexpr int kEgoFeatures = 9;

/// Returns the snapshot without information from later frames: velocities are backward differences
/// (recorded ones may look ahead; a track's first state takes the velocity of its second), and of
/// agents whose id is in `hidden` only the newest state remains.
Snapshot observedSnapshot(const Snapshot& snapshot, const std::set<std::string>& hidden);

/// A scene as network input of fixed size (PatternFeatureOptions), in the frame of the ego's box at
/// t0, scaled to order one. Missing entries have mask 0 and value 0, others mask 1.
struct SceneFeatures {
  /// [(1 + max_agents) * history_frames, kAgentVector]: the ego's frames, then the frames of each
  /// agent, nearest agent first; oldest frame first. Frames of other agents before the newest
  /// agent_frames are missing.
  RowMatrix agents;
  Eigen::VectorXf agent_mask;  ///< [rows of agents]
  /// [max_lanes * lane_points, kLaneVector]: the points of each lane from its start, nearest lane
  /// first
  RowMatrix lanes;
  Eigen::VectorXf lane_mask;  ///< [rows of lanes]
  Eigen::VectorXf ego;        ///< [kEgoFeatures]
};

/// Encodes the ego, the agents present at t0 (to 1 us) nearest to it (box centres) and the nearest
/// lanes, each at most as many as `options` allows. `observed` must come from observedSnapshot().
/// Throws std::invalid_argument, naming the agent, for a number that is not finite, and if the
/// snapshot has no ego state at its time.
SceneFeatures sceneFeatures(const Snapshot& observed, const LaneIndex& lanes,
                            const PatternFeatureOptions& options);

}  // namespace forge
