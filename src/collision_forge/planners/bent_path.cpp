#include "collision_forge/planners/bent_path.h"

#include <cmath>

namespace forge {

BentPath::BentPath(const Polyline& line, double from, const Vector2& vehicle, double length,
                   double spacing)
    : line_(line),
      from_(from),
      offset_(vehicle - line.poseAt(from).position()),
      length_(length),
      spacing_(spacing) {}

Pose2 BentPath::at(double arc_length) const {
  const Vector2 position = pointAt(arc_length);
  const Vector2 along = pointAt(arc_length + spacing_) - position;
  return {position.x(), position.y(), std::atan2(along.y(), along.x())};
}

Vector2 BentPath::pointAt(double arc_length) const {
  const double faded = arc_length / length_;
  return line_.poseAt(from_ + arc_length).position() + std::exp(-faded * faded) * offset_;
}

}  // namespace forge
