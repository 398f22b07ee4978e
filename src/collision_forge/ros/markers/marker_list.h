#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/ros/markers/marker_colors.h"

namespace forge {

/// Builds a MarkerArray. It starts with DELETEALL, so that it replaces all earlier markers. Skips
/// non-finite markers and markers without extent, which RViz rejects. Heights are m above ground.
class MarkerList {
 public:
  explicit MarkerList(const std_msgs::Header& header);

  /// Adds a solid box that stands on the ground, with an arrow head on top for its heading.
  void addBox(const std::string& name_space, const OrientedBox& box, double height,
              const colors::MarkerColor& color);
  /// Adds a flat box whose bottom is at height `z` (m).
  void addSlab(const std::string& name_space, const OrientedBox& box, double z,
               const colors::MarkerColor& color);
  /// Adds a flat disc. `diameter` in m.
  void addDisc(const std::string& name_space, const Vector2& center, double diameter, double z,
               const colors::MarkerColor& color);
  /// Adds a text that faces the viewer, centred at `center`. `letter_height` in m.
  void addText(const std::string& name_space, const std::string& text, const Vector2& center,
               double letter_height, double z, const colors::MarkerColor& color);
  /// Adds lines, two points each. `width` in m.
  void addLines(const std::string& name_space, const std::vector<Vector2>& points, double width,
                double z, const colors::MarkerColor& color);
  /// Adds triangles, three points each.
  void addTriangles(const std::string& name_space, const std::vector<Vector2>& points, double z,
                    const colors::MarkerColor& color);

  /// Returns the array; this object is then empty.
  visualization_msgs::MarkerArray take() { return std::move(markers_); }

 private:
  visualization_msgs::Marker& add(const std::string& name_space, std::int32_t type,
                                  const colors::MarkerColor& color);
  void addCuboid(const std::string& name_space, const OrientedBox& box, double bottom, double top,
                 const colors::MarkerColor& color);
  void addGroups(const std::string& name_space, std::int32_t type, std::ptrdiff_t group_size,
                 const std::vector<Vector2>& points, double z, const geometry_msgs::Vector3& scale,
                 const colors::MarkerColor& color);

  std_msgs::Header header_;
  visualization_msgs::MarkerArray markers_;
};

/// Appends the segments of `polyline`, two points each.
void appendPolyline(const std::vector<Vector2>& polyline, std::vector<Vector2>& lines);

/// Appends the four sides of a box, two points each.
void appendOutline(const OrientedBox& box, std::vector<Vector2>& lines);

}  // namespace forge
