#pragma once

#include <algorithm>
#include <deque>
#include <memory>

#include "collision_forge/base/scene/scene.h"

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

/// s; a frame that is older than the newest by no more is late: its stamp jitters, or it was
/// overtaken. One that is older by more is of a replay that starts again.
inline constexpr double kRestart = 1.0;

/// Takes away what is older than the newest by more than `age` s. `values`: states or frames,
/// oldest first.
template <typename Values>
void keepNewest(Values& values, double age) {
  const double oldest = values.back().time - age;
  values.erase(values.begin(), std::find_if(values.begin(), values.end(), [=](const auto& value) {
                 return value.time >= oldest;
               }));
}

/// Keeps the newest frames of a running scene, and shows those that a snapshot holds
/// (historyTimes()), however often frames come. Not thread-safe.
class SceneHistory {
 public:
  /// snapshot() has at most `frames` frames.
  SceneHistory(int frames, const EgoVehicle& ego);

  /// Begins with the frames of `start`.
  SceneHistory(int frames, const EgoVehicle& ego, const Snapshot& start);

  /// At the newest frame's time, or before it by no more than kRestart.
  bool isLate(double time) const;

  /// Takes a frame that is not late. Agents that are not usable are left out; their number is
  /// returned. A frame from before the newest starts the history anew (a replay was restarted).
  /// Throws std::invalid_argument for an ego pose that is not finite.
  int add(Frame frame);

  bool empty() const { return frames_.empty(); }
  const Frame& newest() const { return frames_.back(); }

  /// As snapshotAt() of the same frames in a Scene, agents sorted by id; the map is that of the
  /// snapshot that it began with, or none.
  Snapshot snapshot() const;

 private:
  int count_;
  EgoVehicle ego_;
  std::shared_ptr<const LaneMap> map_;
  std::deque<Frame> frames_;  // oldest first
};

}  // namespace forge
