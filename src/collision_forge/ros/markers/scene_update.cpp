#include "collision_forge/ros/markers/scene_update.h"

#include <cstdint>

#include "collision_forge/ros/messages/ros_bytes.h"

namespace forge {
namespace {

// Constants of the message.
constexpr std::uint8_t kDeleteAll = 1;
constexpr std::uint8_t kLineList = 2;

/// Types after SceneUpdate itself, each a name and its fields.
constexpr const char* kTypes[][2] = {
    {"foxglove_msgs/SceneEntityDeletion",
     "time timestamp\nuint8 MATCHING_ID=0\nuint8 ALL=1\nuint8 type\nstring id\n"},
    {"foxglove_msgs/SceneEntity",
     "time timestamp\nstring frame_id\nstring id\nduration lifetime\nbool frame_locked\n"
     "foxglove_msgs/KeyValuePair[] metadata\nfoxglove_msgs/ArrowPrimitive[] arrows\n"
     "foxglove_msgs/CubePrimitive[] cubes\nfoxglove_msgs/SpherePrimitive[] spheres\n"
     "foxglove_msgs/CylinderPrimitive[] cylinders\nfoxglove_msgs/LinePrimitive[] lines\n"
     "foxglove_msgs/TriangleListPrimitive[] triangles\nfoxglove_msgs/TextPrimitive[] texts\n"
     "foxglove_msgs/ModelPrimitive[] models\n"},
    {"foxglove_msgs/KeyValuePair", "string key\nstring value\n"},
    {"foxglove_msgs/ArrowPrimitive",
     "geometry_msgs/Pose pose\nfloat64 shaft_length\nfloat64 shaft_diameter\nfloat64 head_length\n"
     "float64 head_diameter\nfoxglove_msgs/Color color\n"},
    {"foxglove_msgs/CubePrimitive",
     "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 size\nfoxglove_msgs/Color color\n"},
    {"foxglove_msgs/SpherePrimitive",
     "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 size\nfoxglove_msgs/Color color\n"},
    {"foxglove_msgs/CylinderPrimitive",
     "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 size\nfloat64 bottom_scale\n"
     "float64 top_scale\nfoxglove_msgs/Color color\n"},
    {"foxglove_msgs/LinePrimitive",
     "uint8 LINE_STRIP=0\nuint8 LINE_LOOP=1\nuint8 LINE_LIST=2\nuint8 type\n"
     "geometry_msgs/Pose pose\nfloat64 thickness\nbool scale_invariant\n"
     "geometry_msgs/Point[] points\nfoxglove_msgs/Color color\nfoxglove_msgs/Color[] colors\n"
     "uint32[] indices\n"},
    {"foxglove_msgs/TriangleListPrimitive",
     "geometry_msgs/Pose pose\ngeometry_msgs/Point[] points\nfoxglove_msgs/Color color\n"
     "foxglove_msgs/Color[] colors\nuint32[] indices\n"},
    {"foxglove_msgs/TextPrimitive",
     "geometry_msgs/Pose pose\nbool billboard\nfloat64 font_size\nbool scale_invariant\n"
     "foxglove_msgs/Color color\nstring text\n"},
    {"foxglove_msgs/ModelPrimitive",
     "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 scale\nfoxglove_msgs/Color color\n"
     "bool override_color\nstring url\nstring media_type\nuint8[] data\n"},
    {"foxglove_msgs/Color", "float64 r\nfloat64 g\nfloat64 b\nfloat64 a\n"},
    {"geometry_msgs/Pose", "Point position\nQuaternion orientation\n"},
    {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
    {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
};

std::string makeDefinition() {
  constexpr std::size_t kRule = 80;  // signs in the line between two types
  std::string text =
      "foxglove_msgs/SceneEntityDeletion[] deletions\nfoxglove_msgs/SceneEntity[] entities\n";
  for (const auto& [name, fields] : kTypes) {
    text += std::string(kRule, '=') + "\nMSG: " + name + "\n" + fields;
  }
  return text;
}

template <typename... Fields>
void append(std::string& bytes, const Fields&... fields) {
  (appendRosBytes(bytes, fields), ...);
}

void appendColor(std::string& bytes, const colors::MarkerColor& color) {
  append(bytes, double{color.red}, double{color.green}, double{color.blue}, double{color.alpha});
}

template <typename Items>
void appendCount(std::string& bytes, const Items& items) {
  append(bytes, static_cast<std::uint32_t>(items.size()));
}

void appendNone(std::string& bytes) { append(bytes, std::uint32_t{0}); }

void appendSolids(std::string& bytes, const std::vector<SolidPrimitive>& solids) {
  appendCount(bytes, solids);
  for (const SolidPrimitive& solid : solids) {
    append(bytes, solid.pose, solid.size);
    appendColor(bytes, solid.color);
  }
}

geometry_msgs::Pose unturned(const geometry_msgs::Point& place = {}) {
  geometry_msgs::Pose pose;
  pose.position = place;
  pose.orientation.w = 1.0;
  return pose;
}

void appendLines(std::string& bytes, const std::vector<LinePrimitive>& lines) {
  appendCount(bytes, lines);
  for (const LinePrimitive& line : lines) {
    const bool scale_invariant = false;
    append(bytes, kLineList, unturned(), line.thickness, scale_invariant, line.points);
    appendColor(bytes, line.color);
    appendNone(bytes);  // colors, a point
    appendNone(bytes);  // indices
  }
}

void appendTexts(std::string& bytes, const std::vector<TextPrimitive>& texts) {
  appendCount(bytes, texts);
  for (const TextPrimitive& text : texts) {
    const bool billboard = true;
    const bool scale_invariant = false;
    append(bytes, unturned(text.middle), billboard, text.letter_height, scale_invariant);
    appendColor(bytes, text.color);
    append(bytes, text.text);
  }
}

void appendEntity(std::string& bytes, const SceneUpdate& update, const SceneEntity& entity) {
  const bool frame_locked = true;
  append(bytes, update.stamp, update.frame_id, entity.id, ros::Duration(), frame_locked);
  appendCount(bytes, entity.metadata);
  for (const auto& [key, value] : entity.metadata) append(bytes, key, value);
  appendNone(bytes);  // arrows
  appendSolids(bytes, entity.cubes);
  appendSolids(bytes, entity.spheres);
  appendNone(bytes);  // cylinders
  appendLines(bytes, entity.lines);
  appendNone(bytes);  // triangles
  appendTexts(bytes, entity.texts);
  appendNone(bytes);  // models
}

}  // namespace

const std::string& sceneUpdateDefinition() {
  static const std::string text = makeDefinition();
  return text;
}

std::string toRosBytes(const SceneUpdate& update) {
  std::string bytes;
  append(bytes, std::uint32_t{1}, update.stamp, kDeleteAll, std::string());
  appendCount(bytes, update.entities);
  for (const SceneEntity& entity : update.entities) appendEntity(bytes, update, entity);
  return bytes;
}

}  // namespace forge
