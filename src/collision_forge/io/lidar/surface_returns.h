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
  Eigen::Vector3f axis;                 ///< unit
  float cosine = kAll;                  ///< of the cone's half angle

  bool contains(const Eigen::Vector3f& direction) const { return axis.dot(direction) >= cosine; }
};

/// A body in motion, in the frame of a cloud.
struct PosedBody {
  LidarBody body;
  Eigen::Isometry3d begin;  ///< pose at `begin_time`
  Eigen::Isometry3d end;    ///< pose at `end_time`
  double begin_time = 0.0;  ///< s after the cloud's stamp
  double end_time = 0.0;
  double brightness = 0.0;  ///< of the whole vehicle, in standard deviations from the mean
  double fit = 1.0;  ///< share of length and width that the outline fills; half as much in height

  /// Returns the pose at a time (s after the stamp), interpolated or extrapolated.
  Eigen::Isometry3d poseAt(double time) const;
  /// Returns a cone that contains the body during the sweep.
  RayWindow window() const;
  /// Returns the first hit of a ray that starts at the cloud's origin.
  std::optional<BodyHit> hitOf(const LidarRay& ray) const;
};

/// Which rays return from a vehicle, and how bright: learnt from recorded vehicles of known boxes.
///
/// Outline: annotated boxes are larger than what returns. The fit of a group of classes (cars,
/// large vehicles, two-wheelers, pedestrians; with few rays the first two or the last two together)
/// is the PosedBody::fit with which bodies return as many rays as the recorded vehicles did.
/// Inside: share of returns and intensities by group, range and height on the vehicle, from rays
/// that meet the body at a fit of 0.8, too. Where fewer than 30 rays were seen, the model
/// `materials`: a fit of 0.88, a share per kind of surface that falls with range and grazing
/// incidence, and an intensity that is reflectivity (0 to 255) times the cosine of the incidence.
class SurfaceReturns {
 public:
  /// Learns from the bodies, of fit 1, that stand for recorded vehicles: a ray that meets the body
  /// either returned from within its box, or passed, or was stopped in front of it and is ignored.
  /// Static objects and animals are ignored.
  void learn(const PointCloud& cloud, const CloudLayout& layout, const SweepRays& sweep,
             const std::vector<PosedBody>& recorded);

  /// Number of rays learnt from.
  std::size_t learntRays() const { return learnt_; }

  /// Returns the fit for a body.
  double fitOf(const LidarBody& body) const;

  /// Returns the share (0 to 1) of the variance of intensities that is within a vehicle; the rest
  /// is between vehicles, which are bright or dark as a whole. 0.35 (own choice) before enough
  /// intensities were learnt. Variances are of the logarithm, so that plates and lamps do not
  /// decide.
  double spreadWithin(const LidarBody& body) const;

  /// Returns the probability 0..1 that a ray which hits the body returns. `height`: of the hit, as
  /// a share of the body's.
  double shareOf(const LidarBody& body, const BodyHit& hit, double height) const;

  /// Returns the intensity of a return at the quantile `brightness` (0 to 1).
  double intensityOf(const LidarBody& body, const BodyHit& hit, double height,
                     double brightness) const;

 private:
  static constexpr std::size_t kRanges = 6;
  static constexpr std::size_t kHeights = 5;
  struct Bin {
    double rays = 0.0;
    double returns = 0.0;
    std::vector<float> intensities;  ///< ascending
  };
  static void addTo(Bin& bin, bool is_return, double intensity);
  /// Returns the bin of a hit in the smallest group that has enough rays, else in the bin of all
  /// ranges; null if no bin has enough.
  const Bin* binOf(const LidarBody& body, const BodyHit& hit, double height) const;

  static constexpr std::size_t kFits = 7;

  struct Group {
    std::array<std::array<Bin, kHeights>, kRanges + 1> bins;  ///< by range (last: all) and height
    std::array<double, kFits> rays{};  ///< that meet the body at each fit of kTriedFits
    double returns = 0.0;
    double inner_returns = 0.0;  ///< at the fit of 0.8
    std::size_t vehicles = 0;    ///< with two intensities and more
    double intensities = 0.0;    ///< number, of these vehicles
    double sum = 0.0;            ///< of the logarithms of intensity + 1
    double squares = 0.0;
    double within = 0.0;  ///< squares of the deviations from the vehicle's mean
  };

  /// Adds the intensities of one vehicle.
  static void addSpread(const std::vector<double>& logarithms, Group& group);
  static double fitOf(const Group& group);

  /// Cars; large vehicles; two-wheelers; pedestrians; the first two together; the last two.
  std::array<Group, 6> groups_;
  std::size_t learnt_ = 0;
};

}  // namespace forge
