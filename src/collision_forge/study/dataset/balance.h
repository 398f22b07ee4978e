#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/study/dataset/options.h"

namespace forge {

/// At most `most` of the groups together: the largest groups lose first, and all that are cut are
/// of one size (to one).
std::vector<std::size_t> levelledCounts(const std::vector<std::size_t>& available,
                                        std::size_t most);

/// The most that can be taken so that each group has at least `min_share` of all, cut in the same
/// way. An empty group counts for nothing. Throws std::invalid_argument where min_share times the
/// number of groups that are not empty is above 1.
std::vector<std::size_t> withMinShare(const std::vector<std::size_t>& available, double min_share);

/// The most that can be taken so that no group has more than `max_ratio` (1 or more) times the mean
/// of those that are not empty, cut in the same way. Throws std::invalid_argument for a ratio below
/// 1.
std::vector<std::size_t> withMaxRatio(const std::vector<std::size_t>& available, double max_ratio);

/// What a clip is balanced by.
struct ClipKind {
  CollisionType type = CollisionType::kRearEnd;
  int length = 0;  ///< frames from begin to impact
};

/// Places of the clips that are kept, rising: first each type is balanced over its lengths, then
/// all over the types; clips of a kind are drawn by the seed. Throws as withMinShare() and
/// withMaxRatio().
std::vector<std::size_t> chooseBalanced(const std::vector<ClipKind>& clips,
                                        const BalanceOptions& options, std::uint64_t seed);

}  // namespace forge
