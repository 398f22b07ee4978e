#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/PlannerOutcome.h>
#include <ros/time.h>

#include <QString>

#include <cstdint>
#include <string>

/// An attack in the panel's rich text. Degrees, percent, seconds from now.
namespace forge {

/// Who attacks how, and what verification found; empty for an attack by nobody.
QString attackText(const collision_forge::Attack& attack);

/// Countdown or verdict; empty for an attack by nobody. Green as asked, red otherwise.
QString crashText(const collision_forge::Attack& attack,
                  const collision_forge::CollisionReport* tested, const ros::Time& now);

/// Whom a planner's ego touched, how hard and by whose fault, or that it touched nobody.
QString outcomeText(const collision_forge::PlannerOutcome& outcome);

/// A status of GenerateCollision.srv other than OK.
QString failureText(std::uint8_t code, const std::string& message);

}  // namespace forge
