#include "collision_forge/base/scene/formatted.h"

#include <cstdarg>
#include <cstdio>

namespace forge {

std::string formatted(const char* format, ...) {
  std::va_list values;
  va_start(values, format);
  char text[512];
  std::vsnprintf(text, sizeof(text), format, values);
  va_end(values);
  return text;
}

}  // namespace forge
