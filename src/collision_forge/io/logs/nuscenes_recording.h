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
  std::int64_t timestamp_us = 0;                          ///< microseconds
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< m
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

/// One annotated object in one frame. Global map frame, metres.
struct NuScenesAnnotation {
  std::string token;
  std::string instance;                 ///< token of the object, equal in all frames
  std::string category;                 ///< for instance "vehicle.car"
  std::vector<std::string> attributes;  ///< for instance "vehicle.moving"
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< centre of the box
  Eigen::Vector3d size = Eigen::Vector3d::Zero();         ///< length, width, height (all > 0)
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
};

/// A keyframe (sample) with its annotations.
struct NuScenesFrame {
  std::string token;  ///< token of the sample
  std::int64_t timestamp_us = 0;
  std::vector<NuScenesAnnotation> annotations;  ///< in the table's order
};

/// Everything recorded in one scene, before it is flattened to the ground plane.
struct NuScenesRecording {
  std::string name;
  std::string description;
  std::string location;                    ///< name of the map, for instance "boston-seaport"
  std::optional<BoxSize> ego_size;         ///< of the ego's box, if the log contains it
  std::vector<NuScenesEgoPose> ego_poses;  ///< timestamps strictly increasing
  std::vector<NuScenesFrame> frames;       ///< timestamps strictly increasing
  std::vector<TrafficLight> lights;        ///< as Scene::lights
};

/// Returns the heading (rad) of the rotated x axis, projected on the ground.
double yawOf(const Eigen::Quaterniond& rotation);

/// Returns the class of a category ("vehicle.bus.rigid" -> kBus); nullopt for an unknown one.
std::optional<AgentClass> agentClassOfCategory(const std::string& category);

/// As above; categories that nuScenes does not have are looked up in `others` (in lower case,
/// without subcategories).
std::optional<AgentClass> agentClassOfCategory(const std::string& category,
                                               const std::map<std::string, AgentClass>& others);

/// Returns the most general category of a class, as "vehicle.car".
const char* categoryOf(AgentClass agent_class);

/// Sets every annotation's velocity as the nuScenes devkit does: from the instance's previous to
/// its next frame (at most 3 s apart), one-sided at the ends of its track (at most 1.5 s). If the
/// devkit would return NaN: one-sided to the nearer neighbour within 1.5 s, else zero.
void deriveVelocities(NuScenesRecording& recording);
/// As above, for the annotations of these instances only.
void deriveVelocities(NuScenesRecording& recording, const std::set<std::string>& instances);

/// Projects the recording to the ground plane. Times are timestamp_us * 1e-6 s. Ego states are the
/// box centre, `ego.center_offset` ahead of the recorded poses; their size is the recording's
/// ego_size, or else `ego.size`. Agent ids are instance tokens, in order of appearance; an agent
/// keeps the size of its first annotation. An unknown category becomes a static object.
Scene toScene(const NuScenesRecording& recording, const EgoVehicle& ego,
              std::shared_ptr<const LaneMap> map);

}  // namespace forge
