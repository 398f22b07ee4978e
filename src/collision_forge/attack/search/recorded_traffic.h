#pragma once

#include <optional>
#include <vector>

#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Boxes of ego and other agents at equally spaced instants around t0, for many queries.
class RecordedTraffic {
 public:
  /// Uses `past` from its first frame to t0, then the agents of `future`, without the ego, up to
  /// `end` s after t0. `interval` in s.
  RecordedTraffic(const Snapshot& past, const Future& future, double end, double interval);

  /// Instants are numbered from t0: 0 is t0, negative before it.
  int firstInstant() const { return first_; }
  int lastInstant() const { return first_ + static_cast<int>(bodies_.size()) - 1; }
  /// Returns the time between two instants, s.
  double interval() const { return interval_; }

  /// Returns true if the box, enlarged by `clearance` (m) on all sides, overlaps an agent or the
  /// ego. False outside the known instants.
  bool touches(const Pose2& pose, const BoxSize& size, int instant, double clearance) const;

  /// Returns true if a vehicle occludes `place` from the ego: the line from the ego's box centre to
  /// it crosses the vehicle's box. False if the ego is unknown.
  bool hides(const Vector2& place, int instant) const;

  /// Returns the distance (m) from the ego's box centre; empty if the ego is unknown.
  std::optional<double> distanceToEgo(const Vector2& place, int instant) const;

 private:
  struct Body {
    OrientedBox box;
    double radius;  // m, circumscribed circle
    bool is_ego;
    bool hides_others;
  };
  const std::vector<Body>* at(int instant) const;
  static const Body* egoOf(const std::vector<Body>* bodies);

  double interval_;
  int first_;
  std::vector<std::vector<Body>> bodies_;  // [instant], ego first
};

}  // namespace forge
