#include "collision_forge/ros/messages/report_text.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/base/scene/track.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

std::string severityText(const collision_forge::CollisionReport& report) {
  const CrashSeverity severity = fromMessage(report).severity;
  const std::string injury = injuryText(severity.worse());
  return "ego's delta-v " + deltaVText(severity.ego) + (injury.empty() ? "" : ", " + injury);
}

std::string avoidanceText(const std::vector<collision_forge::CarefulDrive>& drives) {
  std::string names;
  for (const collision_forge::CarefulDrive& drive : drives) {
    if (drive.avoids) names += (names.empty() ? "" : ", ") + drive.driver;
  }
  return "avoided by " + (names.empty() ? "no careful driver" : names);
}

/// Worded to follow "seen".
std::string sightText(const collision_forge::ContactConditions& conditions) {
  if (conditions.hidden_by_id.empty()) return "since t0";
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "for " << conditions.visible_for << " s, before "
       << "hidden by " << (conditions.hidden_by.empty() ? "" : conditions.hidden_by + " ")
       << conditions.hidden_by_id;
  return text.str();
}

}  // namespace

std::string lineOf(const collision_forge::CollisionReport& report) {
  if (!report.contact) return "no contact";
  constexpr double kDegrees = 180.0 / M_PI;
  const ros::Time& now = report.header.stamp;
  std::ostringstream line;
  line << std::fixed << std::setprecision(2)
       << (report.verified ? "crash as requested" : "contact, not as requested") << ", "
       << (report.contact_time - now).toSec() << " s after t0, relative heading "
       << report.relative_heading * kDegrees << " degrees, attacker's " << report.attacker_side
       << " to ego's " << report.ego_side << ", impact speed " << report.impact_speed
       << " m/s, overlap " << 100.0 * report.overlap << " %, " << severityText(report) << ", "
       << (report.limits_kept ? "limits kept" : report.broken_limit)
       << (report.first_other_id.empty() ? "" : ", touches " + report.first_other_id + " first")
       << ", " << 100.0 * report.off_road_share << " % off road, " << report.manoeuvre << " from "
       << (report.manoeuvre_begin - now).toSec() << " s on, "
       << (report.believable ? "plausible" : "not plausible: it " + report.unbelievable);
  line << ", seen " << sightText(report.conditions);
  if (!report.careful_drivers.empty()) line << ", " << avoidanceText(report.careful_drivers);
  return line.str();
}

std::string summaryOf(const collision_forge::Attack& attack) {
  const collision_forge::AttackerTrajectory& attacker = attack.trajectory;
  std::ostringstream line;
  line << attack.pattern.collision_type << " by " << attacker.attacker_id << ", "
       << (attacker.added ? "an added " : "a recorded ")
       << toString(static_cast<AgentClass>(attacker.agent_class)) << ", confidence "
       << percentText(attack.report.confidence) << ": " << lineOf(attack.report);
  return line.str();
}

}  // namespace forge
