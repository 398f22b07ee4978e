#pragma once

#include <cstdint>
#include <string>

namespace forge {

/// A seed that follows from a text and another seed: the mixed FNV-1a hash of 64 bits.
std::uint64_t seedOf(const std::string& text, std::uint64_t seed);

/// A number in [0, 1) that follows from a seed.
double shareOf(std::uint64_t seed);

}  // namespace forge
