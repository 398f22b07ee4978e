#pragma once

#include <deque>

#include "collision_forge/scene/scene.h"

namespace forge {

/// One annotation frame as it arrives: the ego and everybody else at one time.
struct Frame {
  double time = 0.0;          ///< seconds
  Pose2 ego;                  ///< middle of the ego's box, global map frame
  std::vector<Track> agents;  ///< each with exactly one state, at `time`
};

/// True for an agent of a frame whose pose and size are finite, the size positive.
bool isUsable(const Track& agent);

/// Those who have a state at `time` (to a microsecond), each with that state alone: the agents of a
/// Frame.
std::vector<Track> agentsAt(const std::vector<Track>& tracks, double time);

/// The frame at a snapshot's now. The ego's pose is not finite where it was not seen then.
Frame newestFrame(const Snapshot& snapshot);

/// Keeps the newest frames of a running scene. Not thread-safe.
class SceneHistory {
 public:
  SceneHistory(int frames, const EgoVehicle& ego);

  /// Takes a frame. Agents that are not usable are left out; their number is returned. A frame
  /// whose time is not after the last one's starts the history anew (a replay was restarted).
  /// Throws std::invalid_argument for an ego pose that is not finite.
  int add(Frame frame);

  bool empty() const { return frames_.empty(); }

  /// As snapshotAt() of the same frames in a Scene, agents sorted by id; the map is left empty.
  Snapshot snapshot() const;

 private:
  std::size_t capacity_;
  EgoVehicle ego_;
  std::deque<Frame> frames_;
};

}  // namespace forge
