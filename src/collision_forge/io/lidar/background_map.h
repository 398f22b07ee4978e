#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "collision_forge/io/lidar/cloud_injection.h"

namespace forge {

/// The static parts of a scene, collected from sweeps: the ground, as the lowest height in cells of
/// 1 m, and obstacles, as cubes of 0.25 m that hold a return. Frame: map, z up. Use: add() for
/// every sweep, finish(), then rangeFrom(), which is thread-safe.
class BackgroundMap {
 public:
  /// Adds the returns of a sweep at ranges of 2.5 to 80 m, except returns within `movers` (poses in
  /// the map frame), enlarged by 0.3 m: vehicles that need not stand still. Without an intensity
  /// field, intensities are 0. `sensor`: pose of the cloud's frame in the map frame. `layout` and
  /// `sweep` must belong to `cloud`.
  void add(const PointCloud& cloud, const CloudLayout& layout, const SweepRays& sweep,
           const Eigen::Isometry3d& sensor, const std::vector<VacatedBox>& movers);

  /// Replaces the ground height of each cell, and of cells without points, by the lowest height in
  /// the 5 x 5 cells around it: a cell alone may hold nothing but a wall. Must be called once,
  /// after the last add().
  void finish();

  /// Returns the range (m from `origin`, map frame) at which a ray along the unit vector
  /// `direction` meets the ground or an obstacle at least 0.35 m above it, searched from the range
  /// `begin` (m) in steps of 0.1 m; ground less than 0.5 m below `origin` does not count, and
  /// places over cells without known ground are passed. Returns LidarRay::kNoReturn if the ray
  /// meets nothing known within 80 m; `intensity` is then unchanged. Otherwise sets `intensity`, in
  /// the unit of the cloud's field.
  float rangeFrom(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double begin,
                  double& intensity) const;

 private:
  struct Cell {
    float height = 0.0F;  ///< m in the map frame: lowest return; after finish(), of the 5 x 5 cells
    float intensity = 0.0F;  ///< of the lowest return
  };
  /// By cell; the key packs the indices of the cell or cube along x, y and z (keyOf()).
  std::unordered_map<std::uint64_t, Cell> ground_;
  std::unordered_map<std::uint64_t, float> obstacles_;  ///< intensity of the first return, by cube
};

/// A BackgroundMap seen by one sensor.
class BackgroundOfSensor : public CloudBackground {
 public:
  /// `sensor`: pose of the cloud's frame in the map frame. `map` must outlive this object.
  BackgroundOfSensor(const BackgroundMap& map, const Eigen::Isometry3d& sensor)
      : map_(map), sensor_(sensor) {}
  /// Continues the ray from 0.1 m behind its return by BackgroundMap::rangeFrom().
  float rangeBehind(const LidarRay& ray, double& intensity) const override;

 private:
  const BackgroundMap& map_;
  Eigen::Isometry3d sensor_;  ///< pose of the cloud's frame in the map frame
};

}  // namespace forge
