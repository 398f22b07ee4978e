#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/PlannerOutcome.h>
#include <ros/time.h>

#include <QString>

#include <cstdint>
#include <string>

/// Texts of the panel about an attack, as Qt rich text. Degrees, percent, seconds from t0.
namespace forge {

/// Returns type, attacker and predicted report of the attack; empty for the empty attack.
QString attackText(const collision_forge::Attack& attack);

/// Returns the countdown to the contact, or the measured result: green if verified, else red. Empty
/// for the empty attack. `tested` may be null; `now` is ROS time.
QString crashText(const collision_forge::Attack& attack,
                  const collision_forge::CollisionReport* tested, const ros::Time& now);

/// Returns the result of a planner test: contact with impact speed and fault, failure, or no
/// contact.
QString outcomeText(const collision_forge::PlannerOutcome& outcome);

/// Returns code and message of a status of GenerateCollision.srv or TestPlanner.srv other than OK.
QString failureText(std::uint8_t code, const std::string& message);

}  // namespace forge
