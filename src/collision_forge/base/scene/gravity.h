#pragma once

namespace forge {

inline constexpr double kGravity = 9.81;  ///< m/s2, of the models of drivers and impacts

}  // namespace forge
