#pragma once

#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace forge {

/// Puts values in random order. The standard's own shuffle differs between libraries.
template <class Value>
void shuffle(std::vector<Value>& values, std::mt19937_64& generator) {
  for (std::size_t left = values.size(); left > 1; --left) {
    std::swap(values[left - 1], values[generator() % left]);
  }
}

/// For each scene the half that it falls into, 0 or 1.
using SceneHalves = std::map<std::string, int>;

/// Deals scenes (each counts once) at random into halves that differ by one at most. The same
/// scenes in another order and a generator in the same state give the same halves.
SceneHalves drawSceneHalves(std::vector<std::string> scenes, std::mt19937_64& generator);

}  // namespace forge
