#pragma once

#include <random>
#include <string>
#include <vector>

namespace forge {

/// Returns one of `seeds` with a few changes: other bytes, lengths, numbers and words; parts that
/// are missing, doubled or from another seed. The same state of `random` gives the same mutant.
std::string mutantOf(const std::vector<std::string>& seeds, std::mt19937_64& random);

}  // namespace forge
