#pragma once

#include <collision_forge/Attack.h>

#include <string>

/// A report and an attack as one line for people: "crash as asked, 3.99 s from now, ...".
/// Degrees, percent and seconds from the header's stamp.
namespace forge {

/// What verification found, a condition that is broken included.
std::string lineOf(const collision_forge::CollisionReport& report);

/// Who crashes into the ego how, with the words of lineOf().
std::string summaryOf(const collision_forge::Attack& attack);

}  // namespace forge
