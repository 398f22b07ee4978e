#pragma once

namespace forge {

/// s; times that differ by no more count as equal: stamps and files have microseconds.
inline constexpr double kTimeEpsilon = 1e-6;

}  // namespace forge
