#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>

#include <string>

/// Texts about an attack for people: countdown before the contact, outcome after it.
namespace forge {

/// Returns `tested` if it belongs to `attack` and its outcome is known at `now`, else null.
const collision_forge::CollisionReport* verdictBy(const ros::Time& now,
                                                  const collision_forge::Attack& attack,
                                                  const collision_forge::CollisionReport* tested);

/// Text for a contact that is not yet verified.
inline constexpr const char* kContactWords = "contact; verification follows";

/// Returns "contact in 4.4 s" before the predicted contact, later "contact predicted 0.2 s ago": if
/// the ego departs from the prediction, the contact comes later or never.
std::string countdownWords(const collision_forge::Attack& attack, const ros::Time& now);

/// Returns whether the contact is as requested, and otherwise why not, or that there is none.
std::string outcomeWords(const collision_forge::CollisionReport& tested);

/// Returns two or three lines: outcome; impact; plausible or the reason why not.
std::string verdictWords(const collision_forge::CollisionReport& tested);

/// Returns the verdict if `verdict` is set, else the countdown, for an adaptive attacker with its
/// phase.
std::string crashWords(const collision_forge::Attack& attack,
                       const collision_forge::CollisionReport* verdict, const ros::Time& now);

}  // namespace forge
