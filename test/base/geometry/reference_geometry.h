#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

/// A slow, independent reference implementation of the geometry functions: points, edges and
/// crossings of outlines, without separating axes, clipping or box frames.
namespace forge::reference {

using Points = std::vector<Vector2>;

inline double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners counter-clockwise, front left first, turned as complex numbers.
inline Points outline(const OrientedBox& box) {
  const std::complex<double> turn = std::polar(1.0, box.center.yaw);
  Points points;
  for (const auto& [along, across] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
    const std::complex<double> local(0.5 * along * box.size.length, 0.5 * across * box.size.width);
    const std::complex<double> turned = turn * local;
    points.emplace_back(box.center.x + turned.real(), box.center.y + turned.imag());
  }
  return points;
}

/// Returns true if the point is left of, or on, every edge of a counter-clockwise convex outline.
inline bool isInside(const Points& convex, const Vector2& point) {
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vector2& a = convex[i];
    if (cross(convex[(i + 1) % convex.size()] - a, point - a) < 0.0) {
      return false;
    }
  }
  return true;
}

inline double pointToSegment(const Vector2& point, const Vector2& a, const Vector2& b) {
  const double squared = (b - a).squaredNorm();
  const double ratio = squared > 0.0 ? (point - a).dot(b - a) / squared : 0.0;
  if (ratio <= 0.0) {
    return (point - a).norm();
  }
  return ratio >= 1.0 ? (point - b).norm() : std::abs(cross(b - a, point - a)) / (b - a).norm();
}

/// Adds the intersection of two segments, if any.
inline void addCrossing(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d,
                        Points& crossings) {
  const double denominator = cross(b - a, d - c);
  if (std::abs(denominator) < 1e-12) {
    return;
  }
  const double on_ab = cross(c - a, d - c) / denominator;
  const double on_cd = cross(c - a, b - a) / denominator;
  if (on_ab >= 0.0 && on_ab <= 1.0 && on_cd >= 0.0 && on_cd <= 1.0) {
    crossings.push_back(a + on_ab * (b - a));
  }
}

/// Returns all corners of either outline inside the other, and all crossings of their edges.
inline Points sharedPoints(const Points& p, const Points& q) {
  Points shared;
  std::copy_if(p.begin(), p.end(), std::back_inserter(shared),
               [&](const Vector2& point) { return isInside(q, point); });
  std::copy_if(q.begin(), q.end(), std::back_inserter(shared),
               [&](const Vector2& point) { return isInside(p, point); });
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      addCrossing(p[i], p[(i + 1) % p.size()], q[j], q[(j + 1) % q.size()], shared);
    }
  }
  return shared;
}

inline double distance(const OrientedBox& a, const OrientedBox& b) {
  const Points p = outline(a);
  const Points q = outline(b);
  if (!sharedPoints(p, q).empty()) {
    return 0.0;
  }
  double best = (p[0] - q[0]).norm();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      best = std::min({best, pointToSegment(p[i], q[j], q[(j + 1) % 4]),
                       pointToSegment(q[i], p[j], p[(j + 1) % 4])});
    }
  }
  return best;
}

/// Area of the intersection, which is convex: sorts its vertices around their mean.
inline double intersectionArea(const OrientedBox& a, const OrientedBox& b) {
  Points shared = sharedPoints(outline(a), outline(b));
  Vector2 mean = Vector2::Zero();
  for (const Vector2& point : shared) {
    mean += point / static_cast<double>(shared.size());
  }
  const auto angle = [&](const Vector2& p) {
    return std::atan2(p.y() - mean.y(), p.x() - mean.x());
  };
  std::sort(shared.begin(), shared.end(),
            [&](const Vector2& p, const Vector2& q) { return angle(p) < angle(q); });
  double area = 0.0;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    area += 0.5 * cross(shared[i] - mean, shared[(i + 1) % shared.size()] - mean);
  }
  return area;
}

/// Seeded random numbers for tests.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Pose2 pose(double reach) {
    return {between(-reach, reach), between(-reach, reach), between(-M_PI, M_PI)};
  }
  OrientedBox box(double reach) { return {pose(reach), {between(0.1, 12.0), between(0.1, 4.0)}}; }

 private:
  std::mt19937 engine_;
};

}  // namespace forge::reference
