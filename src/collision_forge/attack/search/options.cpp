#include "collision_forge/attack/search/options.h"

#include <utility>

#include "collision_forge/base/config/config_file.h"
#include "collision_forge/base/config/config_folder.h"

namespace forge {

static void readOptions(Section& section, SearchOptions& options) {
  options.step = section.positive("step");
  options.tail = section.atLeast("tail", options.step);
  options.time_margin = section.positive("time_margin");
  options.max_attackers = section.count("max_attackers", 1);
  options.good_share = section.share("good_share");
  options.confidence_curve = section.risingShares("confidence_curve");
}

void readOptions(Section& section, RequestListOptions& options) {
  options.stride = section.positive("stride");
  options.ttas = section.positives("ttas");
  options.min_ego_speed = section.nonNegative("min_ego_speed");
}

/// The classes that may attack, with the vans and pick-ups that nuScenes takes for trucks.
static std::vector<AddedKind> readKinds(Section section) {
  std::vector<AddedKind> kinds;
  for (const auto& [name, agent_class] :
       {std::pair{"car", AgentClass::kCar},
        {"van", AgentClass::kTruck},
        {"truck", AgentClass::kTruck},
        {"bus", AgentClass::kBus},
        {"construction_vehicle", AgentClass::kConstructionVehicle},
        {"emergency_vehicle", AgentClass::kEmergencyVehicle},
        {"motorcycle", AgentClass::kMotorcycle},
        {"bicycle", AgentClass::kBicycle},
        {"pedestrian", AgentClass::kPedestrian},
        {"child", AgentClass::kChild},
        {"runner", AgentClass::kRunner},
        {"scooter", AgentClass::kScooter}}) {
    Section row = section.section(name);
    kinds.push_back({agent_class, row.share("share"), row.positive("length"),
                     row.nonNegative("length_deviation"), row.positive("width")});
    row.finish();
  }
  section.finish();
  return kinds;
}

static void readOptions(Section& section, AddedVehicleOptions& options) {
  options.kinds = readKinds(section.section("kinds"));
  options.candidates = section.count("candidates", 1);
  options.predicted_candidates = section.count("predicted_candidates", 1);
  options.preference = section.share("preference");
  options.sensing_range = section.positive("sensing_range");
  options.least_past = section.positive("least_past");
  options.speeds = section.positives("speeds");
}

static void readOptions(Section& file, AttackOptions& options) {
  file.read("added", options.added);
  file.read("search", options.search);
}

void readAttackOptions(const ConfigFolder& directory, AttackOptions& options) {
  readConfigFile(directory, "prediction", options.prediction);
  readConfigFile(openConfigFile(directory, "search.yaml"), options);
  readConfigFile(directory, "believability", options.verification.believability);
  readConfigFile(directory, "severity", options.verification.severity);
  Section limits = openConfigFile(directory, "vehicle_limits.yaml");
  Section inner = limits.section("vehicle_limits");
  readVehicleLimits(inner, options.verification);
  inner.finish();
  limits.finish();
  options.prediction.tail = options.search.tail;
  readConfigFile(directory, "ego_futures", options.ego_futures);
}

}  // namespace forge
