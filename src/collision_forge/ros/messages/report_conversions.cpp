#include "collision_forge/ros/messages/conversions.h"

#include "collision_forge/ros/messages/field_values.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

CrashEffect fromMessage(const collision_forge::CrashEffect& message) {
  return {message.delta_v, message.force_from, message.yaw_rate_change, message.mais2,
          message.mais3,   message.curve,      message.least_class,     message.most_class};
}

CarefulDrive fromMessage(const collision_forge::CarefulDrive& message) {
  CarefulDrive drive{message.driver, static_cast<bool>(message.avoids), {}};
  if (message.brakes) drive.brakes_at = message.brakes_at.toSec();
  return drive;
}

ContactConditions fromMessage(const collision_forge::ContactConditions& message) {
  ContactConditions measured;
  if (!message.from_side.empty()) {
    measured.from_side = wordIn(message.from_side, "from_side", sideFromString);
  }
  measured.attacker_speed = message.attacker_speed;
  measured.deceleration = message.deceleration;
  measured.gap = message.gap;
  measured.headway = message.headway;
  measured.lateral_speed = message.lateral_speed;
  measured.impact_location = message.impact_location;
  measured.departure_time = message.departure_time;
  measured.visible_for = message.visible_for;
  if (!message.hidden_by.empty()) {
    measured.hidden_by = wordIn(message.hidden_by, "hidden_by", hiderFromString);
  }
  measured.hidden_by_id = message.hidden_by_id;
  return measured;
}

collision_forge::ContactConditions toMessage(const ContactConditions& measured) {
  collision_forge::ContactConditions message;
  message.from_side = toString(measured.from_side);
  message.attacker_speed = measured.attacker_speed;
  message.deceleration = measured.deceleration;
  message.gap = measured.gap;
  message.headway = measured.headway;
  message.lateral_speed = measured.lateral_speed;
  message.impact_location = measured.impact_location;
  message.departure_time = measured.departure_time;
  message.visible_for = measured.visible_for;
  if (measured.hidden_by) message.hidden_by = toString(*measured.hidden_by);
  message.hidden_by_id = measured.hidden_by_id;
  return message;
}

}  // namespace

collision_forge::CrashEffect toMessage(const CrashEffect& effect) {
  collision_forge::CrashEffect message;
  message.delta_v = effect.delta_v;
  message.force_from = effect.force_from;
  message.yaw_rate_change = effect.yaw_rate_change;
  message.mais2 = effect.mais2;
  message.mais3 = effect.mais3;
  message.curve = effect.curve;
  message.least_class = static_cast<std::uint8_t>(effect.least_class);
  message.most_class = static_cast<std::uint8_t>(effect.most_class);
  return message;
}

collision_forge::CarefulDrive toMessage(const CarefulDrive& drive) {
  collision_forge::CarefulDrive message;
  message.driver = drive.driver;
  message.avoids = drive.avoids;
  message.brakes = drive.brakes_at.has_value();
  if (drive.brakes_at) message.brakes_at = stampOf(*drive.brakes_at);
  return message;
}

CollisionReport fromMessage(const collision_forge::CollisionReport& message) {
  CollisionReport report;
  report.contact = message.contact;
  if (message.contact) {
    report.contact_time = message.contact_time.toSec();
    report.relative_heading = message.relative_heading;
    report.ego_at_contact = fromMessage(message.ego_at_contact);
    report.attacker_at_contact = fromMessage(message.attacker_at_contact);
    report.ego_side = wordIn(message.ego_side, "ego_side", sideFromString);
    report.attacker_side = wordIn(message.attacker_side, "attacker_side", sideFromString);
    report.impact_speed = message.impact_speed;
    report.overlap = message.overlap;
    report.conditions = fromMessage(message.conditions);
    report.severity = {fromMessage(message.ego_effect), fromMessage(message.attacker_effect),
                       message.energy_lost};
    report.manoeuvre = wordIn(message.manoeuvre, "manoeuvre", manoeuvreFromString);
    report.manoeuvre_begin = message.manoeuvre_begin.toSec();
  }
  for (const collision_forge::CarefulDrive& drive : message.careful_drivers) {
    report.careful_drivers.push_back(fromMessage(drive));
  }
  report.type_kept = message.type_kept;
  report.on_time = message.on_time;
  report.limits_kept = message.limits_kept;
  report.broken_limit = message.broken_limit;
  report.first_other_id = message.first_other_id;
  report.first_other_time = message.first_other_time.toSec();
  report.off_road_share = message.off_road_share;
  report.road = {message.on_lane, message.wrong_way, message.off_road, message.on_walkway,
                 message.on_island};
  report.unbelievable = message.unbelievable;
  report.confidence = message.confidence;
  return report;
}

collision_forge::CollisionReport toMessage(const CollisionReport& report,
                                           const std::string& attacker_id, double now) {
  collision_forge::CollisionReport message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stampOf(now);
  message.attacker_id = attacker_id;
  message.verified = report.verified();
  message.contact = report.contact;
  if (report.contact) {
    message.contact_time = stampOf(report.contact_time);
    message.relative_heading = report.relative_heading;
    message.ego_at_contact = toPose2dMessage(report.ego_at_contact);
    message.attacker_at_contact = toPose2dMessage(report.attacker_at_contact);
    message.ego_side = toString(report.ego_side);
    message.attacker_side = toString(report.attacker_side);
    message.impact_speed = report.impact_speed;
    message.overlap = report.overlap;
    message.conditions = toMessage(report.conditions);
    message.energy_lost = report.severity.energy_lost;
    message.ego_effect = toMessage(report.severity.ego);
    message.attacker_effect = toMessage(report.severity.other);
    message.manoeuvre = toString(report.manoeuvre);
    message.manoeuvre_begin = stampOf(report.manoeuvre_begin);
  }
  for (const CarefulDrive& drive : report.careful_drivers) {
    message.careful_drivers.push_back(toMessage(drive));
  }
  message.type_kept = report.type_kept;
  message.on_time = report.on_time;
  message.limits_kept = report.limits_kept;
  message.broken_limit = report.broken_limit;
  message.first_other_id = report.first_other_id;
  if (!report.first_other_id.empty()) message.first_other_time = stampOf(report.first_other_time);
  message.off_road_share = report.off_road_share;
  message.on_lane = report.road.on_lane;
  message.wrong_way = report.road.wrong_way;
  message.off_road = report.road.off_road;
  message.on_walkway = report.road.on_walkway;
  message.on_island = report.road.on_island;
  message.believable = report.believable();
  message.unbelievable = report.unbelievable;
  message.confidence = report.confidence;
  return message;
}

}  // namespace forge
