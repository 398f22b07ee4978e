#pragma once

#include <collision_forge/Attack.h>

#include <string>

/// One-line texts for people, in degrees, percent and seconds from the header's stamp (t0).
namespace forge {

/// Returns the result of verification, as "crash as requested, 4.02 s after t0, ...", with the
/// violated conditions of limits, other agents and plausibility; "no contact" without a contact.
std::string lineOf(const collision_forge::CollisionReport& report);

/// Returns collision type, attacker (full id, added or recorded, class) and confidence of an
/// attack, followed by lineOf() its report. The attack must not be empty (isNone()).
std::string summaryOf(const collision_forge::Attack& attack);

}  // namespace forge
