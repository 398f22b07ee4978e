#pragma once

namespace forge {

inline constexpr double kGravity = 9.81;  ///< m/s2, standard gravity

}  // namespace forge
