#include "collision_forge/dataset/seeds.h"

namespace forge {

std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

std::uint64_t seedOf(const std::string& text, std::uint64_t seed) {
  std::uint64_t hash = 0xcbf29ce484222325u ^ mixed(seed);
  for (const char character : text) {
    hash = (hash ^ static_cast<unsigned char>(character)) * 0x100000001b3u;
  }
  return mixed(hash);
}

double shareOf(std::uint64_t seed) { return static_cast<double>(mixed(seed) >> 11) * 0x1p-53; }

}  // namespace forge
