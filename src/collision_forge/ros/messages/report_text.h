#pragma once

#include <collision_forge/Attack.h>

#include <string>

/// One-line texts for people, in degrees, percent and seconds from the header's stamp (t0).
namespace forge {

/// Returns the result of verification without a line end; "no contact" without a contact.
/// The line of a contact has, separated by commas: "crash as requested" (`report.verified`) or
/// "contact, not as requested", "4.02 s after t0", relative heading, touched sides, impact speed,
/// overlap, ego's delta-v, injury (if known), "limits kept" or the violated limit, another agent
/// touched first (if any), share off road, manoeuvre and its begin, "plausible" or the reason why
/// not, since when the attacker is seen, and the careful drivers who avoid the crash (if any were
/// simulated). A contact not as requested has the same facts.
std::string lineOf(const collision_forge::CollisionReport& report);

/// Returns collision type, attacker (full id, added or recorded, class) and confidence of an
/// attack, followed by lineOf() its report. The attack must not be empty (isNone()).
std::string summaryOf(const collision_forge::Attack& attack);

}  // namespace forge
