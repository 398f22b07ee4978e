#pragma once

#include <vector>

#include "collision_forge/geometry/polyline.h"

namespace forge {

/// A line in even steps, for fast look-up and for following points that move along it. Global map
/// frame; beyond either end it goes straight on.
class SampledWay {
 public:
  static constexpr double kSpacing = 0.5;  ///< metres

  struct Projection {
    double arc_length = 0.0;  ///< metres, negative before the start
    double lateral = 0.0;     ///< metres, positive to the left
    std::size_t sample = 0;   ///< the nearest; a hint for the next projection
  };

  /// Smoothed as ReferencePath does.
  explicit SampledWay(const Polyline& line);

  double length() const { return kSpacing * static_cast<double>(samples_.size() - 1); }

  /// `lateral` metres left of the way; yaw is the way's, wrapped.
  Pose2 at(double arc_length, double lateral) const;
  /// Unit vector along the way.
  const Vector2& headingAt(std::size_t sample) const { return samples_[sample].heading; }

  Projection project(const Vector2& point) const;
  /// Of a point that moved since it was at the sample `hint`: the nearest sample that can be
  /// reached from there without going away from the point.
  Projection project(const Vector2& point, std::size_t hint) const;

 private:
  struct Sample {
    Vector2 position;
    Vector2 heading;
    double yaw = 0.0;  // not wrapped: continuous along the way
  };

  double squaredDistance(std::size_t sample, const Vector2& point) const {
    return (samples_[sample].position - point).squaredNorm();
  }
  Projection projectAt(std::size_t sample, const Vector2& point) const;

  std::vector<Sample> samples_;
};

}  // namespace forge
