#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/io/lidar/surface_returns.h"

namespace forge {

/// The place of a recorded vehicle whose points are taken out of a cloud.
struct VacatedBox {
  Eigen::Isometry3d pose;  ///< at the cloud's stamp; origin on the ground below the box's middle
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
  /// Returns the range (m from the ray's origin) at which the ray of a removed point ends instead,
  /// and sets `intensity`, in the unit of the cloud's field. Returns LidarRay::kNoReturn if nothing
  /// is known behind. Called once per removed point by editCloud(), on its thread.
  virtual float rangeBehind(const LidarRay& ray, double& intensity) const = 0;
};

/// The changes to make in one cloud.
struct CloudEdit {
  std::vector<PosedBody> bodies;                ///< added vehicles, in the cloud's frame
  std::vector<VacatedBox> vacated;              ///< recorded vehicles whose points are removed
  const CloudBackground* background = nullptr;  ///< null: rays of removed points have no return
  double range_noise = 0.0;                     ///< m, LidarOptions::range_noise
  std::uint64_t seed = 0;                       ///< of the noise and of lost returns
};

/// The number of points that an edit changed.
struct CloudChange {
  std::size_t on_bodies = 0;  ///< returns from the bodies
  std::size_t added = 0;      ///< of these, points that the cloud had no point for
  std::size_t removed = 0;    ///< points of rays that have no return any more, vacated or not
  std::size_t vacated = 0;    ///< points inside vacated boxes
  std::size_t filled = 0;     ///< of these, points moved to the background
};

/// Returns PosedBody::brightness of a vehicle, which it keeps from sweep to sweep: the same id and
/// seed give the same value, normally distributed over ids.
double brightnessOf(const std::string& vehicle, std::uint64_t seed);

/// Changes the points of a cloud, ray by ray. First, a return inside a vacated box moves to the
/// background, or is lost. Then a ray that meets a body in front of its return ends on the body, at
/// its own time within the sweep and with an intensity of `surfaces`, or has no return, by the
/// share of returns of `surfaces`; a ray whose return is nearer keeps it. Rays without recorded
/// return hit bodies, too. Removed points become what the cloud has for rays without return
/// (SweepRays::empty_points; NaN clears `is_dense`), so that the number of points never exceeds the
/// number of rays. All other points keep their bytes and their order; without an effect the cloud
/// is unchanged. New points take the fields that are not known from the point before them. The same
/// input and seed give the same bytes. `layout` and `sweep` (raysOf()) must belong to `cloud`.
CloudChange editCloud(PointCloud& cloud, const CloudLayout& layout, const SweepRays& sweep,
                      const CloudEdit& edit, const SurfaceReturns& surfaces);

}  // namespace forge
