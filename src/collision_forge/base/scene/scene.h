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
  double center_offset = 0.0;  ///< m, from base_link forwards to the box centre
};

/// A whole recording. All times are on one clock; poses are box centres in the global map frame.
struct Scene {
  std::string name;                    ///< unique in its log
  Track ego;                           ///< id kEgoId; may have states between and beyond the frames
  std::vector<Track> agents;           ///< all agents except the ego, in no certain order
  std::vector<double> frame_times;     ///< s, ascending; times at which agents were annotated
  std::shared_ptr<const LaneMap> map;  ///< map of the place; null if there is none
  std::vector<TrafficLight> lights;    ///< one per lane with a light; empty if the log has none
};

/// Returns the vehicle that the ego of the scene is: the size of its track, and the offset (m) of
/// EgoVehicle, which no log contains.
inline EgoVehicle egoVehicleOf(const Scene& scene, double center_offset) {
  return {scene.ego.size, center_offset};
}

/// A scene as known at t0: states at the times of the frames up to and including `now`, none later;
/// see snapshotAt().
struct Snapshot {
  double now = 0.0;  ///< t0: s, scene clock, the time of the newest frame
  Track ego;
  std::vector<Track> agents;  ///< agents with a state in one of the frames, without the ego
  std::shared_ptr<const LaneMap> map;  ///< as Scene::map
};

/// Motion of the ego and all agents from t0 on, predicted or recorded. Recorded agents may appear
/// later than t0.
struct Future {
  Track ego;                  ///< the most likely prediction, or the recorded motion
  std::vector<Track> agents;  ///< one motion per agent, recorded or most likely
  /// Equally likely predictions of the ego; empty if `ego` is recorded.
  std::vector<Track> ego_samples;
};

/// s between the frames of a snapshot, whatever the scene's own rate: the 2 Hz of nuScenes and
/// COLLIDE, on which the predictors and networks were trained.
inline constexpr double kFrameInterval = 0.5;

/// Returns the frame times, ascending and at most `count`, of a snapshot taken at the last of
/// `times` (ascending). Goes back from the last: each next time is the one whose gap is nearest to
/// kFrameInterval, the earlier of two equally near ones. Empty without `times`.
std::vector<double> historyTimes(const std::vector<double>& times, int count);

/// Returns the last frame time at or before `time` (s, scene clock, to 1 us); nullopt if the first
/// frame is later.
std::optional<double> lastFrameTime(const Scene& scene, double time);

/// Returns the states at the last `frames` historyTimes() up to `now` (s, scene clock), with
/// velocities derived from the positions (deriveVelocities()). The ego's states are interpolated
/// (stateAt(); omitted where it returns nullopt), agents keep those recorded at these times, to 1
/// us. Omits agents without a state at any of them. Snapshot::now is `now`, also if no frame is at
/// that time. Without a frame up to `now`, the ego has no states and there are no agents.
Snapshot snapshotAt(const Scene& scene, double now, int frames);

/// Returns the recorded states from `now` (s, scene clock, included, to 1 us) to the end of the
/// ego's track, unchanged, later states of agents cut off. Omits agents without a state in this
/// time; `ego_samples` is empty.
Future recordedFuture(const Scene& scene, double now);

}  // namespace forge
