#include "collision_forge/io/lidar/missing_rays.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

namespace forge {
namespace {

constexpr double kTurn = 2.0 * M_PI;
constexpr double kMostTurns = 1.1;  // of rays that are added to a ring

/// The azimuth step between neighbouring rays of a ring: rad, negative if the sensor turns
/// clockwise.
std::optional<double> stepOf(const std::vector<std::vector<std::uint32_t>>& rings,
                             const std::vector<SeenPoint>& seen) {
  constexpr std::size_t kLeast = 16;
  constexpr double kLeastRegular = 0.4;  // share of single steps
  std::vector<double> steps;
  for (const auto& ring : rings) {
    if (ring.size() <= steps.size()) continue;
    std::vector<double> found;
    for (std::size_t i = 1; i < ring.size(); ++i) {
      const SeenPoint& before = seen[ring[i - 1]];
      const SeenPoint& after = seen[ring[i]];
      if (before.range < 2.0F || after.range < 2.0F || before.range == LidarRay::kNoReturn ||
          after.range == LidarRay::kNoReturn) {
        continue;
      }
      found.push_back(std::remainder(after.azimuth - before.azimuth, kTurn));
    }
    if (found.size() > steps.size()) steps = std::move(found);
  }
  if (steps.size() < kLeast) return std::nullopt;
  // Gaps are multiples of the step, so the smaller differences are single steps.
  std::sort(steps.begin(), steps.end(),
            [](double a, double b) { return std::abs(a) < std::abs(b); });
  const double small = steps[steps.size() / 5];
  std::vector<double> regular;
  std::copy_if(steps.begin(), steps.end(), std::back_inserter(regular),
               [=](double step) { return std::abs(step - small) < 0.4 * std::abs(small); });
  if (static_cast<double>(regular.size()) < kLeastRegular * static_cast<double>(steps.size())) {
    return std::nullopt;
  }
  const double step = regular[regular.size() / 2];
  return std::abs(step) < 1e-4 ? std::nullopt : std::optional(step);
}

/// Rebuilds the rays without return of all rings.
class RayRebuilder {
 public:
  RayRebuilder(const std::vector<SeenPoint>& seen, const RingElevations& elevations, bool may_add,
               std::vector<LidarRay>& rays)
      : seen_(seen), elevations_(elevations), rays_(rays), may_add_(may_add) {
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const std::int32_t ring = seen[i].ring;
      if (ring < 0) continue;
      if (rings_.size() <= static_cast<std::size_t>(ring)) rings_.resize(ring + 1);
      rings_[ring].push_back(static_cast<std::uint32_t>(i));
    }
  }

  /// Returns false, and changes nothing, if the azimuths have no regular step.
  bool rebuild() {
    const auto step = stepOf(rings_, seen_);
    if (!step) return false;
    step_ = std::abs(*step);
    sense_ = *step > 0.0 ? 1.0 : -1.0;
    findReference();
    addRingsAbove();
    rebuildRing(reference_ring_);
    for (std::size_t ring = 0; ring < rings_.size(); ++ring) {
      if (ring != reference_ring_) rebuildRing(ring);
    }
    return true;
  }

 private:
  bool isReturn(std::uint32_t point) const { return seen_[point].range != LidarRay::kNoReturn; }

  /// Finds the ring with most returns and the azimuths along it, unwrapped in the sense of turning.
  void findReference() {
    std::size_t most = 0;
    for (std::size_t ring = 0; ring < rings_.size(); ++ring) {
      const auto returns = static_cast<std::size_t>(
          std::count_if(rings_[ring].begin(), rings_[ring].end(),
                        [this](std::uint32_t point) { return isReturn(point); }));
      if (returns > most) {
        most = returns;
        reference_ring_ = ring;
      }
    }
    double angle = 0.0;
    std::optional<std::uint32_t> last;
    for (const std::uint32_t point : rings_[reference_ring_]) {
      if (!isReturn(point)) continue;
      if (last) angle += turned(seen_[*last].azimuth, seen_[point].azimuth);
      reference_.emplace_back(point, angle);
      last = point;
    }
    is_full_turn_ = angle > 0.95 * kTurn;
  }

  /// Adds the rings above the highest one with returns: the rings of a sensor of evenly spaced
  /// rings up to the next usual number of rings. Open sky returns nothing to them.
  void addRingsAbove() {
    constexpr double kEven = 0.25;  // of the spacing, in the upper half of the rings
    std::vector<double> spacings;
    for (std::size_t ring = rings_.size() / 2 + 1; ring < rings_.size(); ++ring) {
      spacings.push_back(elevations_.mean[ring] - elevations_.mean[ring - 1]);
    }
    if (spacings.size() < 2) return;
    const double mean = std::accumulate(spacings.begin(), spacings.end(), 0.0) /
                        static_cast<double>(spacings.size());
    const bool is_even = std::all_of(spacings.begin(), spacings.end(), [=](double spacing) {
      return std::abs(spacing - mean) < kEven * std::abs(mean);
    });
    const auto count = std::lower_bound(std::begin(kRingCounts), std::end(kRingCounts),
                                        static_cast<int>(rings_.size()));
    if (!is_even || count == std::end(kRingCounts)) return;
    const std::size_t known = rings_.size();
    rings_.resize(static_cast<std::size_t>(*count));
    for (std::size_t ring = known; ring < rings_.size(); ++ring) {
      elevations_.mean[ring] = elevations_.mean[ring - 1] + mean;
    }
  }

  /// Returns the angle from one azimuth to another in the sense of turning, 0 to 2 pi; steps back
  /// by up to 3 steps count as none.
  double turned(double from, double to) const {
    double angle = std::fmod((to - from) * sense_ + 2.0 * kTurn, kTurn);
    if (angle > kTurn - 3.0 * step_) angle = 0.0;
    return angle;
  }

  /// Returns the elevation of a ring; between rings with returns, interpolated.
  std::optional<double> elevationOf(std::size_t ring) const {
    if (std::isfinite(elevations_.mean[ring])) return elevations_.mean[ring];
    std::size_t low = ring;
    while (low > 0 && !std::isfinite(elevations_.mean[low])) --low;
    std::size_t high = ring;
    while (high + 1 < rings_.size() && !std::isfinite(elevations_.mean[high])) ++high;
    if (!std::isfinite(elevations_.mean[low]) || !std::isfinite(elevations_.mean[high])) {
      return std::nullopt;
    }
    const double share = static_cast<double>(ring - low) / static_cast<double>(high - low);
    return elevations_.mean[low] + share * (elevations_.mean[high] - elevations_.mean[low]);
  }

  void rebuildRing(std::size_t ring) {
    const auto elevation = elevationOf(ring);
    if (!elevation) return;
    elevation_ = *elevation;
    may_still_add_ = static_cast<std::size_t>(kMostTurns * kTurn / step_);
    ring_ = static_cast<std::int32_t>(ring);
    const auto returns = std::count_if(rings_[ring].begin(), rings_[ring].end(),
                                       [this](std::uint32_t point) { return isReturn(point); });
    if (returns < 2) {
      rebuildFromReference(rings_[ring]);
      return;
    }
    std::optional<std::uint32_t> last;
    std::vector<std::uint32_t> empty;
    for (const std::uint32_t point : rings_[ring]) {
      if (!isReturn(point)) {
        empty.push_back(point);
        continue;
      }
      if (last) {
        fillGap(*last, point, empty);
      } else {
        fillEnd(point, empty, -static_cast<double>(empty.size()));
      }
      last = point;
      empty.clear();
    }
    fillEnd(*last, empty, 1.0);
    closeTurn(ring);
  }

  /// Fills the empty points beside the first or last return of a ring by equal steps; the first
  /// of them is `begin` steps after `point`.
  void fillEnd(std::uint32_t point, const std::vector<std::uint32_t>& empty, double begin) {
    for (const std::uint32_t slot : empty) {
      put(slot, seen_[point].azimuth + sense_ * step_ * begin);
      begin += 1.0;
    }
  }

  void fillGap(std::uint32_t from, std::uint32_t to, const std::vector<std::uint32_t>& empty) {
    const double angle = turned(seen_[from].azimuth, seen_[to].azimuth);
    // A step back, by more than turned() takes for one.
    const double expected = kTurn * (to - from) / static_cast<double>(seen_.size());
    if (angle - expected > M_PI) return fillEnd(from, empty, 1.0);
    if (!empty.empty()) {
      for (std::size_t i = 0; i < empty.size(); ++i) {
        const double share = static_cast<double>(i + 1) / static_cast<double>(empty.size() + 1);
        put(empty[i], seen_[from].azimuth + sense_ * angle * share);
      }
      return;
    }
    const double steps = std::round(angle / step_);
    for (double i = 1.0; i < steps; i += 1.0) {
      const double share = i / steps;
      add(from + static_cast<std::uint32_t>(share * (to - from - 1)),
          seen_[from].azimuth + sense_ * angle * share, timeBetween(from, to, share));
    }
  }

  /// Adds the rays between the last and the first return of a ring of a full turn.
  void closeTurn(std::size_t ring) {
    if (!is_full_turn_ || !may_add_ || !isReturn(rings_[ring].front()) ||
        !isReturn(rings_[ring].back())) {
      return;
    }
    const std::uint32_t last = rings_[ring].back();
    const std::uint32_t first = rings_[ring].front();
    const double angle = turned(seen_[last].azimuth, seen_[first].azimuth);
    const double rest = reference_.back().second;  // after the last return up to the sweep's end
    const double before = std::fmod(
        (seen_[last].azimuth - seen_[reference_.front().first].azimuth) * sense_ + 2.0 * kTurn,
        kTurn);
    const double end = std::max(0.0, rest - before);
    const double steps = std::round(angle / step_);
    const double seconds =
        double{rays_[reference_.back().first].time} - double{rays_[reference_.front().first].time};
    for (double i = 1.0; i < steps; i += 1.0) {
      const double along = angle * i / steps;
      const bool is_at_end = along <= end;
      const double since = is_at_end ? along : along - angle;  // rad from the last or the first
      add(is_at_end ? last : (first > 0 ? first - 1 : 0), seen_[last].azimuth + sense_ * along,
          rays_[is_at_end ? last : first].time +
              static_cast<float>(since / std::max(rest, step_) * seconds));
    }
  }

  /// Rebuilds a ring without returns, from the azimuths of the reference ring.
  void rebuildFromReference(const std::vector<std::uint32_t>& slots) {
    const float start = seen_[reference_.front().first].azimuth;
    if (!slots.empty()) {
      const std::vector<std::uint32_t>& columns = rings_[reference_ring_];
      for (std::size_t i = 0; i < slots.size() && slots.size() == columns.size(); ++i) {
        if (isReturn(slots[i])) continue;
        const Eigen::Vector3f& direction = rays_[columns[i]].direction;
        put(slots[i], std::atan2(direction.y(), direction.x()));
      }
      return;
    }
    for (std::size_t i = 1; i < reference_.size(); ++i) {
      const auto& [from, angle] = reference_[i - 1];
      const auto& [to, next] = reference_[i];
      const double steps = std::max(1.0, std::round((next - angle) / step_));
      for (double k = 0.0; k < steps; k += 1.0) {
        const double share = k / steps;
        add(from + static_cast<std::uint32_t>(share * (to - from - 1)),
            start + sense_ * (angle + share * (next - angle)), timeBetween(from, to, share));
      }
    }
  }

  float timeBetween(std::uint32_t from, std::uint32_t to, double share) const {
    const float before = rays_[from].time;
    return before + static_cast<float>(share) * (rays_[to].time - before);
  }

  Eigen::Vector3f directionTo(double azimuth) const {
    return Eigen::Vector3d(std::cos(elevation_) * std::cos(azimuth),
                           std::cos(elevation_) * std::sin(azimuth), std::sin(elevation_))
        .cast<float>();
  }

  void put(std::uint32_t point, double azimuth) { rays_[point].direction = directionTo(azimuth); }

  void add(std::uint32_t after, double azimuth, float time) {
    if (!may_add_ || may_still_add_ == 0) return;
    --may_still_add_;
    LidarRay ray;
    ray.direction = directionTo(azimuth);
    ray.time = time;
    ray.ring = ring_;
    ray.point = after;
    ray.is_missing = true;
    rays_.push_back(ray);
  }

  const std::vector<SeenPoint>& seen_;
  RingElevations elevations_;
  std::vector<LidarRay>& rays_;
  bool may_add_;
  std::vector<std::vector<std::uint32_t>> rings_;  ///< indices of points, by ring
  double step_ = 0.0;                              ///< rad, positive
  double sense_ = 1.0;
  std::size_t reference_ring_ = 0;
  std::vector<std::pair<std::uint32_t, double>> reference_;  ///< point, angle from the first
  bool is_full_turn_ = false;
  std::size_t may_still_add_ = 0;  ///< rays, to the current ring
  double elevation_ = 0.0;
  std::int32_t ring_ = -1;
};

}  // namespace

bool rebuildMissingRays(const std::vector<SeenPoint>& seen, const RingElevations& elevations,
                        bool may_add, std::vector<LidarRay>& rays) {
  return RayRebuilder(seen, elevations, may_add, rays).rebuild();
}

}  // namespace forge
