#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>

namespace forge {

/// One laser pulse of a sweep.
struct LidarRay {
  static constexpr float kNoReturn = std::numeric_limits<float>::infinity();

  Eigen::Vector3f direction;  ///< unit, in the cloud's frame; the ray begins at the frame's origin
  float range = kNoReturn;    ///< m
  float time = 0.0F;          ///< s after the cloud's stamp
  std::int32_t ring = -1;     ///< -1: unknown
  std::uint32_t point = 0;    ///< index of its point in the cloud; if `is_missing`, of the point
                              ///< after which a new one belongs
  bool is_missing = false;    ///< the cloud has no point for this ray
};

}  // namespace forge
