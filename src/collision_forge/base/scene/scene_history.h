#pragma once

#include <algorithm>
#include <deque>
#include <memory>

#include "collision_forge/base/scene/scene.h"

namespace forge {

/// One frame of agents and the ego, all at the same time.
struct Frame {
  double time = 0.0;          ///< s, clock of the scene
  Pose2 ego;                  ///< centre of the ego's box, global map frame
  std::vector<Track> agents;  ///< without the ego; each with exactly one state, at `time`
};

/// Returns true for an agent with exactly one state, a finite pose and a finite, positive size.
bool isUsable(const Track& agent);

/// Returns the tracks that have a state less than 1 us from `time` (s, scene clock), in the order
/// of `tracks`, each with that state alone: the agents of a Frame. Does not interpolate.
std::vector<Track> agentsAt(const std::vector<Track>& tracks, double time);

/// Returns the frame at the snapshot's t0, with the agents that have a state then. The ego's pose
/// is NaN if the ego has no state at t0.
Frame newestFrame(const Snapshot& snapshot);

/// s; a frame older than the newest by at most this is late (jitter, overtaken on the way) and is
/// dropped; an older one means that a replay was restarted.
inline constexpr double kRestart = 1.0;

/// Removes the elements whose member `time` (s) is more than `age` (s) before the time of the last
/// element. `values`: container of states or frames, oldest first, not empty.
template <typename Values>
void keepNewest(Values& values, double age) {
  const double oldest = values.back().time - age;
  values.erase(values.begin(), std::find_if(values.begin(), values.end(), [=](const auto& value) {
                 return value.time >= oldest;
               }));
}

/// Keeps the newest frames of a live scene and returns snapshots at the interval of historyTimes(),
/// whatever the rate of the frames. Not thread-safe.
class SceneHistory {
 public:
  /// Starts empty. `frames` is the largest number of frames of a snapshot, at least 1; `ego` gives
  /// the size of the ego's box.
  SceneHistory(int frames, const EgoVehicle& ego);

  /// Starts with the frames (one at each state of the ego) and the map of `start`.
  SceneHistory(int frames, const EgoVehicle& ego, const Snapshot& start);

  /// Sets the size of the ego's box in all later snapshots, m.
  void setEgoSize(const BoxSize& size) { ego_.size = size; }

  /// Returns true if a frame at `time` (s) should be dropped: `time` is at most the newest frame's
  /// time and at most kRestart before it. Returns false for an empty history.
  bool isLate(double time) const;

  /// Adds a frame; call isLate() first. Drops agents that are not usable (isUsable()) and returns
  /// their number. A frame that is not later than the newest first removes all frames (a replay was
  /// restarted); map and ego size stay. Forgets frames that no snapshot can use any more. Throws
  /// std::invalid_argument if the ego's pose is not finite.
  int add(Frame frame);

  /// Returns true if there is no frame.
  bool empty() const { return frames_.empty(); }
  /// Returns the newest frame, valid until the next add(). The history must not be empty.
  const Frame& newest() const { return frames_.back(); }

  /// Returns what snapshotAt() returns for a Scene of the same frames, agents sorted by id, each
  /// with the class and size of its newest frame. The map is the one of the constructor's snapshot,
  /// or null. For an empty history, `now` is 0 and there are no states.
  Snapshot snapshot() const;

 private:
  int count_;
  EgoVehicle ego_;
  std::shared_ptr<const LaneMap> map_;
  std::deque<Frame> frames_;  // oldest first
};

}  // namespace forge
