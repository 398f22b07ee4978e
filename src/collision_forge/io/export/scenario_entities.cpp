#include "collision_forge/io/export/scenario_entities.h"

#include "collision_forge/io/export/xml.h"

namespace forge {
namespace {

using pugi::xml_node;

// Values that are not recorded and not used by readers here.
constexpr double kWheelDiameter = 0.65;    // m
constexpr double kTrackWidthShare = 0.85;  // of a vehicle's width
constexpr double kWalkerMass = 75.0;       // kg
constexpr double kChildMass = 23.0;        // kg, of seven years
constexpr double kThingMass = 100.0;       // kg

const char* categoryOf(AgentClass agent_class) {
  switch (agent_class) {
    case AgentClass::kTruck:
    case AgentClass::kConstructionVehicle:
      return "truck";
    case AgentClass::kBus:
      return "bus";
    case AgentClass::kTrailer:
      return "trailer";
    case AgentClass::kMotorcycle:
      return "motorbike";
    case AgentClass::kBicycle:
    case AgentClass::kScooter:
      return "bicycle";
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
      return "pedestrian";
    case AgentClass::kAnimal:
      return "animal";
    case AgentClass::kStaticObject:
      return "obstacle";
    default:
      return "car";
  }
}

/// Returns the blueprint of CARLA that is most like a class.
const char* blueprintOf(AgentClass agent_class) {
  switch (agent_class) {
    case AgentClass::kTruck:
    case AgentClass::kTrailer:
    case AgentClass::kConstructionVehicle:
      return "vehicle.carlamotors.carlacola";
    case AgentClass::kBus:
      return "vehicle.mitsubishi.fusorosa";
    case AgentClass::kEmergencyVehicle:
      return "vehicle.dodge.charger_police";
    case AgentClass::kMotorcycle:
      return "vehicle.kawasaki.ninja";
    case AgentClass::kBicycle:
    case AgentClass::kScooter:
      return "vehicle.bh.crossbike";
    case AgentClass::kChild:
      return "walker.pedestrian.0009";
    case AgentClass::kPedestrian:
    case AgentClass::kRunner:
    case AgentClass::kAnimal:
      return "walker.pedestrian.0001";
    case AgentClass::kStaticObject:
      return "static.prop.streetbarrier";
    case AgentClass::kCar:
      break;
  }
  return "vehicle.tesla.model3";
}

/// Adds the objects of one file.
class EntityWriter {
 public:
  EntityWriter(const CrashRecord& record, const ExportPlan& plan) : record_(record), plan_(plan) {}

  void addObject(xml_node entities, const ScenarioEntity& entity) const {
    xml_node object = addElement(entities, "ScenarioObject", {{"name", entity.name}});
    const AgentClass agent_class = entity.track->agent_class;
    const std::string category = categoryOf(agent_class);
    const std::string name = plan_.for_carla ? blueprintOf(agent_class) : entity.name;
    xml_node body;
    if (isVehicle(agent_class)) {
      body = addElement(object, "Vehicle", {{"name", name}, {"vehicleCategory", category}});
      addBox(body, entity);
      addPerformance(body, entity);
    } else if (agent_class == AgentClass::kStaticObject) {
      body = addElement(
          object, "MiscObject",
          {{"mass", xmlNumber(kThingMass)}, {"name", name}, {"miscObjectCategory", category}});
      addBox(body, entity);
    } else {
      body = addElement(
          object, "Pedestrian",
          {{"mass", xmlNumber(agent_class == AgentClass::kChild ? kChildMass : kWalkerMass)},
           {"name", name},
           {"pedestrianCategory", category}});
      if (plan_.for_carla) body.append_attribute("model") = name.c_str();
      addBox(body, entity);
    }
    xml_node properties = addElement(body, "Properties");
    const auto add = [&](const char* name, const std::string& value) {
      addElement(properties, "Property", {{"name", name}, {"value", value}});
    };
    add("recorded_id", literal(entity.track->id));
    add("class", toString(agent_class));
    if (plan_.for_carla) {
      add("type", entity.track == &record_.ego ? "ego_vehicle" : "simulation");
    }
  }

 private:
  void addBox(xml_node body, const ScenarioEntity& entity) const {
    const double height = heightOf(*entity.track);
    xml_node box = addElement(body, "BoundingBox");
    addElement(box, "Center",
               {{"x", xmlNumber(entity.axle_to_middle)}, {"y", "0"}, {"z", xmlNumber(height / 2)}});
    addElement(box, "Dimensions",
               {{"length", xmlNumber(entity.track->size.length)},
                {"width", xmlNumber(entity.track->size.width)},
                {"height", xmlNumber(height)}});
  }

  void addPerformance(xml_node body, const ScenarioEntity& entity) const {
    const DriveLimits limits =
        driveLimitsOf(entity.track->agent_class, entity.track->size, plan_.limits);
    addElement(body, "Performance",
               {{"maxSpeed", xmlNumber(limits.max_speed)},
                {"maxAcceleration", xmlNumber(limits.max_forward_acceleration)},
                {"maxDeceleration", xmlNumber(limits.max_braking)}});
    xml_node axles = addElement(body, "Axles");
    const auto add = [&](const char* name, double steering, double x) {
      addElement(axles, name,
                 {{"maxSteering", xmlNumber(steering)},
                  {"wheelDiameter", xmlNumber(kWheelDiameter)},
                  {"trackWidth", xmlNumber(kTrackWidthShare * entity.track->size.width)},
                  {"positionX", xmlNumber(x)},
                  {"positionZ", xmlNumber(kWheelDiameter / 2)}});
    };
    add("FrontAxle", limits.max_steering_angle, limits.wheelbase);
    add("RearAxle", 0.0, 0.0);
  }

  const CrashRecord& record_;
  const ExportPlan& plan_;
};

/// Adds an entity per stretch in sight.
void addTrack(const std::string& name, const Track& track, const CrashRecord& record,
              const ExportPlan& plan, std::vector<ScenarioEntity>& entities) {
  const double ahead =
      isVehicle(track.agent_class) && !plan.for_carla
          ? driveLimitsOf(track.agent_class, track.size, plan.limits).axle_to_middle
          : 0.0;
  int number = 0;
  for (std::vector<AgentState>& states : splitAtGaps(track, record.step)) {
    if (states.size() < 2) continue;
    const std::string again = number++ == 0 ? "" : "_" + std::to_string(number);
    entities.push_back({name + again, &track, std::move(states), ahead});
  }
}

}  // namespace

std::vector<ScenarioEntity> scenarioEntities(const CrashRecord& record, const ExportPlan& plan) {
  std::vector<ScenarioEntity> entities = {
      {"ego", &record.ego, record.ego.states,
       plan.for_carla ? 0.0 : record.scenario.ego.center_offset}};
  addTrack("attacker", record.attacker, record, plan, entities);
  for (std::size_t i = 0; i < record.other_agents.size(); ++i) {
    addTrack("other_" + std::to_string(i + 1), record.other_agents[i], record, plan, entities);
  }
  return entities;
}

void addScenarioObject(pugi::xml_node entities, const ScenarioEntity& entity,
                       const CrashRecord& record, const ExportPlan& plan) {
  EntityWriter(record, plan).addObject(entities, entity);
}

std::string literal(const std::string& text) {
  return !text.empty() && text.front() == '$' ? "_" + text : text;
}

}  // namespace forge
