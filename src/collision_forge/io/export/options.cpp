#include "collision_forge/io/export/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {
namespace {

void readOrigins(Section section, ExportOptions& options) {
  const std::set<std::string> locations = section.unread();
  for (const std::string& location : locations) {
    const std::vector<double> degrees = section.numbers(location, -180.0, 180.0);
    if (degrees.size() != 2 || std::abs(degrees[0]) > 90.0) {
      section.refuse(location, "is not [latitude, longitude] in degrees");
    }
    options.origins[location] = {degrees[0], degrees[1]};
  }
}

}  // namespace

void readOptions(Section& section, ExportOptions& options) {
  Section numbers = section.section("export");
  options.history = numbers.nonNegative("history");
  options.radius = numbers.positive("radius");
  numbers.finish();
  readOrigins(section.section("origins"), options);
}

}  // namespace forge
