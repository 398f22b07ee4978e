#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/io/lidar/surface_returns.h"

namespace forge {

/// The place of a recorded vehicle whose points are taken out of a cloud.
struct VacatedBox {
  Eigen::Isometry3d pose;  ///< pose at the cloud's stamp, in the cloud's frame
                           ///< (BackgroundMap::add(): map frame); origin on the ground below the
                           ///< box's middle, x forward
  Eigen::Vector3d size;    ///< length, width, height, m
  Eigen::Vector3d velocity{0.0, 0.0, 0.0};  ///< m/s, in the frame of `pose`'s parent

  /// Returns true if a point in the frame of `pose`'s parent is in the box, enlarged by `margin`
  /// (m) on all sides but the lowest, from `lowest` (m above the ground) on: either in the box
  /// where it was at `time` (s after the stamp), or where it is at the stamp, since times of points
  /// without a time field are estimates.
  bool contains(const Eigen::Vector3d& point, double time, double margin, double lowest) const;
};

/// Returns the box of a body that is in the cloud as recorded.
VacatedBox vacatedBoxOf(const PosedBody& posed);

/// The surfaces behind removed vehicles.
class CloudBackground {
 public:
  virtual ~CloudBackground() = default;
  /// Returns the range (m from the ray's origin, the sensor) at which the ray of a removed point
  /// ends instead, and sets `intensity`, in the unit of the cloud's field. `ray` has the recorded
  /// range. Returns LidarRay::kNoReturn if nothing is known behind; `intensity` then has no effect.
  /// Called once per removed point by editCloud(), on its thread.
  virtual float rangeBehind(const LidarRay& ray, double& intensity) const = 0;
};

/// The changes to make in one cloud.
struct CloudEdit {
  /// Added vehicles, in the cloud's frame. Their `fit` is not used: editCloud() takes
  /// SurfaceReturns::fitOf() for its copies.
  std::vector<PosedBody> bodies;
  std::vector<VacatedBox> vacated;  ///< recorded vehicles whose points are removed
  /// Not owned; null: rays of removed points have no return.
  const CloudBackground* background = nullptr;
  /// m, standard deviation of the ranges of returns from `bodies` (not from the background):
  /// LidarOptions::range_noise; noise is normal, clamped to 3 deviations
  double range_noise = 0.0;
  /// Seed of the noise and of lost returns; the brightness of the vehicles is
  /// PosedBody::brightness.
  std::uint64_t seed = 0;
};

/// The number of points that an edit changed.
struct CloudChange {
  std::size_t on_bodies = 0;  ///< rays that return from the bodies
  std::size_t added = 0;      ///< new points; included in `on_bodies`
  std::size_t removed = 0;    ///< points whose ray has no return any more, in vacated boxes or not
  std::size_t vacated = 0;    ///< recorded points in vacated boxes, to 0.15 m around them and from
                              ///< 0.2 m above the ground on
  std::size_t filled = 0;     ///< points moved to the background; included in `vacated`
};

/// Returns PosedBody::brightness of a vehicle, which it keeps from sweep to sweep: the same id and
/// seed give the same value, normally distributed over ids.
double brightnessOf(const std::string& vehicle, std::uint64_t seed);

/// Changes the points of a cloud in place, ray by ray, and returns the numbers of changed points.
///
/// - First, a return inside a vacated box moves to the background, or is lost.
/// - Then a ray that meets a body in front of its return, as the first step left it, ends on the
///   body, at its own time within the sweep and with an intensity of `surfaces`, or has no return,
///   by the share of returns of `surfaces`. A ray whose return is nearer keeps it. Rays without
///   recorded return hit bodies, too. The range with its noise is limited to the range that the
///   first step left, not to the recorded range: the ray of a vacated point ends on a body behind
///   this point.
/// - Removed points become what the cloud has for rays without return (SweepRays::empty_points; NaN
///   clears `is_dense`), so that the number of points never exceeds the number of rays. All other
///   points keep their bytes and their order. If no point is added or left out, `data` keeps its
///   size; otherwise row padding is dropped.
/// - New points copy the fields that are not known from the point before them.
///
/// The same input and seed give the same bytes. `layout` and `sweep` (raysOf()) must belong to
/// `cloud`.
CloudChange editCloud(PointCloud& cloud, const CloudLayout& layout, const SweepRays& sweep,
                      const CloudEdit& edit, const SurfaceReturns& surfaces);

}  // namespace forge
