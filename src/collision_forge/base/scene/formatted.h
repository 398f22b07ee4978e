#pragma once

#include <string>

namespace forge {

/// Returns text formatted as by printf(), for example formatted("%.1f m/s", speed). Cuts the text
/// after 511 bytes.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace forge
