#pragma once

namespace forge {

/// s; times that differ by at most this count as equal, because stamps and files have microseconds.
inline constexpr double kTimeEpsilon = 1e-6;

}  // namespace forge
