#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Vector3.h>
#include <ros/time.h>

#include <string>
#include <utility>
#include <vector>

#include "collision_forge/ros/markers/marker_colors.h"

/// The part of foxglove_msgs/SceneUpdate, 3D scenes in Foxglove and Lichtblick, that this package
/// writes. Debian does not package this message.
namespace forge {

inline constexpr char kSceneUpdateType[] = "foxglove_msgs/SceneUpdate";
inline constexpr char kSceneUpdateMd5[] = "59bc58a3679e8fc3874b14b39276e03a";
/// Returns the definition text with all nested types, as in a connection's header.
const std::string& sceneUpdateDefinition();

/// CubePrimitive and SpherePrimitive, which have the same fields.
struct SolidPrimitive {
  geometry_msgs::Pose pose;     ///< middle of the solid
  geometry_msgs::Vector3 size;  ///< m
  colors::MarkerColor color;
};

/// A LinePrimitive of the type LINE_LIST.
struct LinePrimitive {
  double thickness = 0.0;                    ///< m
  std::vector<geometry_msgs::Point> points;  ///< two per line
  colors::MarkerColor color;
};

/// A text that always faces the viewer.
struct TextPrimitive {
  geometry_msgs::Point middle;
  double letter_height = 0.0;  ///< m
  colors::MarkerColor color;
  std::string text;
};

/// Objects with a common id; replaces the entity with the same id, and stays until deleted.
struct SceneEntity {
  std::string id;                                             ///< unique within the topic
  std::vector<std::pair<std::string, std::string>> metadata;  ///< shown when the entity is selected
  std::vector<SolidPrimitive> cubes;
  std::vector<SolidPrimitive> spheres;
  std::vector<LinePrimitive> lines;
  std::vector<TextPrimitive> texts;
};

/// The complete content of its topic: earlier entities are deleted.
struct SceneUpdate {
  ros::Time stamp;
  std::string frame_id;
  std::vector<SceneEntity> entities;
};

/// Serialises the message in ROS 1 format.
std::string toRosBytes(const SceneUpdate& update);

}  // namespace forge
