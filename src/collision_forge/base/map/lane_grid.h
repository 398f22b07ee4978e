#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "collision_forge/base/geometry/polyline.h"

namespace forge {

/// A point of a lane's centreline. Global map frame.
struct LaneSample {
  Vector2 position;         ///< m
  Vector2 heading;          ///< unit vector in driving direction, as Polyline::poseAt()
  double arc_length = 0.0;  ///< metres from the centreline's first point
  std::size_t lane = 0;     ///< index into LaneMap::lanes
};

/// Answers proximity queries on centrelines quickly, from samples at most 0.5 m apart (both ends
/// included). Distances are measured to the samples: a few centimetres above the distance to the
/// line, at most 0.25 m. Immutable, so safe to share among threads.
class LaneGrid {
 public:
  /// `centerlines`: element i is the centreline of LaneMap::lanes[i], nullopt for a lane without
  /// one. Throws std::invalid_argument for a centreline longer than 100 km.
  explicit LaneGrid(const std::vector<std::optional<Polyline>>& centerlines);

  /// Returns true if a sample is within `max_distance` (m) of the pose's position and its heading
  /// within `max_heading` (rad) of the pose's yaw. Returns false for a pose that is not finite.
  /// Takes below 1 us for a few metres; the time grows with the number of samples in range.
  bool isOnLane(const Pose2& pose, double max_distance, double max_heading) const;

  /// Returns true if samples are within `max_distance` (m) and the headings of all of them differ
  /// by more than 90 degrees from the pose's yaw. Returns false if no sample is in range, and for a
  /// pose that is not finite.
  bool isWrongWay(const Pose2& pose, double max_distance) const;

  /// Returns the samples within `max_distance` (m) of `position` (m, map frame), sorted by lane and
  /// arc length; empty if there is none, and for a position that is not finite.
  std::vector<LaneSample> samplesNear(const Vector2& position, double max_distance) const;

 private:
  /// Calls `visit` for each sample in range, possibly more than once, until it returns true;
  /// returns whether it did.
  template <class Visit>
  bool anyNear(const Vector2& position, double max_distance, const Visit& visit) const;
  /// As anyNear(), for the samples of one bucket.
  template <class Visit>
  bool anyInBucket(std::size_t bucket, const Vector2& position, double square_distance,
                   const Visit& visit) const;
  /// Returns the bucket of a cell of 4 m.
  std::size_t bucketOf(std::int64_t column, std::int64_t row) const;

  std::vector<LaneSample> samples_;         // grouped by bucket, then by lane and arc length
  std::vector<std::uint32_t> bucket_ends_;  // hash buckets of cells; a power of two
};

}  // namespace forge
