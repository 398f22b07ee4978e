#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/study/generators/options.h"
#include "collision_forge/study/generators/traffic_lanes.h"

namespace forge {

/// The poses (box centres) of an agent by frame, ascending in time; nullopt in frames in which it
/// is not observed.
using AgentFrames = std::vector<std::optional<Pose2>>;

/// Input or training example of a traffic model: frames at about 2 Hz, t0 at index history_frames -
/// 1. Coordinates are in the frame of the ego at t0.
struct TrafficClip {
  std::string scene;  ///< name of the scene; "" if unknown
  CollisionType type = CollisionType::kRearEnd;
  int collision_frame = 0;  ///< index of the frame of the crash
  /// Ego, attacker, then the other motor vehicles that are observed at t0 and moved, nearest to the
  /// ego first; at most TrafficOptions::max_agents.
  std::vector<AgentFrames> agents;
  /// lanesAround() ego and attacker at t0; empty if the model ignores lanes.
  std::vector<TrafficLane> lanes;
  std::vector<std::string> ids;  ///< ids of `agents`, in their order
};

inline constexpr std::size_t kEgoAgent = 0;       ///< index of the ego in TrafficClip::agents
inline constexpr std::size_t kAttackerAgent = 1;  ///< index of the attacker in TrafficClip::agents

/// Converts all frames of a COLLIDE clip. Replaces the attacker's history by straight motion at the
/// speed at t0 (toScene()), because the history in the file reveals its future. `lanes` may be
/// null: the result then has no lanes.
TrafficClip trafficOf(const CollideClip& clip, const CollideOptions& collide,
                      const TrafficOptions& options, const LaneIndex* lanes);

/// Converts the history of a snapshot, resampled every kFrameInterval up to t0; `agents` have no
/// frames after t0. The crash is at the frame nearest to the request's TTA, at least one after t0.
/// If the history of ego or attacker is too short, extends it by straight motion at its first
/// speed. Throws std::invalid_argument if the attacker is not in the snapshot.
TrafficClip trafficOf(const Snapshot& snapshot, const std::string& attacker,
                      const CollisionRequest& request, const TrafficOptions& options,
                      const LaneIndex* lanes);

}  // namespace forge
