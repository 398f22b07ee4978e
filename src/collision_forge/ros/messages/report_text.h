#pragma once

#include <collision_forge/Attack.h>

#include <string>

/// One-line texts for people, in degrees, percent and seconds from the header's stamp (t0).
namespace forge {

/// Returns the result of verification, including a violated condition.
std::string lineOf(const collision_forge::CollisionReport& report);

/// Returns attacker and manoeuvre, followed by lineOf() the report.
std::string summaryOf(const collision_forge::Attack& attack);

}  // namespace forge
