#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>

namespace forge {

/// One laser pulse of a sweep.
struct LidarRay {
  /// `range` of a ray that hits nothing.
  static constexpr float kNoReturn = std::numeric_limits<float>::infinity();

  Eigen::Vector3f direction;  ///< unit, in the cloud's frame; the ray begins at the frame's origin.
                              ///< Zero if the direction of a ray without return is unknown
  float range = kNoReturn;    ///< m, of the return; kNoReturn: none
  float time = 0.0F;          ///< s after the cloud's stamp, usually negative
  std::int32_t ring = -1;     ///< index of the laser; -1: unknown
  std::uint32_t point = 0;    ///< index of the ray's point in the cloud; if `is_missing`, of the
                              ///< point after which a new point belongs
  bool is_missing = false;    ///< the cloud has no point for this ray
};

}  // namespace forge
