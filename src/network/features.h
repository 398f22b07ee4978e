#pragma once

#include <Eigen/Core>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "attack/ego_paths.h"
#include "attack/options.h"
#include "map/lane_queries.h"
#include "network/network_options.h"
#include "scene/collision_request.h"
#include "scene/scene.h"

namespace forge {

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

inline constexpr int kAgentVector = 8;     ///< x, y, cos, sin, vx, vy, time, is the ego
inline constexpr int kLaneVector = 7;      ///< x, y, cos, sin, is_connector, is_intersection, place
inline constexpr int kEgoFeatures = 9;     ///< five past speeds, three accelerations, turn rate
inline constexpr int kGroupFeatures = 21;  ///< of the way that anchors lie on
inline constexpr int kAnchorFeatures = 12;
inline constexpr int kRequestFeatures = 8;     ///< type one-hot (none: zeros), three of the TTA
inline constexpr int kCandidateFeatures = 24;  ///< of a vehicle that may attack

/// What was observed, made safe for networks: every velocity is the difference to the state before
/// (recorded ones may look ahead), and of agents whose history is hidden only the newest state is
/// left (its velocity stays).
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
EgoWays egoWays(const Snapshot& observed, const LaneIndex& lanes, double horizon,
                const EgoFutureOptions& options, int max_ways);

/// Agents nearest to the ego and seen now, and lanes nearest to it. `observed` as of
/// observedSnapshot(). Throws std::invalid_argument, naming the agent, for a number that is not
/// finite, and for a snapshot without an ego at now.
SceneFeatures sceneFeatures(const Snapshot& observed, const LaneIndex& lanes,
                            const PatternFeatureOptions& options);

/// The anchors for the ego `tta` seconds from now, of the head that the options name.
AnchorFeatures anchorFeatures(const EgoWays& ways, const LaneIndex& lanes, double tta,
                              const EgoFutureOptions& futures,
                              const PatternFeatureOptions& options);

Eigen::VectorXf requestFeatures(std::optional<CollisionType> type, double tta);

/// A vehicle now, in the frame of the ego now.
struct CandidateNow {
  Pose2 pose;
  double speed = 0.0;  ///< m/s along the heading
};
CandidateNow candidateNow(const Track& observed, const Pose2& ego_now);

/// What tells whether a vehicle can be at the ego's pose at impact (in the frame of the ego now).
/// The vehicle's history has no say.
Eigen::VectorXf candidateFeatures(const CandidateNow& candidate, double ego_speed,
                                  const Pose2& ego_at_impact, double tta, CollisionType type);

}  // namespace forge
