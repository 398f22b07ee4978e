#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>

#include <string>

/// An attack in words, for people: before its contact, and what became of it.
namespace forge {

/// The report if it is of the attack and tells what has come true by `now`; else null.
const collision_forge::CollisionReport* verdictBy(const ros::Time& now,
                                                  const collision_forge::Attack& attack,
                                                  const collision_forge::CollisionReport* tested);

/// Of a contact that is not yet verified.
inline constexpr const char* kContactWords = "contact; verification follows";

/// "contact in 4.4 s" up to the predicted contact, then "contact predicted 0.2 s ago": where the
/// ego does not drive as predicted, the contact comes later or never.
std::string countdownWords(const collision_forge::Attack& attack, const ros::Time& now);

/// As asked, not as asked and why, or no contact.
std::string outcomeWords(const collision_forge::CollisionReport& tested);

/// The same as two or three lines: the outcome; how hard; believable or why not.
std::string verdictWords(const collision_forge::CollisionReport& tested);

/// The verdict where there is one, else the countdown, and of an attacker that sees and reacts what
/// it does.
std::string crashWords(const collision_forge::Attack& attack,
                       const collision_forge::CollisionReport* verdict, const ros::Time& now);

}  // namespace forge
