#include "collision_forge/io/lidar/cloud_injection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace forge {
namespace {

constexpr double kVacatedMargin = 0.15;  // m around a removed vehicle
constexpr double kVacatedGround = 0.2;   // m above ground that remain

/// Random numbers of one ray, whatever is drawn for others (splitmix64, Vigna 2015).
class RayNoise {
 public:
  RayNoise(std::uint64_t seed, std::uint64_t ray) : state_(seed + ray * 0x9E3779B97F4A7C15U) {
    next();
  }
  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// Standard normal (Box and Muller, 1958).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * M_PI * uniform());
  }

 private:
  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

/// Where a ray ends after the edit.
struct NewEnd {
  float range = LidarRay::kNoReturn;
  double intensity = 0.0;
  bool is_on_body = false;
};

class CloudEditor {
 public:
  CloudEditor(PointCloud& cloud, const CloudLayout& layout, const SweepRays& sweep,
              const CloudEdit& edit, const SurfaceReturns& surfaces)
      : cloud_(cloud),
        layout_(layout),
        sweep_(sweep),
        edit_(edit),
        bodies_(edit.bodies),
        surfaces_(surfaces) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      bodies_[i].fit = surfaces.fitOf(bodies_[i].body);
      windows_.push_back(bodies_[i].window());
    }
  }

  CloudChange apply() {
    for (std::size_t i = 0; i < sweep_.rays.size(); ++i) {
      const LidarRay& ray = sweep_.rays[i];
      if (ray.direction.isZero()) continue;
      if (const auto end = endOf(ray, i)) change(ray, *end);
    }
    rebuild();
    return change_;
  }

 private:
  /// Returns the new end of a ray; nullopt if it does not change.
  std::optional<NewEnd> endOf(const LidarRay& ray, std::size_t number) {
    NewEnd end;
    end.range = ray.range;
    bool is_changed = false;
    if (isVacated(ray)) {
      ++change_.vacated;
      is_changed = true;
      end.range = edit_.background ? edit_.background->rangeBehind(ray, end.intensity)
                                   : LidarRay::kNoReturn;
    }
    const PosedBody* nearest = nullptr;
    std::optional<BodyHit> hit;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (!windows_[i].contains(ray.direction)) continue;
      const PosedBody& body = bodies_[i];
      const auto found = body.hitOf(ray);
      if (!found || found->distance >= end.range || (hit && hit->distance <= found->distance)) {
        continue;
      }
      hit = found;
      nearest = &body;
    }
    if (hit) {
      end = endOn(*nearest, *hit, {ray, number, end.range});
      is_changed = end.is_on_body || ray.range != LidarRay::kNoReturn;
    }
    if (!is_changed) return std::nullopt;
    return end;
  }

  bool isVacated(const LidarRay& ray) const {
    if (ray.range == LidarRay::kNoReturn) return false;
    const Eigen::Vector3d point = (ray.range * ray.direction).cast<double>();
    return std::any_of(edit_.vacated.begin(), edit_.vacated.end(), [&](const VacatedBox& box) {
      return box.contains(point, ray.time, kVacatedMargin, kVacatedGround);
    });
  }

  /// A ray without the recorded vehicles that were taken out.
  struct FreeRay {
    const LidarRay& ray;
    std::size_t number;  ///< in the sweep
    float range;         ///< m, to what is behind the removed vehicles
  };

  NewEnd endOn(const PosedBody& posed, const BodyHit& hit, const FreeRay& free) const {
    NewEnd end;
    const LidarRay& ray = free.ray;
    RayNoise noise(edit_.seed, free.number);
    const Eigen::Vector3d point = hit.distance * ray.direction.cast<double>();
    const double height = (posed.poseAt(ray.time).inverse() * point).z() / posed.body.size.z();
    if (noise.uniform() >= surfaces_.shareOf(posed.body, hit, height)) return end;
    const double within = surfaces_.spreadWithin(posed.body);
    const double deviation =
        std::sqrt(1.0 - within) * posed.brightness + std::sqrt(within) * noise.normal();
    const double quantile = 0.5 * std::erfc(-deviation / std::sqrt(2.0));
    end.intensity = surfaces_.intensityOf(posed.body, hit, height, quantile);
    constexpr double kMostNoise = 3.0;  // standard deviations
    const double error = std::clamp(noise.normal(), -kMostNoise, kMostNoise) * edit_.range_noise;
    // Never in front of the sensor, never behind what the ray met without the body.
    end.range = std::min(static_cast<float>(std::max(0.1 * hit.distance, hit.distance + error)),
                         free.range);
    end.is_on_body = true;
    return end;
  }

  void change(const LidarRay& ray, const NewEnd& end) {
    const bool is_return = end.range != LidarRay::kNoReturn;
    if (end.is_on_body) ++change_.on_bodies;
    if (ray.is_missing) {
      if (!is_return) return;
      ++change_.added;
      added_.emplace_back(ray.point, pointLike(ray, end));
      return;
    }
    if (!is_return) {
      ++change_.removed;
      remove(ray.point);
      return;
    }
    if (!end.is_on_body) ++change_.filled;
    write(cloud_.pointAt(ray.point), ray, end);
  }

  void write(std::uint8_t* point, const LidarRay& ray, const NewEnd& end) const {
    layout_.setPosition(point, double{end.range} * ray.direction.cast<double>().normalized());
    if (layout_.intensity) layout_.intensity->set(point, end.intensity);
  }

  std::vector<std::uint8_t> pointLike(const LidarRay& ray, const NewEnd& end) const {
    const std::uint8_t* before = cloud_.pointAt(ray.point);
    std::vector<std::uint8_t> point(before, before + cloud_.point_step);
    write(point.data(), ray, end);
    if (layout_.ring && ray.ring >= 0) layout_.ring->set(point.data(), ray.ring);
    if (layout_.time) {
      // Relative to the neighbour: the field may hold absolute times.
      const double scale = layout_.time->isFloat() ? 1.0 : 1e9;
      const double later = double{ray.time} - double{sweep_.rays[ray.point].time};
      layout_.time->set(point.data(), layout_.time->get(before) + scale * later);
    }
    return point;
  }

  void remove(std::uint32_t index) {
    if (sweep_.empty_points == EmptyPoints::kLeftOut) {
      removed_.push_back(index);
      return;
    }
    const bool is_nan = sweep_.empty_points == EmptyPoints::kNan;
    const double none = is_nan ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    layout_.setPosition(cloud_.pointAt(index), {none, none, none});
    if (is_nan) cloud_.is_dense = false;
  }

  /// Takes removed points out of the data and puts added ones in.
  void rebuild() {
    if (removed_.empty() && added_.empty()) return;
    std::sort(removed_.begin(), removed_.end());
    std::stable_sort(added_.begin(), added_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::uint8_t> data;
    data.reserve(cloud_.data.size() + added_.size() * cloud_.point_step);
    auto removed = removed_.begin();
    auto added = added_.begin();
    const std::size_t count = cloud_.pointCount();
    for (std::size_t i = 0; i < count; ++i) {
      if (removed != removed_.end() && *removed == i) {
        ++removed;
      } else {
        const std::uint8_t* point = cloud_.pointAt(i);
        data.insert(data.end(), point, point + cloud_.point_step);
      }
      for (; added != added_.end() && added->first == i; ++added) {
        data.insert(data.end(), added->second.begin(), added->second.end());
      }
    }
    cloud_.width = static_cast<std::uint32_t>(data.size() / cloud_.point_step);
    cloud_.row_step = cloud_.width * cloud_.point_step;
    cloud_.data = std::move(data);
  }

  PointCloud& cloud_;
  const CloudLayout& layout_;
  const SweepRays& sweep_;
  const CloudEdit& edit_;
  std::vector<PosedBody> bodies_;  ///< with the fit of `surfaces`
  const SurfaceReturns& surfaces_;
  std::vector<RayWindow> windows_;  ///< by body
  std::vector<std::uint32_t> removed_;
  std::vector<std::pair<std::uint32_t, std::vector<std::uint8_t>>> added_;
  CloudChange change_;
};

}  // namespace

bool VacatedBox::contains(const Eigen::Vector3d& point, double time, double margin,
                          double lowest) const {
  const Eigen::Vector3d since = time * velocity;
  const double reach = size.norm() + since.norm() + 1.0;
  if ((point - pose.translation()).squaredNorm() > reach * reach) return false;
  const auto isInside = [&](const Eigen::Vector3d& place) {
    const Eigen::Vector3d local = pose.inverse() * place;
    return std::abs(local.x()) < size.x() / 2.0 + margin &&
           std::abs(local.y()) < size.y() / 2.0 + margin && local.z() > lowest &&
           local.z() < size.z() + margin;
  };
  return isInside(point) || isInside(point - since);
}

VacatedBox vacatedBoxOf(const PosedBody& posed) {
  VacatedBox box{posed.end, posed.body.size, Eigen::Vector3d::Zero()};
  const double duration = posed.end_time - posed.begin_time;
  if (duration > 0.0) {
    box.velocity = (posed.end.translation() - posed.begin.translation()) / duration;
  }
  return box;
}

double brightnessOf(const std::string& vehicle, std::uint64_t seed) {
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a
  for (const char letter : vehicle) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211U;
  }
  return RayNoise(seed, hash).normal();
}

CloudChange editCloud(PointCloud& cloud, const CloudLayout& layout, const SweepRays& sweep,
                      const CloudEdit& edit, const SurfaceReturns& surfaces) {
  return CloudEditor(cloud, layout, sweep, edit, surfaces).apply();
}

}  // namespace forge
