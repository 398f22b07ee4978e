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
/// non-finite markers and markers without extent, which RViz rejects; of lines and triangles only
/// the non-finite ones. Positions are in the header's frame, m; heights `z` are m above ground.
/// `name_space`: namespace of the marker; ids count from 0 over the whole array.
class MarkerList {
 public:
  /// `header`: frame and stamp of all markers.
  explicit MarkerList(const std_msgs::Header& header);

  /// Adds a solid box of `height` (m) that stands on the ground, with an arrow head on top for its
  /// heading (namespace NAME_heading).
  void addBox(const std::string& name_space, const OrientedBox& box, double height,
              const colors::MarkerColor& color);
  /// Adds a flat box whose bottom is at height `z` (m).
  void addSlab(const std::string& name_space, const OrientedBox& box, double z,
               const colors::MarkerColor& color);
  /// Adds a flat disc whose middle is at height `z`. `diameter` in m, above 0.
  void addDisc(const std::string& name_space, const Vector2& center, double diameter, double z,
               const colors::MarkerColor& color);
  /// Adds a text that faces the viewer, centred at `center`. `letter_height` in m. Adds nothing for
  /// an empty text.
  void addText(const std::string& name_space, const std::string& text, const Vector2& center,
               double letter_height, double z, const colors::MarkerColor& color);
  /// Adds lines, two consecutive points each (an even number). `width` in m.
  void addLines(const std::string& name_space, const std::vector<Vector2>& points, double width,
                double z, const colors::MarkerColor& color);
  /// Adds triangles, three consecutive points each (a multiple of three).
  void addTriangles(const std::string& name_space, const std::vector<Vector2>& points, double z,
                    const colors::MarkerColor& color);

  /// Returns the array; this object must not be used afterwards.
  visualization_msgs::MarkerArray take() { return std::move(markers_); }

 private:
  /// Adds a marker of this `type` (a constant of Marker); the reference is valid until the next
  /// add.
  visualization_msgs::Marker& add(const std::string& name_space, std::int32_t type,
                                  const colors::MarkerColor& color);
  void addCuboid(const std::string& name_space, const OrientedBox& box, double bottom, double top,
                 const colors::MarkerColor& color);
  /// Adds the groups of `group_size` points that are finite as one marker; nothing without any.
  void addGroups(const std::string& name_space, std::int32_t type, std::ptrdiff_t group_size,
                 const std::vector<Vector2>& points, double z, const geometry_msgs::Vector3& scale,
                 const colors::MarkerColor& color);

  std_msgs::Header header_;
  visualization_msgs::MarkerArray markers_;
};

/// Appends the segments of `polyline` to `lines`, two points each; none for fewer than two points.
void appendPolyline(const std::vector<Vector2>& polyline, std::vector<Vector2>& lines);

/// Appends the four sides of a box to `lines`, two points each.
void appendOutline(const OrientedBox& box, std::vector<Vector2>& lines);

}  // namespace forge
