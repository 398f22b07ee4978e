#include "collision_forge/io/drawing/decimal_text.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace forge {

std::string decimalText(double value, int decimals) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(decimals) << std::abs(value);
  const bool is_zero = text.str().find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !is_zero ? "−" : "") + text.str();
}

std::string signedSeconds(double seconds, int decimals) {
  const std::string text = decimalText(seconds, decimals) + " s";
  return text.rfind("−", 0) == 0 ? text : "+" + text;
}

}  // namespace forge
