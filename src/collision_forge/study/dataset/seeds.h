#pragma once

#include <cstdint>
#include <string>

namespace forge {

/// Returns a seed derived from a text and another seed (mixed 64-bit FNV-1a hash).
std::uint64_t seedOf(const std::string& text, std::uint64_t seed);

/// Returns a number in [0, 1) derived from `seed`, uniformly distributed over seeds.
double shareOf(std::uint64_t seed);

}  // namespace forge
