#include "collision_forge/attack/search/speed_variation.h"

#include <cmath>

#include "collision_forge/attack/forecast/random.h"

namespace forge {

double SpeedVariation::frequency() const { return 2.0 * M_PI / period; }

double SpeedVariation::distanceGained(double time) const {
  const double rate = frequency();
  const double turned = rate * time + phase;
  return amplitude / rate * (std::cos(phase) * time - (std::sin(turned) - std::sin(phase)) / rate);
}

SpeedVariation variationOf(const std::string& id, std::uint64_t seed) {
  // FNV-1a: std::hash differs between libraries.
  std::uint64_t hash = 0xcbf29ce484222325U ^ seed;
  for (const char letter : id) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
  Random random(hash);
  SpeedVariation variation;
  variation.amplitude = random.uniform(0.0, kMaxVariation);
  variation.period = random.uniform(kShortestPeriod, kLongestPeriod);
  variation.phase = random.uniform(-M_PI, M_PI);
  return variation;
}

}  // namespace forge
