#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>
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

/// A status of GenerateCollision.srv other than OK.
QString failureText(std::uint8_t code, const std::string& message);

}  // namespace forge
