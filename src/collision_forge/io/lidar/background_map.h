#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "collision_forge/io/lidar/cloud_injection.h"

namespace forge {

/// The static parts of a scene, collected from sweeps: the ground, as heights in cells
/// of 1 m, and obstacles, as cubes of 0.25 m. Frame: map, z up.
class BackgroundMap {
 public:
  /// Adds the returns of a sweep whose cloud's frame has the pose `sensor`, except those within
  /// `movers` (in the map frame), which need not stand still.
  void add(const PointCloud& cloud, const CloudLayout& layout, const SweepRays& sweep,
           const Eigen::Isometry3d& sensor, const std::vector<VacatedBox>& movers);

  /// Takes the lowest height within 2 m as the ground of each cell, and of cells without points:
  /// a cell alone may hold nothing but a wall. To be called once, after add().
  void finish();

  /// Returns where a ray from `origin` (map frame) along the unit vector `direction` ends, m, from
  /// `begin` on; LidarRay::kNoReturn if it meets nothing known within 80 m. `intensity` is set for
  /// an end.
  float rangeFrom(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double begin,
                  double& intensity) const;

 private:
  struct Cell {
    float height = 0.0F;     ///< m, lowest
    float intensity = 0.0F;  ///< of the lowest
  };
  std::unordered_map<std::uint64_t, Cell> ground_;
  std::unordered_map<std::uint64_t, float> obstacles_;  ///< intensity, by cube
};

/// A BackgroundMap seen by one sensor.
class BackgroundOfSensor : public CloudBackground {
 public:
  /// `sensor`: pose of the cloud's frame in the map frame. `map` must outlive this object.
  BackgroundOfSensor(const BackgroundMap& map, const Eigen::Isometry3d& sensor)
      : map_(map), sensor_(sensor) {}
  float rangeBehind(const LidarRay& ray, double& intensity) const override;

 private:
  const BackgroundMap& map_;
  Eigen::Isometry3d sensor_;
};

}  // namespace forge
