#include "collision_forge/io/export/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {
namespace {

constexpr AgentClass kClasses[] = {AgentClass::kCar,
                                   AgentClass::kTruck,
                                   AgentClass::kBus,
                                   AgentClass::kTrailer,
                                   AgentClass::kConstructionVehicle,
                                   AgentClass::kEmergencyVehicle,
                                   AgentClass::kMotorcycle,
                                   AgentClass::kBicycle,
                                   AgentClass::kPedestrian,
                                   AgentClass::kAnimal,
                                   AgentClass::kStaticObject};

void readHeights(Section section, ExportOptions& options) {
  for (const AgentClass agent_class : kClasses) {
    options.heights[agent_class] = section.positive(toString(agent_class));
  }
  section.finish();
}

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

void readNumbers(Section section, ExportOptions& options) {
  options.step = section.positive("step");
  options.history = section.nonNegative("history");
  options.tail = section.nonNegative("tail");
  options.radius = section.positive("radius");
  options.lane_width = section.positive("lane_width");
  section.finish();
}

}  // namespace

void readOptions(Section& section, ExportOptions& options) {
  readNumbers(section.section("export"), options);
  readHeights(section.section("heights"), options);
  readOrigins(section.section("origins"), options);
}

}  // namespace forge
