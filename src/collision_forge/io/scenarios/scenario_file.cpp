#include "collision_forge/io/scenarios/scenario_file.h"

#include <cmath>

#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/io/json/input_line.h"
#include "collision_forge/io/scenarios/request_fields.h"
#include "collision_forge/io/scenarios/severity_fields.h"

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
constexpr const char* kRecorded = "recorded";
constexpr const char* kAdded = "added";

void writeTextOrNull(JsonLineWriter& writer, const char* key, const std::string& value) {
  if (value.empty()) {
    writer.null(key);
  } else {
    writer.text(key, value);
  }
}

void writePoseFields(JsonLineWriter& writer, const Pose2& pose) {
  writer.number("x", pose.x);
  writer.number("y", pose.y);
  writer.number("yaw", pose.yaw);
}

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

/// Writes speeds rounded to 1e-6 m/s, so that reading and writing gives the same bytes.
void writePast(JsonLineWriter& writer, const std::vector<AgentState>& past, double now) {
  if (past.empty()) {
    writer.null("past");
    return;
  }
  constexpr double kMicrometres = 1e6;  // per metre
  writer.beginArray("past");
  for (const AgentState& state : past) {
    const double speed = state.velocity.dot(state.pose.heading());
    writer.beginObject();
    writer.number("t", fromNow(state.time, now));
    writePoseFields(writer, state.pose);
    writer.number("v", std::round(speed * kMicrometres) / kMicrometres);
    writer.endObject();
  }
  writer.endArray();
}

void writePoints(JsonLineWriter& writer, const std::vector<TrajectoryPoint>& points, double now) {
  writer.beginArray("trajectory");
  for (const TrajectoryPoint& point : points) {
    writer.beginObject();
    writer.number("t", fromNow(point.time, now));
    writePoseFields(writer, point.pose);
    writer.number("v", point.speed);
    writer.number("a", point.acceleration);
    writer.number("kappa", point.curvature);
    writer.endObject();
  }
  writer.endArray();
}

void writeVehicle(JsonLineWriter& writer, const AttackerTrajectory& trajectory, double now) {
  writer.text("id", trajectory.attacker_id);
  writer.text("class", toString(trajectory.agent_class));
  writer.text("origin", trajectory.isAdded() ? kAdded : kRecorded);
  writer.number("length", trajectory.size.length);
  writer.number("width", trajectory.size.width);
  writePast(writer, trajectory.past, now);
  writePoints(writer, trajectory.points, now);
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

/// Context for reading the numbers of a line.
struct LineContext {
  const InputLimits& limits;
  int version = kVersion;
  double now = 0.0;  ///< s, the scene's clock

  bool isOld() const { return version == kOldestVersion; }
};

/// Returns a time on the scene's clock, s.
double readTime(JsonObject& object, const char* key, const LineContext& line) {
  return line.now + object.within(key, -line.limits.max_past, line.limits.max_trajectory);
}

double readSpeed(JsonObject& object, const char* key, const LineContext& line) {
  return object.within(key, -line.limits.max_speed, line.limits.max_speed);
}

BoxSize readBox(JsonObject& object, const InputLimits& limits) {
  return {object.within("length", limits.min_box, limits.max_box),
          object.within("width", limits.min_box, limits.max_box)};
}

Pose2 readPoseFields(JsonObject& object, const LineContext& line) {
  const double farthest = line.limits.max_coordinate;
  return {object.within("x", -farthest, farthest), object.within("y", -farthest, farthest),
          object.number("yaw")};
}

Pose2 readPose(JsonObject object, const LineContext& line) {
  const Pose2 pose = readPoseFields(object, line);
  object.finish();
  return pose;
}

/// Fails unless the time is after the previous state's.
template <typename State>
void checkTime(const JsonObject& entry, double time, const std::vector<State>& before) {
  if (!before.empty() && time <= before.back().time)
    entry.fail("t", "is not after the previous time");
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

/// Reads "past", which must hold states if `is_added` and be null otherwise.
std::vector<AgentState> readPast(JsonObject& object, bool is_added, const LineContext& line) {
  std::vector<AgentState> past;
  auto entries = object.objectsOrNull("past", line.limits.max_points);
  if (is_added != (entries && !entries->empty())) {
    object.fail("past", is_added ? "must hold the states of an added vehicle"
                                 : "must be null for a recorded vehicle");
  }
  if (!entries) return past;
  for (JsonObject& entry : *entries) {
    AgentState state;
    state.time = readTime(entry, "t", line);
    checkTime(entry, state.time, past);
    state.pose = readPoseFields(entry, line);
    state.velocity = readSpeed(entry, "v", line) * state.pose.heading();
    entry.finish();
    past.push_back(state);
  }
  return past;
}

bool readIsAdded(JsonObject& object) {
  const std::string origin = object.text("origin");
  if (origin != kAdded && origin != kRecorded) {
    object.fail("origin", std::string("is neither ") + kRecorded + " nor " + kAdded);
  }
  return origin == kAdded;
}

std::vector<TrajectoryPoint> readPoints(JsonObject& object, const LineContext& line) {
  std::vector<TrajectoryPoint> points;
  for (JsonObject& entry : object.objects("trajectory", line.limits.max_points)) {
    TrajectoryPoint point;
    point.time = readTime(entry, "t", line);
    checkTime(entry, point.time, points);
    point.pose = readPoseFields(entry, line);
    point.speed = readSpeed(entry, "v", line);
    point.acceleration = entry.number("a");
    point.curvature = entry.number("kappa");
    entry.finish();
    points.push_back(point);
  }
  return points;
}

/// Leaves fields of other structures that hold a vehicle unread.
AttackerTrajectory readVehicle(JsonObject& object, const LineContext& line) {
  AttackerTrajectory trajectory;
  trajectory.attacker_id = object.text("id");
  const auto agent_class = agentClassFromString(object.text("class"));
  if (!agent_class) object.fail("class", "is not an agent class");
  trajectory.agent_class = *agent_class;
  trajectory.past = readPast(object, readIsAdded(object), line);
  trajectory.size = readBox(object, line.limits);
  trajectory.points = readPoints(object, line);
  if (trajectory.points.empty()) object.fail("trajectory", "is empty");
  return trajectory;
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
  pattern.tolerance = line.isOld() ? kToleranceOfVersion5
                                   : object.within("tolerance", 0.0, line.limits.max_coordinate);
  miss = {object.number("miss_distance"), object.number("miss_heading")};
  object.finish();
  return pattern;
}

Side readSide(JsonObject& object, const char* key) {
  const std::string name = object.text(key);
  const auto side = sideFromString(name);
  if (!side) object.fail(key, "\"" + name + "\" is not a side of a box");
  return *side;
}

void readFirstOtherTime(JsonObject& object, const LineContext& line, CollisionReport& report) {
  constexpr const char* kField = "first_other_t";
  const auto time = object.numberOrNull(kField);
  if (time.has_value() == report.first_other_id.empty()) {
    object.fail(kField, "contradicts the field first_other");
  }
  if (!time) return;
  if (*time < -line.limits.max_past || *time > line.limits.max_trajectory) {
    object.fail(kField, "is beyond the limits of time");
  }
  report.first_other_time = line.now + *time;
}

ContactConditions readMeasured(JsonObject object) {
  ContactConditions measured;
  measured.from_side = readSide(object, "from_side");
  for (const RangeControl& control : kRangeControls) {
    // Older files lack the newest conditions.
    if (object.has(control.name)) measured.*control.measured = object.number(control.name);
  }
  if (object.has("hidden_by")) {
    const auto hider = hiderFromString(object.text("hidden_by"));
    if (!hider) object.fail("hidden_by", "is neither parked_vehicle nor leader");
    measured.hidden_by = *hider;
  }
  if (object.has("hidden_by_id")) measured.hidden_by_id = object.text("hidden_by_id");
  object.finish();
  return measured;
}

CollisionReport readReport(JsonObject object, const LineContext& line) {
  CollisionReport report;
  const bool is_verified = object.flag("verified");
  report.contact = object.flag("contact");
  report.contact_time = readTime(object, "contact_t", line);
  report.relative_heading = object.number("relative_heading");
  report.ego_at_contact = readPose(object.object("ego_at_contact"), line);
  report.attacker_at_contact = readPose(object.object("attacker_at_contact"), line);
  report.ego_side = readSide(object, "ego_side");
  report.attacker_side = readSide(object, "attacker_side");
  report.impact_speed = object.number("impact_speed");
  report.overlap = object.number("overlap");
  if (line.version > kWithoutSeverity) {
    auto severity = object.objectOrNull("severity");
    if (severity.has_value() != report.contact) {
      object.fail("severity", "contradicts the field contact");
    }
    if (severity) report.severity = readSeverity(*severity);
    report.careful_drivers = readCarefulDrivers(object, line.now);
  }
  report.type_kept = object.flag("type_kept");
  report.on_time = object.flag("on_time");
  report.limits_kept = object.flag("limits_kept");
  report.broken_limit = object.textOrNull("broken_limit").value_or("");
  report.first_other_id = object.textOrNull("first_other").value_or("");
  if (!line.isOld()) readFirstOtherTime(object, line, report);
  report.off_road_share = object.number("off_road_share");
  const auto manoeuvre = manoeuvreFromString(object.text("manoeuvre"));
  if (!manoeuvre) object.fail("manoeuvre", "is not a manoeuvre");
  report.manoeuvre = *manoeuvre;
  report.manoeuvre_begin = readTime(object, "manoeuvre_begin_t", line);
  report.road.on_lane = object.number("on_lane");
  report.road.wrong_way = object.number("wrong_way");
  if (!line.isOld()) report.road.off_road = object.number("off_road");
  report.road.on_walkway = object.number("on_walkway");
  report.road.on_island = object.number("on_island");
  const bool is_believable = object.flag("believable");
  report.unbelievable = object.textOrNull("unbelievable").value_or("");
  if (object.has("conditions")) report.conditions = readMeasured(object.object("conditions"));
  if (is_believable != report.believable()) {
    object.fail("believable", "contradicts the field unbelievable");
  }
  if (is_verified != report.verified()) {
    object.fail("verified", "contradicts the other fields of the report");
  }
  object.finish();
  return report;
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
  answer.report = readReport(object.object("report"), line);
  answer.report.confidence = object.number("confidence");
  if (!line.isOld()) answer.effort = object.number("effort");
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
    if (!line.isOld() && object.numberOrNull("effort")) {
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

void writePose(JsonLineWriter& writer, const char* key, const Pose2& pose) {
  writer.beginObject(key);
  writePoseFields(writer, pose);
  writer.endObject();
}

static void writeMeasured(JsonLineWriter& writer, const ContactConditions& measured) {
  writer.beginObject("conditions");
  writer.text("from_side", toString(measured.from_side));
  for (const RangeControl& control : kRangeControls) {
    writer.number(control.name, measured.*control.measured);
  }
  if (measured.hidden_by) writer.text("hidden_by", toString(*measured.hidden_by));
  if (!measured.hidden_by_id.empty()) writer.text("hidden_by_id", measured.hidden_by_id);
  writer.endObject();
}

void writeCollisionReport(JsonLineWriter& writer, const char* key, const CollisionReport& report,
                          double now, bool has_conditions) {
  writer.beginObject(key);
  writer.flag("verified", report.verified());
  writer.flag("contact", report.contact);
  writer.number("contact_t", fromNow(report.contact_time, now));
  writer.number("relative_heading", report.relative_heading);
  writePose(writer, "ego_at_contact", report.ego_at_contact);
  writePose(writer, "attacker_at_contact", report.attacker_at_contact);
  writer.text("ego_side", toString(report.ego_side));
  writer.text("attacker_side", toString(report.attacker_side));
  writer.number("impact_speed", report.impact_speed);
  writer.number("overlap", report.overlap);
  if (report.contact) {
    writeSeverity(writer, "severity", report.severity);
  } else {
    writer.null("severity");
  }
  writeCarefulDrivers(writer, report.careful_drivers, now);
  writer.flag("type_kept", report.type_kept);
  writer.flag("on_time", report.on_time);
  writer.flag("limits_kept", report.limits_kept);
  writeTextOrNull(writer, "broken_limit", report.broken_limit);
  writeTextOrNull(writer, "first_other", report.first_other_id);
  if (report.first_other_id.empty()) {
    writer.null("first_other_t");
  } else {
    writer.number("first_other_t", fromNow(report.first_other_time, now));
  }
  writer.number("off_road_share", report.off_road_share);
  writer.text("manoeuvre", toString(report.manoeuvre));
  writer.number("manoeuvre_begin_t", fromNow(report.manoeuvre_begin, now));
  writer.number("on_lane", report.road.on_lane);
  writer.number("wrong_way", report.road.wrong_way);
  writer.number("off_road", report.road.off_road);
  writer.number("on_walkway", report.road.on_walkway);
  writer.number("on_island", report.road.on_island);
  writer.flag("believable", report.believable());
  writeTextOrNull(writer, "unbelievable", report.unbelievable);
  if (has_conditions) writeMeasured(writer, report.conditions);
  writer.endObject();
}

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
  const LineContext line{limits, version, scenario.asked.now};
  scenario.asked.request = readRequest(object.object("request"));
  scenario.ego = readEgo(object.object("ego"), limits);
  scenario.answer.status = readStatus(object.object("status"));
  readAnswer(object, scenario, line, scenario.answer);
  scenario.plans = readPlans(object, scenario, line);
  object.finish();
  return scenario;
}

}  // namespace forge
