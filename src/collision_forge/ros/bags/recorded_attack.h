#pragma once

#include <collision_forge/CollisionReport.h>

#include <optional>
#include <string>

namespace forge {

/// The attack in a bag of `forge inject`.
struct RecordedAttack {
  collision_forge::CollisionReport tested_report;  ///< outcome against the recorded ego
  std::string source;                              ///< file name of the bag without the attack
};

/// Returns nullopt for a bag without an attack. Throws BagError.
std::optional<RecordedAttack> readRecordedAttack(const std::string& path);

/// Returns the error text for a second attack in the bag at `path`, with the bag to play instead.
std::string refusalOf(const RecordedAttack& attack, const std::string& path);

}  // namespace forge
