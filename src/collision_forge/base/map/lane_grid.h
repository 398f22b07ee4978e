#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "collision_forge/base/geometry/polyline.h"

namespace forge {

/// A point of a lane's centreline. Global map frame.
struct LaneSample {
  Vector2 position;
  Vector2 heading;          ///< unit vector in driving direction, as Polyline::poseAt()
  double arc_length = 0.0;  ///< metres from the centreline's first point
  std::size_t lane = 0;     ///< index into LaneMap::lanes
};

/// The centrelines as samples half a metre apart at most, both ends among them, for questions that
/// are asked thousands of times. Distances are those to the samples: up to a few centimetres more
/// than to the line, and at most a quarter of a metre. Immutable, so safe to share among threads.
class LaneGrid {
 public:
  /// One centreline a lane, empty where the lane has none. Throws std::invalid_argument for one
  /// longer than 100 km.
  explicit LaneGrid(const std::vector<std::optional<Polyline>>& centerlines);

  /// Some sample is at most `max_distance` metres from the pose's position and heads within
  /// `max_heading` radians of its yaw. False for a pose that is not finite. Below a microsecond for
  /// a few metres; the time grows with the samples within reach.
  bool isOnLane(const Pose2& pose, double max_distance, double max_heading) const;

  /// Some sample is at most `max_distance` metres away, and all that are head more than 90 degrees
  /// away from the pose's yaw. False for a pose that is not finite.
  bool isWrongWay(const Pose2& pose, double max_distance) const;

  /// The samples at most `max_distance` metres away, by lane and arc length.
  std::vector<LaneSample> samplesNear(const Vector2& position, double max_distance) const;

 private:
  template <class Visit>
  bool anyNear(const Vector2& position, double max_distance, const Visit& visit) const;
  template <class Visit>
  bool anyInBucket(std::size_t bucket, const Vector2& position, double square_distance,
                   const Visit& visit) const;
  std::size_t bucketOf(std::int64_t column, std::int64_t row) const;

  std::vector<LaneSample> samples_;         // bucket by bucket, each by lane and arc length
  std::vector<std::uint32_t> bucket_ends_;  // a power of two of buckets that cells fall into
};

}  // namespace forge
