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

/// Returns nullopt for a bag without an attack, that is, without a message on /tested_report.
/// Throws BagError.
std::optional<RecordedAttack> readRecordedAttack(const std::string& path);

/// Returns the message that rejects a second attack in the bag at `path`; it names the bag to
/// replay instead.
std::string refusalOf(const RecordedAttack& attack, const std::string& path);

}  // namespace forge
