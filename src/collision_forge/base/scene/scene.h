#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/track.h"
#include "collision_forge/base/scene/traffic_light.h"

namespace forge {

/// Id that stands for the ego wherever agents are named.
inline constexpr const char* kEgoId = "ego";

/// The ego's dimensions. Recorded ego poses are poses of base_link (the rear axle in nuScenes);
/// tracks hold the box centre, which is `center_offset` ahead of base_link.
struct EgoVehicle {
  BoxSize size;
  double center_offset = 0.0;  ///< m
};

/// A whole recording.
struct Scene {
  std::string name;
  Track ego;
  std::vector<Track> agents;
  std::vector<double> frame_times;  ///< s, ascending; times at which agents were annotated
  std::shared_ptr<const LaneMap> map;
  std::vector<TrafficLight> lights;  ///< empty if the log has none
};

/// Returns the vehicle that the ego of the scene is: the size of its track, and the offset (m) of
/// EgoVehicle, which no log contains.
inline EgoVehicle egoVehicleOf(const Scene& scene, double center_offset) {
  return {scene.ego.size, center_offset};
}

/// A scene as known at t0: states up to and including `now`, none later.
struct Snapshot {
  double now = 0.0;  ///< t0: s, the time of the newest frame
  Track ego;
  std::vector<Track> agents;
  std::shared_ptr<const LaneMap> map;
};

/// Motion of the ego and all agents from t0 on, predicted or recorded. Recorded agents may appear
/// later than t0.
struct Future {
  Track ego;  ///< the most likely prediction, or the recorded motion
  std::vector<Track> agents;
  std::vector<Track> ego_samples;  ///< equally likely predictions; empty if `ego` is recorded
};

/// s between the frames of a snapshot, whatever the scene's own rate: the 2 Hz of nuScenes and
/// COLLIDE, on which the predictors and networks were trained.
inline constexpr double kFrameInterval = 0.5;

/// Returns the frame times, ascending and at most `count`, of a snapshot taken at the last of
/// `times` (ascending). Goes back from the last: each next time is the one whose gap is nearest to
/// kFrameInterval.
std::vector<double> historyTimes(const std::vector<double>& times, int count);

/// Returns the last frame time at or before `time` (s); nullopt if the scene starts later.
std::optional<double> lastFrameTime(const Scene& scene, double time);

/// Returns the states at the last `frames` historyTimes() up to `now`, with velocities derived from
/// the positions. Omits agents without a state at any of them.
Snapshot snapshotAt(const Scene& scene, double now, int frames);

/// Returns the recorded states from `now` to the end of the ego's track.
Future recordedFuture(const Scene& scene, double now);

}  // namespace forge
