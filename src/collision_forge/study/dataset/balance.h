#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/study/dataset/options.h"

namespace forge {

/// Returns the sizes to keep of groups with the sizes `available`, in the same order, with the sum
/// `most`, or `available` if its sum is not above `most`. Reduces the largest groups first: all
/// reduced groups get the same size, but the first of them in the order of `available` one more, so
/// that the sum is reached.
std::vector<std::size_t> levelledCounts(const std::vector<std::size_t>& available,
                                        std::size_t most);

/// Returns the largest sizes to keep, reduced as by levelledCounts(), for which each non-empty
/// group has at least the share `min_share` (0..1) of the sum; `available` unchanged if `min_share`
/// is 0 or all groups are empty. Throws std::invalid_argument if `min_share` times the number of
/// non-empty groups is above 1.
std::vector<std::size_t> withMinShare(const std::vector<std::size_t>& available, double min_share);

/// Returns the largest sizes to keep, reduced to a common maximum, for which no group is larger
/// than `max_ratio` times the mean of the groups that are not empty in `available`. Throws
/// std::invalid_argument for a `max_ratio` below 1.
std::vector<std::size_t> withMaxRatio(const std::vector<std::size_t>& available, double max_ratio);

/// The properties over which a data set is balanced.
struct ClipKind {
  CollisionType type = CollisionType::kRearEnd;
  int length = 0;  ///< Attempt::length(): frame intervals (0.5 s) from begin to impact
};

/// Returns the indices into `clips` (ascending) of the clips to keep. Balances the lengths within
/// each type (max_tta_ratio), then the types (min_type_share); draws the clips of one type and
/// length at random by `seed`. Throws the exceptions of withMinShare() and withMaxRatio().
std::vector<std::size_t> chooseBalanced(const std::vector<ClipKind>& clips,
                                        const BalanceOptions& options, std::uint64_t seed);

}  // namespace forge
