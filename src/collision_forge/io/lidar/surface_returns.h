#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "collision_forge/io/lidar/lidar_body.h"
#include "collision_forge/io/lidar/sweep_rays.h"

namespace forge {

/// A cone of directions around a body, seen from the cloud's origin.
struct RayWindow {
  static constexpr float kAll = -2.0F;  ///< below all cosines: contains all directions
  Eigen::Vector3f axis;                 ///< unit, in the cloud's frame
  float cosine = kAll;                  ///< cosine of the cone's half angle

  /// Returns true if the unit vector `direction` (cloud's frame) is within the cone.
  bool contains(const Eigen::Vector3f& direction) const { return axis.dot(direction) >= cosine; }
};

/// A body in motion, in the frame of a cloud. Poses: of the body's origin, on the ground below its
/// middle.
struct PosedBody {
  LidarBody body;
  Eigen::Isometry3d begin;  ///< pose at `begin_time`
  Eigen::Isometry3d end;    ///< pose at `end_time`
  double begin_time = 0.0;  ///< s after the cloud's stamp
  /// s after the cloud's stamp; not after `begin_time`: the body stays at `end`.
  double end_time = 0.0;
  /// Brightness of the whole vehicle, in standard deviations from the mean of all vehicles.
  double brightness = 0.0;
  double fit = 1.0;  ///< scale of length and width of the outline that returns; the scale of its
                     ///< height is (1 + fit) / 2

  /// Returns the pose at a time (s after the stamp), linearly interpolated or extrapolated from
  /// `begin` and `end`.
  Eigen::Isometry3d poseAt(double time) const;
  /// Returns a cone that contains the body during the sweep, with a margin; all directions if the
  /// body is around the cloud's origin.
  RayWindow window() const;
  /// Returns the first hit of a ray that starts at the cloud's origin, on the body, scaled by
  /// `fit`, at its pose at the ray's time. nullopt: the ray misses it.
  std::optional<BodyHit> hitOf(const LidarRay& ray) const;
};

/// Which rays return from a vehicle, and how bright: learnt from recorded vehicles of known boxes.
///
/// - Outline: annotated boxes are larger than the surface that returns. The fit of a group of
///   classes (cars; large vehicles; two-wheelers; pedestrians; with few rays the first two or the
///   last two together) is the PosedBody::fit with which bodies return as many rays as the recorded
///   vehicles did.
/// - Inside: share of returns and intensities by group, range and height on the vehicle, from rays
///   that meet the body at a fit of 0.8, too.
/// - Where fewer than 30 rays (for the fit: 150) were seen, the model `materials` applies: a fit of
///   0.88, a share per kind of surface that falls with range and grazing incidence, and an
///   intensity that is reflectivity (0 to 255) times the cosine of the incidence.
///
/// learn() is not thread-safe; the other functions are.
class SurfaceReturns {
 public:
  /// Adds one sweep to the statistics. `recorded`: bodies that stand for recorded vehicles, in the
  /// cloud's frame; their `fit` is ignored. A ray that meets the body at fit 1 either returned from
  /// within its box (enlarged by 0.25 m), or passed, or was stopped in front of it and is ignored.
  /// Static objects and animals are ignored. `layout` and `sweep` must belong to `cloud`.
  void learn(const PointCloud& cloud, const CloudLayout& layout, const SweepRays& sweep,
             const std::vector<PosedBody>& recorded);

  /// Returns the number of rays that learn() used so far: all rays that meet a recorded body at fit
  /// 1 and are not stopped in front of it, once per body.
  std::size_t learntRays() const { return learnt_; }

  /// Returns the PosedBody::fit for the body's group, 0.7 to 1.
  double fitOf(const LidarBody& body) const;

  /// Returns the share (0.05 to 1) of the variance of the logarithms of intensity + 1 that is
  /// within a vehicle; the rest is between vehicles, which are bright or dark as a whole.
  /// Logarithms keep number plates and lamps from dominating. Returns 0.35 (own choice) before the
  /// body's group has 3 vehicles with 2 intensities each and 30 intensities in all.
  double spreadWithin(const LidarBody& body) const;

  /// Returns the probability 0..1 that a ray which hits the body returns. `hit.distance` is the
  /// range by which statistics are looked up. `height`: of the hit above the ground, as a share of
  /// the body's height, clamped to 0..1.
  double shareOf(const LidarBody& body, const BodyHit& hit, double height) const;

  /// Returns the intensity of a return at the quantile `brightness` (0 to 1) of the recorded
  /// intensities, in the unit of the recorded clouds (model `materials`: 0 to 255). `height` as in
  /// shareOf().
  double intensityOf(const LidarBody& body, const BodyHit& hit, double height,
                     double brightness) const;

 private:
  /// Ranges of hits, with ends at 10, 15, 20, 30 and 45 m.
  static constexpr std::size_t kRanges = 6;
  static constexpr std::size_t kHeights = 5;  ///< equal shares of the body's height
  /// Statistics of rays that hit bodies in one range and height.
  struct Bin {
    double rays = 0.0;               ///< rays that met a body
    double returns = 0.0;            ///< rays that returned
    std::vector<float> intensities;  ///< of returns, ascending; the first 4000
  };
  /// Counts a ray; an `intensity` that is not finite is not stored.
  static void addTo(Bin& bin, bool is_return, double intensity);
  /// Returns the bin of a hit in the smallest group that has enough rays, else in the bin of all
  /// ranges; null if no bin has enough.
  const Bin* binOf(const LidarBody& body, const BodyHit& hit, double height) const;

  /// Number of the fits that learn() tries: 1, 0.95, ... 0.7.
  static constexpr std::size_t kFits = 7;

  /// Statistics of a group of classes.
  struct Group {
    std::array<std::array<Bin, kHeights>, kRanges + 1> bins;  ///< by range (last: all) and height
    /// Rays that meet the body at each tried fit, from 1 down to 0.7.
    std::array<double, kFits> rays{};
    double returns = 0.0;        ///< returns of rays that meet the body at fit 1
    double inner_returns = 0.0;  ///< returns of rays that meet the body at fit 0.8
    /// Number of vehicles in clouds with two intensities or more; the members below are of these.
    std::size_t vehicles = 0;
    double intensities = 0.0;  ///< number of intensities
    double sum = 0.0;          ///< sum of the logarithms of intensity + 1
    double squares = 0.0;      ///< sum of the squares of these logarithms
    double within = 0.0;       ///< sum of the squared deviations from the mean of the vehicle
  };

  /// Adds the intensities of one vehicle.
  static void addSpread(const std::vector<double>& logarithms, Group& group);
  /// Returns the fit at which the bodies of the group return as many rays as recorded.
  static double fitOf(const Group& group);

  /// Cars; large vehicles; two-wheelers; pedestrians; the first two together; the last two.
  std::array<Group, 6> groups_;
  std::size_t learnt_ = 0;  ///< rays
};

}  // namespace forge
