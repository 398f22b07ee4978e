#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/json/json_numbers.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

std::string bitsOf(double value) {
  std::string bits(sizeof(value), '\0');
  std::memcpy(bits.data(), &value, sizeof(value));
  return std::isnan(value) ? "nan" : bits;
}

}  // namespace

/// Input: a JSON number; it is compared with the C library's value, and read within a line.
bool fuzzNumbers(const std::string& input) {
  const std::optional<double> number = nearestDouble(input);
  if (number) requireSame(bitsOf(*number), bitsOf(std::strtod(input.c_str(), nullptr)));
  return isTaken("line 1", [&] {
    const double value = JsonLine("line 1", "{\"n\":" + input + "}").root().number("n");
    if (number) requireSame(bitsOf(value), bitsOf(*number));
    JsonLineWriter writer;
    writer.beginObject();
    writer.number("n", value);
    writer.endObject();
    requireSame(bitsOf(value), bitsOf(JsonLine("again", writer.line()).root().number("n")));
  });
}

}  // namespace forge
