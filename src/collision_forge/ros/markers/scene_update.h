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
/// writes. Debian does not package this message. Positions are in SceneUpdate::frame_id, m; z is
/// the height above ground.
namespace forge {

inline constexpr char kSceneUpdateType[] = "foxglove_msgs/SceneUpdate";
inline constexpr char kSceneUpdateMd5[] = "59bc58a3679e8fc3874b14b39276e03a";  ///< MD5 of the type
/// Returns the definition text of SceneUpdate with all nested types, as in a connection's header.
const std::string& sceneUpdateDefinition();

/// CubePrimitive and SpherePrimitive, which have the same fields: a cuboid or an ellipsoid.
struct SolidPrimitive {
  geometry_msgs::Pose pose;     ///< middle of the solid; a unit quaternion
  geometry_msgs::Vector3 size;  ///< m, full extent along the axes of `pose`
  colors::MarkerColor color;
};

/// A LinePrimitive of the type LINE_LIST.
struct LinePrimitive {
  double thickness = 0.0;                    ///< m
  std::vector<geometry_msgs::Point> points;  ///< two consecutive points per line
  colors::MarkerColor color;
};

/// A text that always faces the viewer.
struct TextPrimitive {
  geometry_msgs::Point middle;  ///< centre of the text
  double letter_height = 0.0;   ///< m
  colors::MarkerColor color;
  std::string text;
};

/// Objects with a common id; replaces the entity with the same id, and stays until deleted.
struct SceneEntity {
  std::string id;  ///< unique within the topic
  /// Names and values that the viewer shows when the entity is selected.
  std::vector<std::pair<std::string, std::string>> metadata;
  std::vector<SolidPrimitive> cubes;
  std::vector<SolidPrimitive> spheres;
  std::vector<LinePrimitive> lines;
  std::vector<TextPrimitive> texts;
};

/// The complete content of its topic: earlier entities are deleted.
struct SceneUpdate {
  ros::Time stamp;       ///< of all entities
  std::string frame_id;  ///< of all entities
  std::vector<SceneEntity> entities;
};

/// Returns the message as ROS 1 serialises it: one deletion of all entities, then the entities, in
/// their order, without an end of their lifetime.
std::string toRosBytes(const SceneUpdate& update);

}  // namespace forge
