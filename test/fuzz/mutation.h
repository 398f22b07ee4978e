#pragma once

#include <random>
#include <string>
#include <vector>

namespace forge {

/// One of `seeds`, changed in a few places: bytes, lengths, numbers and words are others, parts are
/// left out, doubled or those of another seed. The same state of `random` gives the same mutant.
std::string mutantOf(const std::vector<std::string>& seeds, std::mt19937_64& random);

}  // namespace forge
