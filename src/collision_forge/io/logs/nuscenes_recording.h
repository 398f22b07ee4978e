#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Pose of base_link in the global map frame, as recorded with one sweep of LIDAR_TOP.
struct NuScenesEgoPose {
  std::int64_t timestamp_us = 0;
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

/// One object in one frame. Global map frame, metres.
struct NuScenesAnnotation {
  std::string token;
  std::string instance;                 ///< token of the object, the same in every frame
  std::string category;                 ///< for instance "vehicle.car"
  std::vector<std::string> attributes;  ///< for instance "vehicle.moving"
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< middle of the box
  Eigen::Vector3d size = Eigen::Vector3d::Zero();         ///< length, width, height (all > 0)
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
};

/// A keyframe.
struct NuScenesFrame {
  std::string token;  ///< of the sample
  std::int64_t timestamp_us = 0;
  std::vector<NuScenesAnnotation> annotations;  ///< in the table's order
};

/// Everything recorded in one scene, before it is flattened to the ground plane.
struct NuScenesRecording {
  std::string name;
  std::string description;
  std::string location;                    ///< name of the map, for instance "boston-seaport"
  std::vector<NuScenesEgoPose> ego_poses;  ///< timestamps strictly increasing
  std::vector<NuScenesFrame> frames;       ///< timestamps strictly increasing
};

/// Heading of the x axis on the ground, radians.
double yawOf(const Eigen::Quaterniond& rotation);

/// The class for a category's name ("vehicle.bus.rigid" -> kBus); empty for an unknown one.
std::optional<AgentClass> agentClassOfCategory(const std::string& category);

/// The plainest category of a class, as "vehicle.car".
const char* categoryOf(AgentClass agent_class);

/// Fills in every annotation's velocity as the nuScenes devkit does: from the instance's previous
/// frame to its next (at most 3 s apart), at the ends of its track one-sided (at most 1.5 s). Where
/// the devkit answers NaN: one-sided towards the nearer neighbour within 1.5 s, else zero.
void deriveVelocities(NuScenesRecording& recording);

/// The recording on the ground plane. Times are timestamp_us * 1e-6 s; the ego's states are the
/// middle of its box, `ego.center_offset` ahead of the recorded poses; agents' ids are instance
/// tokens, in the order they appear, each as large as first annotated. An unknown category becomes
/// a static object, and `warnings`, if given, gets a line for it.
Scene toScene(const NuScenesRecording& recording, const EgoVehicle& ego,
              std::shared_ptr<const LaneMap> map, std::vector<std::string>* warnings = nullptr);

}  // namespace forge
