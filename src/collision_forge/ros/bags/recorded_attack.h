#pragma once

#include <collision_forge/CollisionReport.h>

#include <optional>
#include <string>

namespace forge {

/// The attack in a bag of `forge inject`.
struct RecordedAttack {
  collision_forge::CollisionReport tested_report;  ///< outcome against the recorded ego
  std::string source;  ///< file name of the bag without the attack; empty if unknown
};

/// Returns the attack in the bag at `path` (the first tested_report and attack_request); nullopt
/// for a bag without a tested_report of this version (no attack). Throws BagError if the bag cannot
/// be read.
std::optional<RecordedAttack> readRecordedAttack(const std::string& path);

/// Returns the error text for a request for another attack in the bag at `path`, which already has
/// `attack`; it names the bag to replay instead.
std::string refusalOf(const RecordedAttack& attack, const std::string& path);

}  // namespace forge
