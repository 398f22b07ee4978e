#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "collision_forge/base/scene/attack.h"

namespace forge {

/// The fields of an attack by name. A new field of a struct breaks the build here; add it to each
/// function below, to wholeAttack(), to the scenario file and to the message.
using AttackFields = std::map<std::string, std::variant<double, std::string>>;

inline void addFields(const std::string& name, const Pose2& pose, AttackFields& fields) {
  const auto& [x, y, yaw] = pose;
  fields[name + ".x"] = x;
  fields[name + ".y"] = y;
  fields[name + ".yaw"] = yaw;
}

inline void addFields(const std::string& name, const BoxSize& size, AttackFields& fields) {
  const auto& [length, width] = size;
  fields[name + ".length"] = length;
  fields[name + ".width"] = width;
}

inline void addFields(const CollisionPattern& pattern, AttackFields& fields) {
  const auto& [type, attacker_id, time, ego, attacker_offset, attacker_speed, tolerance] = pattern;
  fields["aim.type"] = toString(type);
  fields["aim.attacker_id"] = attacker_id;
  fields["aim.time"] = time;
  addFields("aim.ego", ego.center, fields);
  addFields("aim.ego", ego.size, fields);
  addFields("aim.attacker_offset", attacker_offset, fields);
  fields["aim.attacker_speed"] = attacker_speed;
  fields["aim.tolerance"] = tolerance;
}

inline void addFields(const std::string& vehicle, const AttackerTrajectory& trajectory,
                      AttackFields& fields) {
  const auto& [attacker_id, agent_class, size, points, past] = trajectory;
  fields[vehicle + ".attacker_id"] = attacker_id;
  fields[vehicle + ".agent_class"] = toString(agent_class);
  addFields(vehicle, size, fields);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string name = vehicle + ".points[" + std::to_string(i) + "]";
    const auto& [time, pose, speed, acceleration, curvature] = points[i];
    fields[name + ".time"] = time;
    addFields(name, pose, fields);
    fields[name + ".speed"] = speed;
    fields[name + ".acceleration"] = acceleration;
    fields[name + ".curvature"] = curvature;
  }
  for (std::size_t i = 0; i < past.size(); ++i) {
    const std::string name = vehicle + ".past[" + std::to_string(i) + "]";
    const auto& [time, pose, velocity] = past[i];
    fields[name + ".time"] = time;
    addFields(name, pose, fields);
    fields[name + ".velocity.x"] = velocity.x();
    fields[name + ".velocity.y"] = velocity.y();
  }
}

inline void addFields(const std::string& name, const CrashEffect& effect, AttackFields& fields) {
  const auto& [delta_v, force_from, yaw_rate_change, mais2, mais3, curve, least_class, most_class] =
      effect;
  fields[name + ".delta_v"] = delta_v;
  fields[name + ".force_from"] = force_from;
  fields[name + ".yaw_rate_change"] = yaw_rate_change;
  fields[name + ".mais2"] = mais2;
  fields[name + ".mais3"] = mais3;
  fields[name + ".curve"] = curve;
  fields[name + ".least_class"] = static_cast<double>(least_class);
  fields[name + ".most_class"] = static_cast<double>(most_class);
}

inline void addFields(const CollisionReport& report, AttackFields& fields) {
  const auto& [contact, contact_time, relative_heading, ego_at_contact, attacker_at_contact,
               ego_side, attacker_side, impact_speed, overlap, severity, careful_drivers, type_kept,
               on_time, limits_kept, broken_limit, first_other_id, first_other_time, off_road_share,
               confidence, conditions, manoeuvre, manoeuvre_begin, road, unbelievable] = report;
  const auto& [on_lane, wrong_way, off_road, on_walkway, on_island] = road;
  fields["report.contact"] = contact ? 1.0 : 0.0;
  fields["report.contact_time"] = contact_time;
  fields["report.relative_heading"] = relative_heading;
  addFields("report.ego_at_contact", ego_at_contact, fields);
  addFields("report.attacker_at_contact", attacker_at_contact, fields);
  fields["report.ego_side"] = toString(ego_side);
  fields["report.attacker_side"] = toString(attacker_side);
  fields["report.impact_speed"] = impact_speed;
  fields["report.overlap"] = overlap;
  const auto& [ego, other, energy_lost] = severity;
  addFields("report.severity.ego", ego, fields);
  addFields("report.severity.other", other, fields);
  fields["report.severity.energy_lost"] = energy_lost;
  for (std::size_t i = 0; i < careful_drivers.size(); ++i) {
    const std::string name = "report.careful_drivers[" + std::to_string(i) + "]";
    const auto& [driver, avoids, brakes_at] = careful_drivers[i];
    fields[name + ".driver"] = driver;
    fields[name + ".avoids"] = avoids ? 1.0 : 0.0;
    fields[name + ".brakes_at"] = brakes_at.value_or(0.0);
  }
  fields["report.type_kept"] = type_kept ? 1.0 : 0.0;
  fields["report.on_time"] = on_time ? 1.0 : 0.0;
  fields["report.limits_kept"] = limits_kept ? 1.0 : 0.0;
  fields["report.broken_limit"] = broken_limit;
  fields["report.first_other_id"] = first_other_id;
  fields["report.first_other_time"] = first_other_time;
  fields["report.off_road_share"] = off_road_share;
  fields["report.confidence"] = confidence;
  const auto& [attacker_speed, deceleration, gap, headway, lateral_speed, impact_location,
               departure_time, from_side, visible_for, hidden_by, hidden_by_id] = conditions;
  fields["report.conditions.attacker_speed"] = attacker_speed;
  fields["report.conditions.deceleration"] = deceleration;
  fields["report.conditions.gap"] = gap;
  fields["report.conditions.headway"] = headway;
  fields["report.conditions.lateral_speed"] = lateral_speed;
  fields["report.conditions.impact_location"] = impact_location;
  fields["report.conditions.departure_time"] = departure_time;
  fields["report.conditions.from_side"] = toString(from_side);
  fields["report.conditions.visible_for"] = visible_for;
  fields["report.conditions.hidden_by"] = hidden_by ? toString(*hidden_by) : "";
  fields["report.conditions.hidden_by_id"] = hidden_by_id;
  fields["report.manoeuvre"] = toString(manoeuvre);
  fields["report.manoeuvre_begin"] = manoeuvre_begin;
  fields["report.road.on_lane"] = on_lane;
  fields["report.road.wrong_way"] = wrong_way;
  fields["report.road.off_road"] = off_road;
  fields["report.road.on_walkway"] = on_walkway;
  fields["report.road.on_island"] = on_island;
  fields["report.unbelievable"] = unbelievable;
}

/// Compares all fields except the alternatives.
inline AttackFields fieldsOf(const Attack& attack) {
  const auto& [status, aim, miss, trajectory, report, effort, supports, alternatives] = attack;
  const auto& [code, message] = status;
  const auto& [distance, heading] = miss;
  AttackFields fields;
  fields["status.code"] = toString(code);
  fields["status.message"] = message;
  addFields(aim, fields);
  fields["miss.distance"] = distance;
  fields["miss.heading"] = heading;
  addFields("trajectory", trajectory, fields);
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const std::string name = "supports[" + std::to_string(i) + "]";
    const auto& [role, motion] = supports[i];
    fields[name + ".role"] = toString(role);
    addFields(name, motion, fields);
  }
  addFields(report, fields);
  fields["effort"] = effort;
  return fields;
}

/// An attack whose fields all differ from the defaults and whose numbers all differ from each
/// other. The attacker is an added vehicle with velocity along its heading; there are no
/// alternatives.
inline Attack wholeAttack(double now) {
  Attack attack;
  attack.pattern = {CollisionType::kLaneChange, "a1", now + 4.0, {{40.0, 1.0, 0.5}, {4.084, 1.73}},
                    {-4.3, 0.25, 0.125},        12.5, 1.75};
  attack.miss = {0.28, 0.0625};
  const Pose2 before{-8.0, 2.0, 0.3};
  const Pose2 start{1.5, 2.5, 0.26};
  attack.trajectory = {
      "a1",
      AgentClass::kTruck,
      {4.6, 1.9},
      {{now, start, 9.0, 0.55, 0.01}, {now + 0.1, {2.4, 2.6, 0.27}, 9.05, -0.6, -0.02}},
      {{now - 0.5, before, 9.125 * before.heading()}, {now, start, 9.25 * start.heading()}}};
  CollisionReport& report = attack.report;
  report.contact = report.type_kept = report.on_time = report.limits_kept = true;
  report.contact_time = now + 3.875;
  report.relative_heading = 0.07;
  report.ego_at_contact = {39.0, 1.1, 0.51};
  report.attacker_at_contact = {34.5, 1.25, 0.5625};
  report.ego_side = Side::kLeft;
  report.attacker_side = Side::kRight;
  report.impact_speed = 4.5;
  report.overlap = 0.375;
  report.severity = {{5.3, 0.4, -0.6, 0.11, 0.013, "front", 1, 2},
                     {3.2, -0.35, 0.8, 0.09, 0.014, "rear", 2, 3},
                     20500.0};
  report.careful_drivers = {{"cc_driver", true, now + 2.25}, {"rss", false, {}}};
  report.broken_limit = "jerk";
  report.first_other_id = "b7";
  report.first_other_time = now + 3.25;
  report.off_road_share = 0.75;
  report.confidence = 0.65;
  report.conditions = {11.5, 2.25,         17.5,  1.625,          0.875, 0.3125,
                       1.75, Side::kRight, 1.375, Hider::kLeader, "b9"};
  report.manoeuvre = Manoeuvre::kCutIn;
  report.manoeuvre_begin = now + 1.5;
  report.road = {0.52, 0.24, 0.15, 0.12, 0.05};
  report.unbelievable = "is on a walkway for 12 %";
  attack.effort = 0.03;
  const Pose2 kerb{22.0, -4.5, 0.04};
  attack.supports = {
      {SupportRole::kQueue,
       {"parked-1",
        AgentClass::kBus,
        {11.5, 2.75},
        {{now, kerb, 0.7, 0.35, 0.03}, {now + 5.0, {23.0, -4.6, 0.06}, 0.8, 0.45, 0.05}},
        {{now - 0.5, kerb, 0.9 * kerb.heading()}, {now, kerb, 0.95 * kerb.heading()}}}}};
  return attack;
}

/// Compares numbers to 1e-6 m and 1e-6 s.
inline void expectSame(const Attack& found, const Attack& expected) {
  const AttackFields fields = fieldsOf(found);
  const AttackFields wanted = fieldsOf(expected);
  ASSERT_EQ(fields.size(), wanted.size());
  for (const auto& [name, value] : wanted) {
    if (const double* number = std::get_if<double>(&value)) {
      EXPECT_NEAR(std::get<double>(fields.at(name)), *number, 1e-6) << name;
    } else {
      EXPECT_EQ(std::get<std::string>(fields.at(name)), std::get<std::string>(value)) << name;
    }
  }
}

}  // namespace forge
