#include "collision_forge/base/map/lane_grid.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>

namespace forge {
namespace {

constexpr double kSpacing = 0.5;    // m, largest distance between samples of a centreline
constexpr double kCell = 4.0;       // m, side of a cell: four cells cover a radius of 2 m
constexpr double kLongest = 1e5;    // m; a longer centreline is damaged
constexpr double kLastCell = 1e12;  // larger indices are clamped to this

std::int64_t cellOf(double coordinate) {
  return static_cast<std::int64_t>(
      std::clamp(std::floor(coordinate / kCell), -kLastCell, kLastCell));
}

std::vector<LaneSample> samplesOf(const std::vector<std::optional<Polyline>>& centerlines) {
  std::vector<LaneSample> samples;
  for (std::size_t lane = 0; lane < centerlines.size(); ++lane) {
    if (!centerlines[lane]) continue;
    const double length = centerlines[lane]->length();
    if (!(length <= kLongest)) {
      std::ostringstream complaint;
      complaint << "centreline of " << length << " m is above the limit of 100 km";
      throw std::invalid_argument(complaint.str());
    }
    const int steps = static_cast<int>(std::ceil(length / kSpacing));
    for (int i = 0; i <= steps; ++i) {
      const double arc_length = length * i / steps;
      const Pose2 pose = centerlines[lane]->poseAt(arc_length);
      samples.push_back({pose.position(), pose.heading(), arc_length, lane});
    }
  }
  return samples;
}

std::size_t powerOfTwoFrom(std::size_t least) {
  std::size_t power = 1;
  while (power < least) power *= 2;
  return power;
}

}  // namespace

LaneGrid::LaneGrid(const std::vector<std::optional<Polyline>>& centerlines) {
  const std::vector<LaneSample> samples = samplesOf(centerlines);
  bucket_ends_.assign(powerOfTwoFrom(samples.size()), 0);
  std::vector<std::size_t> buckets;
  buckets.reserve(samples.size());
  for (const LaneSample& sample : samples) {
    buckets.push_back(bucketOf(cellOf(sample.position.x()), cellOf(sample.position.y())));
    ++bucket_ends_[buckets.back()];
  }
  // First the start of each bucket; inserting samples advances it to the bucket's end.
  std::uint32_t begin = 0;
  for (std::uint32_t& end : bucket_ends_) {
    begin += end;
    end = begin - end;
  }
  samples_.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples_[bucket_ends_[buckets[i]]++] = samples[i];
  }
}

bool LaneGrid::isOnLane(const Pose2& pose, double max_distance, double max_heading) const {
  const Vector2 heading = pose.heading();
  const double least_cosine = std::cos(std::min(max_heading, M_PI)) - 1e-12;  // rounding
  return anyNear(pose.position(), max_distance, [&](const LaneSample& sample) {
    return sample.heading.dot(heading) >= least_cosine;
  });
}

bool LaneGrid::isWrongWay(const Pose2& pose, double max_distance) const {
  const Vector2 heading = pose.heading();
  bool is_near = false;
  const bool goes_along = anyNear(pose.position(), max_distance, [&](const LaneSample& sample) {
    is_near = true;
    return !(sample.heading.dot(heading) < 0.0);  // NaN does not count as wrong way
  });
  return is_near && !goes_along;
}

std::vector<LaneSample> LaneGrid::samplesNear(const Vector2& position, double max_distance) const {
  std::vector<LaneSample> found;
  anyNear(position, max_distance, [&](const LaneSample& sample) {
    found.push_back(sample);
    return false;
  });
  const auto rank = [](const LaneSample& sample) {
    return std::make_tuple(sample.lane, sample.arc_length);
  };
  std::sort(found.begin(), found.end(),
            [&](const LaneSample& a, const LaneSample& b) { return rank(a) < rank(b); });
  // Cells that share a bucket return its samples twice.
  found.erase(
      std::unique(found.begin(), found.end(),
                  [&](const LaneSample& a, const LaneSample& b) { return rank(a) == rank(b); }),
      found.end());
  return found;
}

/// Returns true as soon as `visit` does for a sample in range; may visit a sample more than once.
template <class Visit>
bool LaneGrid::anyNear(const Vector2& position, double max_distance, const Visit& visit) const {
  if (!position.allFinite() || !(max_distance >= 0.0)) return false;
  const double square_distance = max_distance * max_distance;
  const double side = 2.0 * max_distance / kCell + 1.0;
  if (side * side >= static_cast<double>(bucket_ends_.size())) {
    for (std::size_t bucket = 0; bucket < bucket_ends_.size(); ++bucket) {
      if (anyInBucket(bucket, position, square_distance, visit)) return true;
    }
    return false;
  }
  const std::int64_t last_column = cellOf(position.x() + max_distance);
  const std::int64_t last_row = cellOf(position.y() + max_distance);
  for (std::int64_t row = cellOf(position.y() - max_distance); row <= last_row; ++row) {
    for (std::int64_t x = cellOf(position.x() - max_distance); x <= last_column; ++x) {
      if (anyInBucket(bucketOf(x, row), position, square_distance, visit)) return true;
    }
  }
  return false;
}

template <class Visit>
bool LaneGrid::anyInBucket(std::size_t bucket, const Vector2& position, double square_distance,
                           const Visit& visit) const {
  for (std::size_t i = bucket == 0 ? 0 : bucket_ends_[bucket - 1]; i < bucket_ends_[bucket]; ++i) {
    const LaneSample& sample = samples_[i];
    if ((sample.position - position).squaredNorm() <= square_distance && visit(sample)) return true;
  }
  return false;
}

/// Distributes neighbouring cells over the buckets.
std::size_t LaneGrid::bucketOf(std::int64_t column, std::int64_t row) const {
  const std::uint64_t mixed = static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15ULL +
                              static_cast<std::uint64_t>(row) * 0xC2B2AE3D27D4EB4FULL;
  return static_cast<std::size_t>((mixed ^ (mixed >> 32)) & (bucket_ends_.size() - 1));
}

}  // namespace forge
