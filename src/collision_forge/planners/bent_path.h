#pragma once

#include <vector>

#include "collision_forge/geometry/polyline.h"

namespace forge {

/// A line bent so that it starts at a vehicle beside it: at arc length s the offset between the two
/// has faded to exp(-s^2 / length^2) of it.
class BentPath {
 public:
  /// `line` must outlive the path. `from` is the vehicle's arc length on it; `spacing` is the
  /// distance (m) that headings are told over.
  BentPath(const Polyline& line, double from, const Vector2& vehicle, double length,
           double spacing);

  /// `arc_length` metres of line after the vehicle.
  Pose2 at(double arc_length) const;

 private:
  Vector2 pointAt(double arc_length) const;

  const Polyline& line_;
  double from_;
  Vector2 offset_;
  double length_;
  double spacing_;
};

}  // namespace forge
