#pragma once

#include <string>

namespace forge {

/// `value` with so many decimals, a decimal point and a real minus sign (UTF-8), whatever the
/// locale; never "−0".
std::string decimalText(double value, int decimals);

/// Like "+4.0 s" or "−1.5 s".
std::string signedSeconds(double seconds, int decimals);

}  // namespace forge
