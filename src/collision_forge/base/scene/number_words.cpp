#include "collision_forge/base/scene/number_words.h"

#include <cmath>
#include <cstdio>

namespace forge {

std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%g", value);
  return text;
}

std::string counted(std::size_t count, const std::string& noun, const std::string& plural) {
  const std::string number = std::to_string(count) + " ";
  if (count == 1) return number + noun;
  return number + (plural.empty() ? noun + "s" : plural);
}

std::string percentText(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

}  // namespace forge
