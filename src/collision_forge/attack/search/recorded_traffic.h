#pragma once

#include <optional>
#include <vector>

#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Where everybody is at instants a fixed interval apart, for many questions about one moment.
class RecordedTraffic {
 public:
  /// Up to now as `past` has it, from its first frame on; after now, up to `end` seconds from now,
  /// the agents as `future` has them, without the ego.
  RecordedTraffic(const Snapshot& past, const Future& future, double end, double interval);

  /// Instants are counted from now, negative before it.
  int firstInstant() const { return first_; }
  int lastInstant() const { return first_ + static_cast<int>(bodies_.size()) - 1; }
  double interval() const { return interval_; }

  /// A box, grown by `clearance` metres on all sides, overlaps somebody's. Nobody is known to be
  /// anywhere beyond the first and the last instant.
  bool touches(const Pose2& pose, const BoxSize& size, int instant, double clearance) const;

  /// A vehicle other than the ego is between the ego and a place: the line from the middle of the
  /// ego's box crosses its box. False where the ego is not known.
  bool hides(const Vector2& place, int instant) const;

  /// m from the middle of the ego's box; empty where it is not known.
  std::optional<double> distanceToEgo(const Vector2& place, int instant) const;

 private:
  struct Body {
    OrientedBox box;
    double radius;  // of its circumference
    bool is_ego;
    bool hides_others;
  };
  const std::vector<Body>* at(int instant) const;
  static const Body* egoOf(const std::vector<Body>* bodies);

  double interval_;
  int first_;
  std::vector<std::vector<Body>> bodies_;  // one list an instant, the ego first
};

}  // namespace forge
