#include "collision_forge/study/dataset/seeds.h"

#include "collision_forge/base/files/fingerprint.h"

namespace forge {

std::uint64_t seedOf(const std::string& text, std::uint64_t seed) {
  return mixed(hashOf(text, kHashBasis ^ mixed(seed)));
}

double shareOf(std::uint64_t seed) { return static_cast<double>(mixed(seed) >> 11) * 0x1p-53; }

}  // namespace forge
