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

/// Frames in the order of time; empty where an agent is not seen.
using AgentFrames = std::vector<std::optional<Pose2>>;

/// What a generator sees of a moment, or learns from: frames at about 2 Hz, the newest known one at
/// index history_frames - 1. Frame of the ego now.
struct TrafficClip {
  std::string scene;
  CollisionType type = CollisionType::kRearEnd;
  int collision_frame = 0;          ///< index of the frame of the crash
  std::vector<AgentFrames> agents;  ///< the ego, the attacker, then others that move, nearest first
  std::vector<TrafficLane> lanes;   ///< around the ego and the attacker now
  std::vector<std::string> ids;     ///< of the agents
};

inline constexpr std::size_t kEgoAgent = 0;
inline constexpr std::size_t kAttackerAgent = 1;

/// All frames of a clip of COLLIDE. The attacker's history is not that of the file, which gives its
/// future away: it came straight at the speed of now (toScene()). None are seen where
/// `lanes` is null.
TrafficClip trafficOf(const CollideClip& clip, const CollideOptions& collide,
                      const TrafficOptions& options, const LaneIndex* lanes);

/// The history of a snapshot, the crash at the frame nearest to the request's TTA. An ego or
/// attacker that was not seen so long came straight at its first speed. Throws
/// std::invalid_argument for an attacker that is not in the snapshot.
TrafficClip trafficOf(const Snapshot& snapshot, const std::string& attacker,
                      const CollisionRequest& request, const TrafficOptions& options,
                      const LaneIndex* lanes);

}  // namespace forge
