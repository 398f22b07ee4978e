#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>

#include <string>

/// Texts about an attack for people: countdown before the contact, outcome after it. Lines are
/// separated by '\n', without a line end after the last. `now`: time of the picture on the scene's
/// clock; `tested`: report on the actual outcome (topic tested_report).
namespace forge {

/// Returns `tested` if it belongs to `attack` (exactly equal stamp and attacker's id) and its
/// outcome is known at `now`: from the contact in `tested` on, or if it has none from the end of
/// the trajectory on. Otherwise, and if `tested` is null or the trajectory has no points, returns
/// null.
const collision_forge::CollisionReport* verdictBy(const ros::Time& now,
                                                  const collision_forge::Attack& attack,
                                                  const collision_forge::CollisionReport* tested);

/// Text for a contact that is not yet verified.
inline constexpr const char* kContactWords = "contact; verification follows";

/// Returns "contact in 4.4 s" before the contact that the attack's report predicts, later "contact
/// predicted 0.2 s ago": if the ego departs from the prediction, the contact comes later or never.
/// Times are rounded to 0.1 s; exactly at the contact the text is the second one. Returns "no
/// contact predicted" for a report without a contact.
std::string countdownWords(const collision_forge::Attack& attack, const ros::Time& now);

/// Returns "contact as requested" for a verified report, "contact not as requested: REASON" with
/// the first violated condition (type, time, limits, other agents), or "no contact".
std::string outcomeWords(const collision_forge::CollisionReport& tested);

/// Returns two or three lines: outcomeWords(); the impact speed, if there is a contact; plausible,
/// or the reason why not.
std::string verdictWords(const collision_forge::CollisionReport& tested);

/// Returns verdictWords() of `verdict` (result of verdictBy()) unless it is null, else
/// countdownWords(); only the latter is followed, for an adaptive attacker, by a line with its
/// phase and last decision.
std::string crashWords(const collision_forge::Attack& attack,
                       const collision_forge::CollisionReport* verdict, const ros::Time& now);

}  // namespace forge
