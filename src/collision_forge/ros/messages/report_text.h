#pragma once

#include <collision_forge/Attack.h>

#include <string>

/// A report and an attack as one line for people: "crash as asked, 3.99 s from now, ...".
/// Degrees, percent and seconds from the header's stamp.
namespace forge {

/// Returns the result of the verification, with violated conditions.
std::string lineOf(const collision_forge::CollisionReport& report);

/// Returns type, attacker and confidence of the attack, then lineOf() its report.
std::string summaryOf(const collision_forge::Attack& attack);

}  // namespace forge
