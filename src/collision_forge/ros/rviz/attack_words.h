#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/PlannerOutcome.h>
#include <ros/time.h>

#include <QString>

#include <cstdint>
#include <string>

/// Rich texts of the panel about an attack, in degrees, percent and seconds from t0.
namespace forge {

/// Returns attacker, manoeuvre and verification result; empty for an empty attack.
QString attackText(const collision_forge::Attack& attack);

/// Returns countdown or verdict; empty for an empty attack. Green: as requested, else red.
QString crashText(const collision_forge::Attack& attack,
                  const collision_forge::CollisionReport* tested, const ros::Time& now);

/// Returns touched agent, impact speed and fault of a planner test, or that there was no contact.
QString outcomeText(const collision_forge::PlannerOutcome& outcome);

/// Returns the text for a status of GenerateCollision.srv other than OK.
QString failureText(std::uint8_t code, const std::string& message);

}  // namespace forge
