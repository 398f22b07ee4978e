#pragma once

#include <deque>

#include "collision_forge/scene/scene.h"
#include "collision_forge/scene/scene_history.h"

namespace forge {

/// Keeps what was seen of a running scene, and shows it as forecasts want it: in frames an even
/// interval apart, however often somebody looked.
class ObservedScene {
 public:
  /// Begins with the frames of `start`. snapshot() has at most `frames` frames: the newest, then
  /// each time the one whose distance in time is nearest to `interval` seconds.
  ObservedScene(const Snapshot& start, const EgoVehicle& ego, int frames, double interval);

  /// A frame that is later than the newest, with a finite ego. Agents that are not usable
  /// (isUsable()) are left out.
  void add(const Frame& frame);

  const Frame& newest() const { return frames_.back(); }

  /// The newest frame as now, and those before it.
  Snapshot snapshot() const;

 private:
  std::shared_ptr<const LaneMap> map_;
  EgoVehicle ego_;
  int count_;
  double interval_;           // s
  std::deque<Frame> frames_;  // oldest first
};

}  // namespace forge
