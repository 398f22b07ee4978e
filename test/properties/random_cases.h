#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>

#include "collision_forge/attack/forecast/random.h"

namespace forge {

/// The cases that a property is tried on. Each has a seed of its own, one more than the one before.
struct CaseRange {
  std::uint64_t count = 1000;
  std::uint64_t first_seed = 1;
};

/// PROPERTY_CASES and PROPERTY_SEED, where the environment has them. Throws std::invalid_argument
/// for what is no number.
CaseRange caseRange();

/// Tries a property on every case, up to the first that fails, whose seed is told. `share`: of the
/// cases, for what takes long; at least one.
void forAllCases(const std::function<void(Random&)>& check, double share = 1.0);

/// For a property that does not hold always, as rounding may turn a choice: `check` returns true in
/// at least this share of the cases. Tells the number of the others, and their seeds.
void forMostCases(double least_share, const std::function<bool(Random&)>& check);

/// The bytes of a file; none where it is not there.
std::string contentOf(const std::string& path);

inline bool isLikely(Random& random, double share) { return random.uniform(0.0, 1.0) < share; }

/// One of several.
template <typename Values>
auto oneOf(const Values& values, Random& random) {
  return *std::next(std::begin(values),
                    static_cast<std::ptrdiff_t>(random.index(std::size(values))));
}

}  // namespace forge
