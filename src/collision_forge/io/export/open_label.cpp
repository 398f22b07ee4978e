#include "collision_forge/io/export/open_label.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/base/geometry/polygon.h"
#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/io/json/json_line.h"

namespace forge {
namespace {

using Tags = std::vector<std::string>;

constexpr const char* kAsam =
    "https://openlabel.asam.net/V1-0-0/ontologies/openlabel_ontology_scenario_tags.ttl";
constexpr const char* kNames = "collision_forge_names.ttl";
constexpr double kRunning = 2.0;  // m/s; Euro NCAP's adults walk at 1.39 and run at 2.22
constexpr double kTurn = 0.6;     // rad; a smaller change of heading is a bend or a lane change
constexpr double kKmh = 3.6;      // per m/s

/// All tags that asamTags() looks for.
const Tags kBoundary = {"HumanCyclist",
                        "HumanMotorcyclist",
                        "HumanPedestrian",
                        "JunctionIntersection",
                        "MotionAccelerate",
                        "MotionCross",
                        "MotionCutIn",
                        "MotionDecelerate",
                        "MotionDrive",
                        "MotionLaneChangeLeft",
                        "MotionLaneChangeRight",
                        "MotionOvertake",
                        "MotionReverse",
                        "MotionRun",
                        "MotionStop",
                        "MotionTowards",
                        "MotionTurnLeft",
                        "MotionTurnRight",
                        "MotionWalk",
                        "RoadUserAnimal",
                        "SpecialStructurePedestrianCrossing",
                        "SubjectVehicleSpeed",
                        "TravelDirectionLeft",
                        "TravelDirectionRight",
                        "VehicleBus",
                        "VehicleCar",
                        "VehicleConstruction",
                        "VehicleCycle",
                        "VehicleEmergency",
                        "VehicleMotorcycle",
                        "VehicleTrailer",
                        "VehicleTruck"};

Tags tagsOf(AgentClass agent_class) {
  switch (agent_class) {
    case AgentClass::kCar:
      return {"VehicleCar"};
    case AgentClass::kTruck:
      return {"VehicleTruck"};
    case AgentClass::kBus:
      return {"VehicleBus"};
    case AgentClass::kTrailer:
      return {"VehicleTrailer"};
    case AgentClass::kConstructionVehicle:
      return {"VehicleConstruction"};
    case AgentClass::kEmergencyVehicle:
      return {"VehicleEmergency"};
    case AgentClass::kMotorcycle:
      return {"VehicleMotorcycle", "HumanMotorcyclist"};
    case AgentClass::kBicycle:
      return {"VehicleCycle", "HumanCyclist"};
    case AgentClass::kScooter:
      return {"VehicleCycle"};
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
      return {"HumanPedestrian"};
    case AgentClass::kAnimal:
      return {"RoadUserAnimal"};
    case AgentClass::kStaticObject:
      return {};
  }
  return {};
}

Tags tagsOf(Manoeuvre manoeuvre) {
  switch (manoeuvre) {
    case Manoeuvre::kLeadStopped:
      return {"MotionStop"};
    case Manoeuvre::kLeadBrakes:
      return {"MotionDecelerate"};
    case Manoeuvre::kLeadSlow:
      return {"MotionDrive"};
    case Manoeuvre::kFollowerCloses:
    case Manoeuvre::kDrift:
    case Manoeuvre::kCentreLineCrossing:
    case Manoeuvre::kWrongWay:
      return {"MotionDrive", "MotionTowards"};
    case Manoeuvre::kCutIn:
      return {"MotionCutIn"};
    case Manoeuvre::kMerge:
      return {"MotionDrive"};
    case Manoeuvre::kPullOut:
      return {"MotionAccelerate"};
    case Manoeuvre::kOvertaking:
      return {"MotionOvertake", "MotionTowards"};
    case Manoeuvre::kStraightCrossing:
    case Manoeuvre::kTurnAcrossPath:
    case Manoeuvre::kSameDirectionTurn:
      return {"MotionCross"};
    case Manoeuvre::kTurnIntoPath:
      return {"MotionDrive"};
    case Manoeuvre::kBackOut:
      return {"MotionReverse"};
  }
  return {};
}

/// Returns the track's change of heading from t0 to the contact, rad, left positive.
double turnOf(const Track& track, const CrashRecord& record) {
  double turn = 0.0;
  const AgentState* before = nullptr;
  for (const AgentState& state : track.states) {
    if (state.time < record.now || state.time > record.contact.value_or(record.end())) continue;
    if (before) turn += wrapAngle(state.pose.yaw - before->pose.yaw);
    before = &state;
  }
  return turn;
}

bool changesLane(Manoeuvre manoeuvre) {
  return manoeuvre == Manoeuvre::kCutIn || manoeuvre == Manoeuvre::kMerge ||
         manoeuvre == Manoeuvre::kPullOut;
}

/// Returns the behaviour of the attacker. Pedestrians walk or run instead of driving.
Tags behaviourOf(const CrashRecord& record) {
  const Attack& attack = record.scenario.answer;
  const CollisionReport& report = attack.report;
  if (isOnFoot(attack.trajectory.agent_class)) {
    const double fastest =
        std::max_element(
            attack.trajectory.points.begin(), attack.trajectory.points.end(),
            [](const TrajectoryPoint& a, const TrajectoryPoint& b) { return a.speed < b.speed; })
            ->speed;
    Tags tags = {fastest > kRunning ? "MotionRun" : "MotionWalk"};
    if (record.scenario.asked.request.type == CollisionType::kJunctionCrossing) {
      tags.emplace_back("MotionCross");
    }
    return tags;
  }
  Tags tags = tagsOf(report.manoeuvre);
  const Pose2 offset = relativeTo(report.ego_at_contact, report.attacker_at_contact);
  if (changesLane(report.manoeuvre)) {
    tags.emplace_back(offset.y > 0.0 ? "MotionLaneChangeRight" : "MotionLaneChangeLeft");
  }
  const double turn = turnOf(record.attacker, record);
  if (!changesLane(report.manoeuvre) && std::abs(turn) > kTurn) {
    tags.emplace_back(turn > 0.0 ? "MotionTurnLeft" : "MotionTurnRight");
  }
  return tags;
}

/// Returns the text as a string of Turtle.
std::string quoted(const std::string& text) {
  std::string safe = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') safe += '\\';
    safe += letter == '\n' ? ' ' : letter;
  }
  return safe + "\"";
}

class OpenLabelWriter : public CrashWriter {
 public:
  explicit OpenLabelWriter(const ExportPlan& plan) : plan_(plan) {}

  std::vector<std::string> write(const CrashRecord& record) const override {
    JsonLineWriter json;
    json.beginObject();
    json.beginObject("openlabel");
    json.beginObject("metadata");
    json.text("schema_version", "1.0.0");
    json.text("name", record.name);
    json.text("annotator", "collision_forge");
    json.text("tagged_file", record.scenario.asked.scene);
    json.endObject();
    json.beginObject("ontologies");
    json.beginObject("0");
    json.text("uri", kAsam);
    json.text("boundary_mode", "include");
    json.texts("boundary_list", kBoundary);
    json.endObject();
    json.beginObject("1");
    json.text("uri", kNames);
    json.endObject();
    json.endObject();
    writeTags(record, json);
    json.endObject();
    json.endObject();
    const std::string file = record.name + ".openlabel.json";
    writeText(pathIn(plan_.folder, file), json.line() + "\n");
    return {file};
  }

  void finish(const std::vector<ExportedCrash>& /*crashes*/) const override {
    std::string text =
        "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
        "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n";
    for (const CatalogueEntry& entry : plan_.catalogue) {
      text += "<#" + entry.name + "> a owl:Class ; rdfs:label " + quoted(entry.name) +
              " ; rdfs:comment " + quoted(entry.text) + " .\n";
    }
    writeText(pathIn(plan_.folder, kNames), text);
  }

 private:
  void writeTags(const CrashRecord& record, JsonLineWriter& json) const {
    json.beginObject("tags");
    std::size_t count = 0;
    const auto begin = [&](const std::string& type, const char* ontology) {
      json.beginObject(std::to_string(count++).c_str());
      json.text("type", type);
      json.text("ontology_uid", ontology);
    };
    for (const std::string& tag : asamTags(record)) {
      begin(tag, "0");
      json.endObject();
    }
    begin("SubjectVehicleSpeed", "0");
    json.beginObject("tag_data");
    json.beginArray("num");
    json.beginObject();
    json.text("name", "subjectVehicleSpeedValue");
    const auto ego = stateAt(record.ego, record.now);
    json.number("val", std::round(kKmh * ego->velocity.norm() * 10.0) / 10.0);
    json.endObject();
    json.endArray();
    json.endObject();
    json.endObject();
    const SceneRequest& asked = record.scenario.asked;
    std::optional<ContactConditions> conditions;
    if (asksForConditions(asked.request)) conditions = record.scenario.answer.report.conditions;
    for (const CatalogueEntry& entry : plan_.catalogue) {
      if (!entry.missing.empty() ||
          !isInstance(entry.request, asked.request, record.scenario.answer, conditions)) {
        continue;
      }
      begin(entry.name, "1");
      json.endObject();
    }
    if (!asked.name.empty()) {
      begin(asked.name, "1");
      json.endObject();
    }
    json.endObject();
  }

  ExportPlan plan_;
};

}  // namespace

std::set<std::string> asamTags(const CrashRecord& record) {
  std::set<std::string> tags = {"VehicleCar", "MotionDrive"};  // the ego
  const auto add = [&tags](const Tags& more) { tags.insert(more.begin(), more.end()); };
  add(tagsOf(record.attacker.agent_class));
  for (const Track& agent : record.other_agents) add(tagsOf(agent.agent_class));
  add(behaviourOf(record));
  const double ego_turn = turnOf(record.ego, record);
  if (std::abs(ego_turn) > kTurn) {
    add({ego_turn > 0.0 ? "MotionTurnLeft" : "MotionTurnRight"});
  }
  add({record.lanes.driving_side == DrivingSide::kRight ? "TravelDirectionRight"
                                                        : "TravelDirectionLeft"});
  const Vector2 place = record.scenario.answer.report.attacker_at_contact.position();
  for (const Lane& lane : record.lanes.lanes) {
    const bool is_junction = lane.is_intersection || lane.is_connector;
    if (is_junction && contains({lane.polygon, {}}, place)) add({"JunctionIntersection"});
  }
  for (const MapFeature& feature : record.lanes.features) {
    if (feature.kind == FeatureKind::kCrosswalk && contains({feature.points, {}}, place)) {
      add({"SpecialStructurePedestrianCrossing"});
    }
  }
  return tags;
}

std::unique_ptr<CrashWriter> makeOpenLabelWriter(const ExportPlan& plan) {
  return std::make_unique<OpenLabelWriter>(plan);
}

}  // namespace forge
