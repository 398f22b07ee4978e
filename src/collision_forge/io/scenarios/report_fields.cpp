#include "collision_forge/io/scenarios/report_fields.h"

#include <string>

#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/io/scenarios/relative_time.h"
#include "collision_forge/io/scenarios/severity_fields.h"

namespace forge {
namespace {

void writeTextOrNull(JsonLineWriter& writer, const char* key, const std::string& value) {
  if (value.empty()) {
    writer.null(key);
  } else {
    writer.text(key, value);
  }
}

void writeMeasured(JsonLineWriter& writer, const ContactConditions& measured) {
  writer.beginObject("conditions");
  writer.text("from_side", toString(measured.from_side));
  for (const RangeControl& control : kRangeControls) {
    writer.number(control.name, measured.*control.measured);
  }
  if (measured.hidden_by) writer.text("hidden_by", toString(*measured.hidden_by));
  if (!measured.hidden_by_id.empty()) writer.text("hidden_by_id", measured.hidden_by_id);
  writer.endObject();
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

}  // namespace

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

CollisionReport readCollisionReport(JsonObject object, const LineContext& line) {
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
  if (line.has_severity) {
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
  if (!line.is_oldest) readFirstOtherTime(object, line, report);
  report.off_road_share = object.number("off_road_share");
  const auto manoeuvre = manoeuvreFromString(object.text("manoeuvre"));
  if (!manoeuvre) object.fail("manoeuvre", "is not a manoeuvre");
  report.manoeuvre = *manoeuvre;
  report.manoeuvre_begin = readTime(object, "manoeuvre_begin_t", line);
  report.road.on_lane = object.number("on_lane");
  report.road.wrong_way = object.number("wrong_way");
  if (!line.is_oldest) report.road.off_road = object.number("off_road");
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

}  // namespace forge
