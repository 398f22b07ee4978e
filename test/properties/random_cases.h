#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>

#include "collision_forge/attack/forecast/random.h"

namespace forge {

/// The cases in which a property is checked. Their seeds are consecutive.
struct CaseRange {
  std::uint64_t count = 1000;
  std::uint64_t first_seed = 1;
};

/// Returns the range by the environment variables PROPERTY_CASES and PROPERTY_SEED, if set. Throws
/// std::invalid_argument for a value that is not a number.
CaseRange caseRange();

/// Checks a property in every case, up to the first failure, and prints the seed of that. `share`
/// of the cases is used, at least one: for slow properties.
void forAllCases(const std::function<void(Random&)>& check, double share = 1.0);

/// Expects that `check` returns true in at least this share of the cases: for properties that
/// rounding can violate. Prints number and seeds of the others.
void forMostCases(double least_share, const std::function<bool(Random&)>& check);

/// Returns the bytes of a file; "" if it does not exist.
std::string contentOf(const std::string& path);

inline bool isLikely(Random& random, double share) { return random.uniform(0.0, 1.0) < share; }

/// Returns a random element.
template <typename Values>
auto oneOf(const Values& values, Random& random) {
  return *std::next(std::begin(values),
                    static_cast<std::ptrdiff_t>(random.index(std::size(values))));
}

}  // namespace forge
