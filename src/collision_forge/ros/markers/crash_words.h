#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>

#include <string>

/// Texts about an attack for people: the countdown before its contact, and the outcome.
namespace forge {

/// Returns the report if it belongs to the attack and its outcome is known by `now`, else null.
const collision_forge::CollisionReport* verdictBy(const ros::Time& now,
                                                  const collision_forge::Attack& attack,
                                                  const collision_forge::CollisionReport* tested);

/// Text for a contact that is not yet verified.
inline constexpr const char* kContactWords = "contact; verification follows";

/// "contact in 4.4 s" up to the predicted contact, then "contact predicted 0.2 s ago": where the
/// ego does not drive as predicted, the contact comes later or never.
std::string countdownWords(const collision_forge::Attack& attack, const ros::Time& now);

/// Returns the outcome: as requested, not as requested with the reason, or no contact.
std::string outcomeWords(const collision_forge::CollisionReport& tested);

/// Returns two or three lines: the outcome; the impact; plausible, or the reason if not.
std::string verdictWords(const collision_forge::CollisionReport& tested);

/// Returns the verdict if there is one, else the countdown, and an adaptive attacker's phase and
/// decision.
std::string crashWords(const collision_forge::Attack& attack,
                       const collision_forge::CollisionReport* verdict, const ros::Time& now);

}  // namespace forge
