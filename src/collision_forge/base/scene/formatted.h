#pragma once

#include <string>

namespace forge {

/// Returns what printf() prints of these values, as formatted("%.1f m/s", speed).
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace forge
