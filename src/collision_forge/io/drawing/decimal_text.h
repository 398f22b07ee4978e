#pragma once

#include <string>

namespace forge {

/// Returns `value` with `decimals` decimals, a decimal point and a real minus sign (UTF-8),
/// whatever the locale; never "−0".
std::string decimalText(double value, int decimals);

/// Returns a signed time with `decimals` decimals, as "+4.0 s" or "−1.5 s"; zero is "+0.0 s".
std::string signedSeconds(double seconds, int decimals);

}  // namespace forge
