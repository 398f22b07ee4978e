#include "collision_forge/io/json/json_numbers.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <system_error>

namespace forge {
namespace {

/// Parses an integer; nullopt if the text is anything else.
template <typename Integer>
std::optional<Integer> integerOf(std::string_view text) {
  Integer value = 0;
  const char* const end = text.data() + text.size();
  const auto [read_to, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || read_to != end) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> nearestDouble(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [read_to, error] = std::from_chars(text.data(), end, value);
  if (read_to != end || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc()) return value;
  // Overflow or underflow to 0: from_chars() does not distinguish them.
  value = std::strtod(std::string(text).c_str(), nullptr);
  if (std::isinf(value)) return std::nullopt;
  return value;
}

bool ExactNumbers::RawNumber(const char* text, rapidjson::SizeType size, bool /*copy*/) {
  const std::string_view number(text, size);
  if (const auto natural = integerOf<std::uint64_t>(number)) return document_.Uint64(*natural);
  const auto integer = integerOf<std::int64_t>(number);
  if (integer && *integer != 0)
    return document_.Int64(*integer);  // an integer would lose the sign of "-0"
  const auto value = nearestDouble(number);
  return value && document_.Double(*value);
}

}  // namespace forge
