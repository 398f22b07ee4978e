#pragma once

#include <optional>
#include <vector>

#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Boxes of ego and other agents at equally spaced instants around t0, for many queries. Places are
/// in the map frame. Immutable.
class RecordedTraffic {
 public:
  /// Uses `past` from its first frame to t0, then the agents of `future`, without the ego, up to
  /// `end` s after t0. `interval`: s between two instants; states between frames are interpolated.
  /// Keeps no references.
  RecordedTraffic(const Snapshot& past, const Future& future, double end, double interval);

  /// Instants are numbered from t0: 0 is t0, negative before it. Returns the first one, at or up to
  /// an interval before the first frame.
  int firstInstant() const { return first_; }
  /// Returns the last instant, at or up to an interval after `end`.
  int lastInstant() const { return first_ + static_cast<int>(bodies_.size()) - 1; }
  /// Returns the time between two instants, s.
  double interval() const { return interval_; }

  /// Returns true if the box centred at `pose`, enlarged by `clearance` (m) on all sides, overlaps
  /// an agent or the ego (known up to t0). False outside the known instants.
  bool touches(const Pose2& pose, const BoxSize& size, int instant, double clearance) const;

  /// Returns true if a car-like vehicle or trailer occludes `place` (m, map frame) from the ego:
  /// the line from the ego's box centre to it crosses the vehicle's box. False if the ego is
  /// unknown at that instant.
  bool hides(const Vector2& place, int instant) const;

  /// Returns the distance (m) from `place` (m) to the ego's box centre; empty if the ego is unknown
  /// at that instant.
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
