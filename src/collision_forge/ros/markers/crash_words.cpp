#include "collision_forge/ros/markers/crash_words.h"

#include <cmath>

#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/base/scene/short_id.h"
#include "collision_forge/ros/markers/marker_parts.h"

namespace forge {
namespace {

/// Returns the condition that a contact violates.
std::string shortcoming(const collision_forge::CollisionReport& tested) {
  if (!tested.type_kept) return "of another type";
  if (!tested.on_time) return "at another time";
  if (!tested.limits_kept) return "beyond " + tested.broken_limit;
  if (!tested.first_other_id.empty()) {
    return "after touching " + shortId(tested.first_other_id);
  }
  return "not verified";
}

}  // namespace

const collision_forge::CollisionReport* verdictBy(const ros::Time& now,
                                                  const collision_forge::Attack& attack,
                                                  const collision_forge::CollisionReport* tested) {
  if (!tested || tested->attacker_id != attack.trajectory.attacker_id) return nullptr;
  if (tested->header.stamp != attack.header.stamp || attack.trajectory.points.empty()) {
    return nullptr;
  }
  const ros::Time end = attack.trajectory.points.back().stamp;
  return now < (tested->contact ? tested->contact_time : end) ? nullptr : tested;
}

std::string countdownWords(const collision_forge::Attack& attack, const ros::Time& now) {
  if (!attack.report.contact) return "no contact predicted";
  const double left = (attack.report.contact_time - now).toSec();
  return left > 0.0 ? formatted("contact in %.1f s", left)
                    : formatted("contact predicted %.1f s ago", std::abs(left));
}

std::string outcomeWords(const collision_forge::CollisionReport& tested) {
  if (!tested.contact) return "no contact";
  return tested.verified ? "contact as requested"
                         : "contact not as requested: " + shortcoming(tested);
}

std::string verdictWords(const collision_forge::CollisionReport& tested) {
  std::string words = outcomeWords(tested);
  if (tested.contact) words += formatted("\nimpact %.1f m/s", tested.impact_speed);
  return words + (tested.believable ? "\nplausible" : "\nnot plausible: it " + tested.unbelievable);
}

std::string crashWords(const collision_forge::Attack& attack,
                       const collision_forge::CollisionReport* verdict, const ros::Time& now) {
  if (verdict) return verdictWords(*verdict);
  const std::string countdown = countdownWords(attack, now);
  return attack.adaptive ? countdown + "\n" + attack.phase + ": " + attack.decision : countdown;
}

}  // namespace forge
