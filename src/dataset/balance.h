#pragma once

#include <cstdint>
#include <vector>

#include "formats/dataset_options.h"

namespace forge {

/// The most that can be taken of groups so that each has at least `min_share` of all: the largest
/// groups lose first, and all that are cut are of one size (to one). An empty group counts for
/// nothing. Throws std::invalid_argument where min_share times the number of groups that are not
/// empty is above 1.
std::vector<std::size_t> balancedCounts(const std::vector<std::size_t>& available,
                                        double min_share);

/// At most `most` of the groups, cut in the same way.
std::vector<std::size_t> levelledCounts(const std::vector<std::size_t>& available,
                                        std::size_t most);

/// What a clip is balanced by.
struct ClipKind {
  CollisionType type = CollisionType::kRearEnd;
  int length = 0;  ///< frames from begin to impact
};

/// Places of the clips that are kept, rising: first each type is balanced over its lengths, then
/// all over the types; clips of a kind are drawn by the seed. Throws as balancedCounts().
std::vector<std::size_t> chooseBalanced(const std::vector<ClipKind>& clips,
                                        const BalanceOptions& options, std::uint64_t seed);

}  // namespace forge
