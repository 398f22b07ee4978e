#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/PlannerOutcome.h>
#include <ros/time.h>

#include <QString>

#include <cstdint>
#include <string>

/// Rich texts (HTML of Qt) of the panel about an attack, in degrees, percent and seconds from t0.
/// An attack is empty if isNone().
namespace forge {

/// Returns type and attacker, and the contact that the attack's report predicts: time, manoeuvre,
/// plausibility, confidence, sides, impact; without a predicted contact a sentence that says so.
/// Returns "" for an empty attack.
QString attackText(const collision_forge::Attack& attack);

/// Returns crashWords() at `now` (scene clock): the verdict of `tested`, green if it is verified,
/// else red, from the time on at which verdictBy() returns it; before that, and if `tested` is null
/// or belongs to another attack, the countdown without a colour. Returns "" for an empty attack.
QString crashText(const collision_forge::Attack& attack,
                  const collision_forge::CollisionReport* tested, const ros::Time& now);

/// Returns planner, touched agent, time of the contact (s after t0), impact speed and fault of a
/// planner test; without a contact the failure of the planner, or that there was no contact in the
/// duration of the test.
QString outcomeText(const collision_forge::PlannerOutcome& outcome);

/// Returns the text for a status other than OK: the name of the code, its number, and `message`,
/// the reason. `code`: a constant of GenerateCollision.srv (StatusCode).
QString failureText(std::uint8_t code, const std::string& message);

}  // namespace forge
