#include "collision_forge/study/scene_halves.h"

#include <algorithm>

namespace forge {

SceneHalves drawSceneHalves(std::vector<std::string> scenes, std::mt19937_64& generator) {
  std::sort(scenes.begin(), scenes.end());
  scenes.erase(std::unique(scenes.begin(), scenes.end()), scenes.end());
  shuffle(scenes, generator);
  // Of an odd number the greater half is either.
  const std::size_t first = generator() % 2;
  SceneHalves halves;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    halves[scenes[i]] = static_cast<int>((i + first) % 2);
  }
  return halves;
}

}  // namespace forge
