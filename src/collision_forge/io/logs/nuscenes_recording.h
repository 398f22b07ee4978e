#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Pose of base_link in the global map frame, as recorded with one sweep of LIDAR_TOP.
struct NuScenesEgoPose {
  std::int64_t timestamp_us = 0;  ///< microseconds on the scene's clock (nuScenes: since 1970)
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< m
  /// From base_link to the map frame, unit.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

/// One annotated object in one frame. Global map frame, metres.
struct NuScenesAnnotation {
  std::string token;                    ///< token of the annotation; "" if the log has none
  std::string instance;                 ///< token of the object, equal in all frames
  std::string category;                 ///< for instance "vehicle.car"
  std::vector<std::string> attributes;  ///< for instance "vehicle.moving"
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< centre of the box
  /// Length, width, height, m (all > 0; height 0 if the log has none).
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  /// From the box's axes (x ahead, z up) to the map frame, unit.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
};

/// A keyframe (sample) with its annotations.
struct NuScenesFrame {
  std::string token;                            ///< token of the sample; "" if the log has none
  std::int64_t timestamp_us = 0;                ///< microseconds on the scene's clock
  std::vector<NuScenesAnnotation> annotations;  ///< in the table's order
};

/// Everything recorded in one scene, before it is flattened to the ground plane.
struct NuScenesRecording {
  std::string name;
  std::string description;                 ///< text of the log; may be empty
  std::string location;                    ///< name of the map, for instance "boston-seaport"
  std::optional<BoxSize> ego_size;         ///< size of the ego's box, if the log contains it
  std::vector<NuScenesEgoPose> ego_poses;  ///< timestamps strictly increasing
  std::vector<NuScenesFrame> frames;       ///< timestamps strictly increasing
  std::vector<TrafficLight> lights;        ///< as Scene::lights, times in s on the same clock
};

/// Returns the heading (rad from x to y, in (-pi, pi]) of the rotated x axis, projected on the
/// ground.
double yawOf(const Eigen::Quaterniond& rotation);

/// Returns the class of a category ("vehicle.bus.rigid" -> kBus); nullopt for an unknown one.
std::optional<AgentClass> agentClassOfCategory(const std::string& category);

/// As above; categories that nuScenes does not have are looked up in `others`, by name in lower
/// case, which also covers its subcategories ("vehicle.fire" of `others` matches
/// "Vehicle.Fire.Ladder"); the longest match counts.
std::optional<AgentClass> agentClassOfCategory(const std::string& category,
                                               const std::map<std::string, AgentClass>& others);

/// Returns the most general category of a class, as "vehicle.car".
const char* categoryOf(AgentClass agent_class);

/// Sets every annotation's velocity (map frame) as the nuScenes devkit does: from the instance's
/// previous to its next frame (at most 3 s apart), one-sided at the ends of its track (at most 1.5
/// s). If the devkit would return NaN: one-sided to the nearer neighbour within 1.5 s, else zero.
/// Timestamps must increase strictly.
void deriveVelocities(NuScenesRecording& recording);
/// As above, for the annotations of these instances (tokens) only.
void deriveVelocities(NuScenesRecording& recording, const std::set<std::string>& instances);

/// Projects the recording to the ground plane, in the map frame. Times are timestamp_us * 1e-6 s.
/// Ego states are the box centre, `ego.center_offset` ahead of the recorded poses, with derived
/// velocities; their size is the recording's ego_size, or else `ego.size`. Agent states are box
/// centres; agent ids are instance tokens, in order of appearance; an agent keeps the size and
/// class of its first annotation. An unknown category becomes a static object. `map` may be null.
Scene toScene(const NuScenesRecording& recording, const EgoVehicle& ego,
              std::shared_ptr<const LaneMap> map);

}  // namespace forge
