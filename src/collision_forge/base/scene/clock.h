#pragma once

namespace forge {

/// s; times that are no farther apart are one: stamps and files are to the microsecond.
inline constexpr double kTimeEpsilon = 1e-6;

}  // namespace forge
