#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// Id that stands for the ego wherever agents are named.
inline constexpr const char* kEgoId = "ego";

/// The ego's body. Recorded ego poses are those of base_link (the rear axle in nuScenes); tracks
/// hold the middle of the box, `center_offset` metres ahead of base_link.
struct EgoVehicle {
  BoxSize size;
  double center_offset = 0.0;
};

/// A whole recording.
struct Scene {
  std::string name;
  Track ego;
  std::vector<Track> agents;
  std::vector<double> frame_times;  ///< seconds; the instants at which agents were annotated
  std::shared_ptr<const LaneMap> map;
};

/// What is known at an instant: states up to and including `now`, nothing later.
struct Snapshot {
  double now = 0.0;  ///< seconds, the time of the newest frame
  Track ego;
  std::vector<Track> agents;
  std::shared_ptr<const LaneMap> map;
};

/// How everybody moves from now on, predicted or recorded. Recorded agents may appear later.
struct Future {
  Track ego;  ///< the likeliest, or the recorded one
  std::vector<Track> agents;
  std::vector<Track> ego_samples;  ///< equally likely; empty when `ego` is known for certain
};

/// s between the frames that a snapshot holds, however often the scene was seen: nuScenes' and
/// COLLIDE's 2 Hz, from which forecasts and networks learned.
inline constexpr double kFrameInterval = 0.5;

/// Which of these instants (ascending) a snapshot of the last one holds, ascending, at most
/// `count`: the last, then each time the one whose distance in time is nearest to kFrameInterval.
std::vector<double> historyTimes(const std::vector<double>& times, int count);

/// The last frame at or before `time`; empty when the scene starts later.
std::optional<double> lastFrameTime(const Scene& scene, double time);

/// States at the historyTimes() of the annotation frames up to the one at `now`, `frames` of them.
/// Agents absent from all of them are left out.
Snapshot snapshotAt(const Scene& scene, double now, int frames);

/// The recording from the frame at `now` to its end.
Future recordedFuture(const Scene& scene, double now);

}  // namespace forge
