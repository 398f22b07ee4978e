#include "collision_forge/base/map/reference_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace forge {
namespace {

constexpr int kSmoothing = 2;  // neighbours on each side in the moving average
constexpr int kSmoothingRounds = 2;
constexpr double kTightest = 0.8;  // largest offset of a parallel path, as share of a bend's radius
constexpr double kMinBend = 1e-3;  // 1/m; lower bound of curvatures()

/// Returns points of the line from end to end, evenly spaced by about 1 m.
std::vector<Vector2> spread(const Polyline& line) {
  const int count = std::max(1, static_cast<int>(std::lround(line.length())));
  std::vector<Vector2> points;
  for (int i = 0; i <= count; ++i)
    points.push_back(line.poseAt(line.length() * i / count).position());
  return points;
}

void smooth(std::vector<Vector2>& points) {
  const std::vector<Vector2> rough = points;
  const int count = static_cast<int>(rough.size());
  for (int i = 1; i + 1 < count; ++i) {
    const int reach = std::min({kSmoothing, i, count - 1 - i});
    Vector2 sum = Vector2::Zero();
    for (int j = i - reach; j <= i + reach; ++j) sum += rough[static_cast<std::size_t>(j)];
    points[static_cast<std::size_t>(i)] = sum / (2.0 * reach + 1.0);
  }
}

}  // namespace

ReferencePath::ReferencePath(double spacing, std::vector<Vector2> controls)
    : spacing_(spacing), controls_(std::move(controls)) {
  const bool is_usable = controls_.size() >= kMinControls && std::isfinite(spacing_) &&
                         spacing_ > 0.0 &&
                         std::all_of(controls_.begin(), controls_.end(),
                                     [](const Vector2& p) { return p.allFinite(); });
  if (!is_usable) {
    throw std::invalid_argument("reference path with " + std::to_string(controls_.size()) +
                                " points, " + std::to_string(spacing_) +
                                " m apart, is invalid: it needs " + std::to_string(kMinControls) +
                                " finite points or more and a spacing above 0");
  }
  measureControls();
}

ReferencePath::ReferencePath(const Polyline& line) {
  std::vector<Vector2> points = spread(line);
  for (int round = 0; round < kSmoothingRounds; ++round) smooth(points);
  setControls(Polyline(points));
}

void ReferencePath::setControls(const Polyline& line) {
  std::vector<Vector2> points = spread(line);
  spacing_ = line.length() / static_cast<double>(points.size() - 1);
  // The mirrored neighbour of each end makes the spline end there with zero curvature.
  points.insert(points.begin(), 2.0 * points[0] - points[1]);
  points.push_back(2.0 * points.back() - points[points.size() - 2]);
  controls_ = std::move(points);
  measureControls();
}

void ReferencePath::measureControls() {
  constexpr double kRounding = 1e-6;  // m
  widest_ = kRounding;
  for (std::size_t i = 1; i < controls_.size(); ++i) {
    widest_ = std::max(widest_, (controls_[i] - controls_[i - 1]).norm() + kRounding);
  }
}

ReferencePath ReferencePath::beside(double across) const {
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(length())));
  std::vector<Vector2> points;
  for (std::size_t i = 0; i <= count; ++i) {
    const PathPoint place = at(length() * static_cast<double>(i) / static_cast<double>(count));
    // In a tighter bend the parallel path would run backwards.
    if (place.curvature * across > kTightest) continue;
    points.push_back(compose(place.pose, {0.0, across, 0.0}).position());
  }
  ReferencePath path = *this;
  path.setControls(Polyline(points));
  return path;
}

ReferencePath::PathPoint ReferencePath::at(double arc_length) const {
  const double on_path = std::clamp(arc_length, 0.0, length());
  const double index = on_path / spacing_;
  const std::size_t i = std::min(static_cast<std::size_t>(index), controls_.size() - 4);
  const double u = index - static_cast<double>(i);
  const double v = 1.0 - u;
  const Vector2& a = controls_[i];
  const Vector2& b = controls_[i + 1];
  const Vector2& c = controls_[i + 2];
  const Vector2& d = controls_[i + 3];
  const Vector2 position = (v * v * v * a + (3.0 * u * u * u - 6.0 * u * u + 4.0) * b +
                            (3.0 * v * v * v - 6.0 * v * v + 4.0) * c + u * u * u * d) /
                           6.0;
  const Vector2 velocity =
      0.5 * (v * v * (b - a) + (1.0 + 2.0 * u * v) * (c - b) + u * u * (d - c));
  const Vector2 bend = v * (a - 2.0 * b + c) + u * (b - 2.0 * c + d);
  const double speed = velocity.norm();
  const Vector2 heading = velocity / speed;
  const Vector2 place = position + (arc_length - on_path) * heading;
  const double cross = velocity.x() * bend.y() - velocity.y() * bend.x();
  const Pose2 pose{place.x(), place.y(), std::atan2(velocity.y(), velocity.x())};
  if (arc_length != on_path) return {pose, heading, 0.0, 1.0};
  return {pose, heading, cross / (speed * speed * speed), speed / spacing_};
}

std::vector<double> ReferencePath::curvatures() const {
  std::vector<double> found(static_cast<std::size_t>(length() / kBendSpacing) + 1);
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i] = std::max(kMinBend, std::abs(at(static_cast<double>(i) * kBendSpacing).curvature));
  }
  return found;
}

/// Returns the index of the first of the closest controls, without the ends. Passes over controls
/// that are farther away than some other one, because neighbours are at most widest_ apart.
std::size_t ReferencePath::closestControl(const Vector2& point) const {
  constexpr std::size_t kStride = 8;
  const auto squared = [&](std::size_t i) { return (controls_[i] - point).squaredNorm(); };
  double bound = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i + 1 < controls_.size(); i += kStride) {
    bound = std::min(bound, squared(i));
  }
  const double bound_distance = std::sqrt(bound);
  std::size_t closest = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i + 1 < controls_.size();) {
    const double distance = squared(i);
    if (distance < least) closest = i;
    least = std::min(least, distance);
    const double excess = distance > bound ? std::sqrt(distance) - bound_distance : 0.0;
    i += std::max<std::size_t>(1, static_cast<std::size_t>(excess / widest_));
  }
  return closest;
}

double ReferencePath::project(const Vector2& point) const {
  const double arc_length = spacing_ * static_cast<double>(closestControl(point) - 1);
  const PathPoint place = at(arc_length);
  return arc_length + place.heading.dot(point - place.pose.position());
}

PathPose ReferencePath::frenetOf(const Pose2& pose) const {
  const double along = project(pose.position());
  const Pose2 local = relativeTo(at(along).pose, pose);
  return {along + local.x, local.y, local.yaw};
}

}  // namespace forge
