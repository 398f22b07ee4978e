#include "collision_forge/io/scenarios/scenario_file.h"

#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/io/json/input_line.h"
#include "collision_forge/io/scenarios/motion_fields.h"
#include "collision_forge/io/scenarios/report_fields.h"
#include "collision_forge/io/scenarios/request_fields.h"

namespace forge {
namespace {

constexpr const char* kFormat = "collision_forge/scenario";
// 1: pattern was the contact, not the prediction; 2: no classes, added vehicles, constraints or
// believability; 3: no alternatives; 4: no adaptive attackers; 5: as 6, without tolerance, effort,
// first_other_t and off_road; 6: as 7, without severity and careful_drivers.
constexpr int kVersion = 7;
constexpr int kWithoutSeverity = 6;
constexpr int kOldestVersion = 5;
// m, for lines of version 5: the tolerance of all patterns except a network's own (prediction.yaml)
// when such files were written.
constexpr double kToleranceOfVersion5 = 4.0;

void writeRequest(JsonLineWriter& writer, const CollisionRequest& request) {
  writer.beginObject("request");
  writer.text("type", toString(request.type));
  writer.number("tta", request.tta);
  if (request.attacker) {
    writer.text("attacker", *request.attacker);
  } else {
    writer.null("attacker");
  }
  writeControls(writer, request);
  writer.text("mode", toString(request.mode));
  writer.count("seed", request.seed);
  writer.endObject();
}

void writeStatus(JsonLineWriter& writer, const Status& status) {
  writer.beginObject("status");
  writer.text("code", toString(status.code));
  writer.text("message", status.message);
  writer.endObject();
}

/// Writes nothing if there are none.
void writeSupports(JsonLineWriter& writer, const std::vector<SupportVehicle>& supports,
                   double now) {
  if (supports.empty()) return;
  writer.beginArray("supports");
  for (const SupportVehicle& support : supports) {
    writer.beginObject();
    writer.text("role", toString(support.role));
    writeVehicle(writer, support.motion, now);
    writer.endObject();
  }
  writer.endArray();
}

void writePattern(JsonLineWriter& writer, const CollisionPattern& pattern, const PatternMiss& miss,
                  double now) {
  writer.beginObject("pattern");
  writer.number("t", fromNow(pattern.time, now));
  writePose(writer, "ego", pattern.ego.center);
  writePose(writer, "attacker_offset", pattern.attacker_offset);
  writer.number("attacker_speed", pattern.attacker_speed);
  writer.number("tolerance", pattern.tolerance);
  writer.number("miss_distance", miss.distance);
  writer.number("miss_heading", miss.heading);
  writer.endObject();
}

void writeAttack(JsonLineWriter& writer, const Attack& answer, double now, bool has_conditions) {
  writer.beginObject("attacker");
  writeVehicle(writer, answer.trajectory, now);
  writer.endObject();
  writeSupports(writer, answer.supports, now);
  writePattern(writer, answer.pattern, answer.miss, now);
  writer.number("confidence", answer.report.confidence);
  writer.number("effort", answer.effort);
  writeCollisionReport(writer, "report", answer.report, now, has_conditions);
}

void writeAnswer(JsonLineWriter& writer, const Attack& answer, double now, bool has_conditions) {
  if (answer.status.code == StatusCode::kOk) {
    writeAttack(writer, answer, now, has_conditions);
  } else {
    for (const char* key : {"attacker", "pattern", "confidence", "effort", "report"}) {
      writer.null(key);
    }
  }
  writer.beginArray("alternatives");
  for (const Attack& alternative : answer.alternatives) {
    writer.beginObject();
    writeAttack(writer, alternative, now, has_conditions);
    writer.endObject();
  }
  writer.endArray();
}

CollisionRequest readRequest(JsonObject object) {
  CollisionRequest request;
  const auto type = collisionTypeFromString(object.text("type"));
  if (!type) object.fail("type", "is not a collision type");
  const auto mode = modeFromString(object.text("mode"));
  if (!mode) object.fail("mode", "is neither history nor replay nor adaptive");
  request.type = *type;
  request.tta = object.number("tta");
  request.attacker = object.textOrNull("attacker");
  readControls(object, request, false);
  request.mode = *mode;
  request.seed = object.count("seed");
  object.finish();
  return request;
}

Status readStatus(JsonObject object) {
  Status status;
  const auto code = statusCodeFromString(object.text("code"));
  if (!code) object.fail("code", "is not a status code");
  status.code = *code;
  status.message = object.text("message");
  object.finish();
  return status;
}

std::vector<SupportVehicle> readSupports(JsonObject& object, const LineContext& line) {
  std::vector<SupportVehicle> supports;
  if (!object.has("supports")) return supports;
  for (JsonObject& entry : object.objects("supports", kMaxSupports)) {
    const auto role = supportRoleFromString(entry.text("role"));
    if (!role) entry.fail("role", "is none of parked_vehicle, leader and queue");
    supports.push_back({*role, readVehicle(entry, line)});
    entry.finish();
  }
  return supports;
}

std::vector<AttackerPlan> readPlans(JsonObject& object, const Scenario& scenario,
                                    const LineContext& line) {
  std::vector<AttackerPlan> plans;
  for (JsonObject& entry : object.objects("plans", line.limits.max_points)) {
    AttackerPlan& plan = plans.emplace_back();
    plan.seen = readTime(entry, "seen_t", line);
    plan.from = readTime(entry, "from_t", line);
    const auto phase = attackerPhaseFromString(entry.text("phase"));
    if (!phase) entry.fail("phase", "is not a phase of an attacker");
    plan.phase = *phase;
    plan.reason = entry.text("reason");
    plan.points = readPoints(entry, line);
    entry.finish();
  }
  const bool is_adaptive = scenario.asked.request.mode == Mode::kAdaptive &&
                           scenario.answer.status.code == StatusCode::kOk;
  if (is_adaptive == plans.empty()) {
    object.fail("plans", "must be given for an attack in mode adaptive, and be empty otherwise");
  }
  return plans;
}

CollisionPattern readPattern(JsonObject object, const LineContext& line, PatternMiss& miss) {
  CollisionPattern pattern;
  pattern.time = readTime(object, "t", line);
  pattern.ego.center = readPose(object.object("ego"), line);
  pattern.attacker_offset = readPose(object.object("attacker_offset"), line);
  pattern.attacker_speed = readSpeed(object, "attacker_speed", line);
  pattern.tolerance = line.is_oldest ? kToleranceOfVersion5
                                     : object.within("tolerance", 0.0, line.limits.max_coordinate);
  miss = {object.number("miss_distance"), object.number("miss_heading")};
  object.finish();
  return pattern;
}

EgoVehicle readEgo(JsonObject object, const InputLimits& limits) {
  const EgoVehicle ego{readBox(object, limits),
                       object.within("center_offset", -limits.max_box, limits.max_box)};
  object.finish();
  return ego;
}

/// Checks the format and returns its version.
int readFormat(JsonObject& object) {
  if (object.text("format") != kFormat) {
    object.fail("format", std::string("is not ") + kFormat);
  }
  const double version = object.number("version");
  if (version != kVersion && version != kWithoutSeverity && version != kOldestVersion) {
    object.fail("version", "is not a version from " + std::to_string(kOldestVersion) + " to " +
                               std::to_string(kVersion) + "; generate the file again");
  }
  return static_cast<int>(version);
}

void readAttack(JsonObject& object, const Scenario& scenario, const LineContext& line,
                Attack& answer) {
  JsonObject attacker = object.object("attacker");
  answer.trajectory = readVehicle(attacker, line);
  attacker.finish();
  answer.supports = readSupports(object, line);
  answer.pattern = readPattern(object.object("pattern"), line, answer.miss);
  answer.pattern.type = scenario.asked.request.type;
  answer.pattern.attacker_id = answer.trajectory.attacker_id;
  answer.pattern.ego.size = scenario.ego.size;
  answer.report = readCollisionReport(object.object("report"), line);
  answer.report.confidence = object.number("confidence");
  if (!line.is_oldest) answer.effort = object.number("effort");
}

/// Reads the attack, which must be null unless the status is OK.
void readAnswer(JsonObject& object, const Scenario& scenario, const LineContext& line,
                Attack& answer) {
  const bool is_attack = answer.status.code == StatusCode::kOk;
  if (is_attack) {
    readAttack(object, scenario, line, answer);
  } else {
    for (const char* key : {"attacker", "pattern", "report"}) {
      if (object.objectOrNull(key)) object.fail(key, "must be null without an attack");
    }
    if (object.numberOrNull("confidence"))
      object.fail("confidence", "must be null without an attack");
    if (!line.is_oldest && object.numberOrNull("effort")) {
      object.fail("effort", "must be null without an attack");
    }
  }
  for (JsonObject& entry : object.objects("alternatives", kMaxAlternatives)) {
    if (!is_attack) object.fail("alternatives", "must be empty without an attack");
    Attack& alternative = answer.alternatives.emplace_back();
    readAttack(entry, scenario, line, alternative);
    entry.finish();
  }
}

}  // namespace

void writePlans(JsonLineWriter& writer, const std::vector<AttackerPlan>& plans, double now,
                const WritePoints& write_points) {
  writer.beginArray("plans");
  for (const AttackerPlan& plan : plans) {
    writer.beginObject();
    writer.number("seen_t", fromNow(plan.seen, now));
    writer.number("from_t", fromNow(plan.from, now));
    writer.text("phase", toString(plan.phase));
    writer.text("reason", plan.reason);
    write_points(writer, plan.points, now);
    writer.endObject();
  }
  writer.endArray();
}

std::string scenarioLine(const Scenario& scenario) {
  const double now = scenario.asked.now;
  JsonLineWriter writer;
  writer.beginObject();
  writer.text("format", kFormat);
  writer.count("version", kVersion);
  writer.text("scene", scenario.asked.scene);
  writer.number("now", now);
  if (!scenario.asked.name.empty()) writer.text("name", scenario.asked.name);
  writeRequest(writer, scenario.asked.request);
  writeStatus(writer, scenario.answer.status);
  writeAnswer(writer, scenario.answer, now, asksForConditions(scenario.asked.request));
  writePlans(writer, scenario.plans, now, writePoints);
  writer.beginObject("ego");
  writer.number("length", scenario.ego.size.length);
  writer.number("width", scenario.ego.size.width);
  writer.number("center_offset", scenario.ego.center_offset);
  writer.endObject();
  writer.endObject();
  return writer.line();
}

Scenario readScenarioLine(const std::string& where, const std::string& text,
                          const InputLimits& limits) {
  checkLineLength(where, text.size(), limits);
  const JsonLine parsed(where, text);
  JsonObject object = parsed.root();
  const int version = readFormat(object);
  Scenario scenario;
  scenario.asked.scene = object.text("scene");
  scenario.asked.now = object.within("now", 0.0, limits.max_time);
  if (object.has("name")) scenario.asked.name = object.text("name");
  const LineContext line{limits, version == kOldestVersion, version > kWithoutSeverity,
                         scenario.asked.now};
  scenario.asked.request = readRequest(object.object("request"));
  scenario.ego = readEgo(object.object("ego"), limits);
  scenario.answer.status = readStatus(object.object("status"));
  readAnswer(object, scenario, line, scenario.answer);
  scenario.plans = readPlans(object, scenario, line);
  object.finish();
  return scenario;
}

}  // namespace forge
