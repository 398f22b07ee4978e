#include "collision_forge/base/files/fingerprint.h"

#include <cstdio>

namespace forge {

std::uint64_t hashOf(std::string_view text, std::uint64_t before) {
  std::uint64_t hash = before;
  for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  return hash;
}

std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

std::string fingerprint(const std::string& text, const std::string& before) {
  const std::uint64_t hash =
      hashOf(text, before.empty() ? kHashBasis : std::stoull(before, nullptr, 16));
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

}  // namespace forge
