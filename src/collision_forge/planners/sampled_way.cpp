#include "collision_forge/planners/sampled_way.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/map/reference_path.h"

namespace forge {

SampledWay::SampledWay(const Polyline& line) {
  const ReferencePath path(line);
  const int count = std::max(1, static_cast<int>(std::ceil(path.length() / kSpacing)));
  for (int i = 0; i <= count; ++i) {
    const Pose2 pose = path.at(kSpacing * i).pose;
    const double yaw = samples_.empty()
                           ? pose.yaw
                           : samples_.back().yaw + angleBetween(samples_.back().yaw, pose.yaw);
    samples_.push_back({pose.position(), pose.heading(), yaw});
  }
}

Pose2 SampledWay::at(double arc_length, double lateral) const {
  const double on_way = std::clamp(arc_length, 0.0, length());
  const double place = on_way / kSpacing;
  const std::size_t i = std::min(static_cast<std::size_t>(place), samples_.size() - 2);
  const double ratio = place - static_cast<double>(i);
  const Sample& a = samples_[i];
  const Sample& b = samples_[i + 1];
  const Vector2 heading = (a.heading + ratio * (b.heading - a.heading)).normalized();
  const Vector2 position = a.position + ratio * (b.position - a.position) +
                           (arc_length - on_way) * heading +
                           lateral * Vector2(-heading.y(), heading.x());
  return {position.x(), position.y(), wrapAngle(a.yaw + ratio * (b.yaw - a.yaw))};
}

SampledWay::Projection SampledWay::project(const Vector2& point) const {
  std::size_t nearest = 0;
  double least = squaredDistance(0, point);
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    const double squared = squaredDistance(i, point);
    if (squared < least) {
      nearest = i;
      least = squared;
    }
  }
  return projectAt(nearest, point);
}

SampledWay::Projection SampledWay::project(const Vector2& point, std::size_t hint) const {
  std::size_t nearest = std::min(hint, samples_.size() - 1);
  double least = squaredDistance(nearest, point);
  for (const int direction : {1, -1}) {
    for (std::size_t i = nearest;;) {
      if (direction > 0 ? i + 1 == samples_.size() : i == 0) break;
      i = direction > 0 ? i + 1 : i - 1;
      const double squared = squaredDistance(i, point);
      if (squared > least) break;
      nearest = i;
      least = squared;
    }
  }
  return projectAt(nearest, point);
}

SampledWay::Projection SampledWay::projectAt(std::size_t sample, const Vector2& point) const {
  const Sample& at = samples_[sample];
  const Vector2 offset = point - at.position;
  double along = at.heading.dot(offset);
  // Between samples the projection stays near its own, but for the straight ends.
  if (sample > 0) along = std::max(along, -kSpacing);
  if (sample + 1 < samples_.size()) along = std::min(along, kSpacing);
  const double lateral = at.heading.x() * offset.y() - at.heading.y() * offset.x();
  return {kSpacing * static_cast<double>(sample) + along, lateral, sample};
}

}  // namespace forge
