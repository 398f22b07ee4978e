#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Vector3.h>
#include <ros/time.h>

#include <string>
#include <utility>
#include <vector>

#include "collision_forge/ros/markers/marker_colors.h"

/// The message foxglove_msgs/SceneUpdate, which Foxglove and Lichtblick show in 3D, as far as it is
/// used here. Debian has no package of it.
namespace forge {

inline constexpr char kSceneUpdateType[] = "foxglove_msgs/SceneUpdate";
inline constexpr char kSceneUpdateMd5[] = "59bc58a3679e8fc3874b14b39276e03a";
/// Returns the message definition with all nested types, as in a connection's header.
const std::string& sceneUpdateDefinition();

/// CubePrimitive and SpherePrimitive, which have the same fields.
struct SolidPrimitive {
  geometry_msgs::Pose pose;     ///< of its middle
  geometry_msgs::Vector3 size;  ///< m
  colors::MarkerColor color;
};

/// A LinePrimitive of the type LINE_LIST.
struct LinePrimitive {
  double thickness = 0.0;                    ///< m
  std::vector<geometry_msgs::Point> points;  ///< two a line
  colors::MarkerColor color;
};

/// A text that turns to the viewer.
struct TextPrimitive {
  geometry_msgs::Point middle;
  double letter_height = 0.0;  ///< m
  colors::MarkerColor color;
  std::string text;
};

/// Replaces the entity of the same id on its topic, and stays until it is deleted.
struct SceneEntity {
  std::string id;
  std::vector<std::pair<std::string, std::string>> metadata;  ///< shown when it is selected
  std::vector<SolidPrimitive> cubes;
  std::vector<SolidPrimitive> spheres;
  std::vector<LinePrimitive> lines;
  std::vector<TextPrimitive> texts;
};

/// The complete content of a topic: deletes all earlier entities.
struct SceneUpdate {
  ros::Time stamp;
  std::string frame_id;
  std::vector<SceneEntity> entities;
};

/// Returns the message as ROS 1 serialises it.
std::string toRosBytes(const SceneUpdate& update);

}  // namespace forge
