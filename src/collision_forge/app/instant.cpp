#include "collision_forge/app/instant.h"

#include <stdexcept>

#include "collision_forge/app/options.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/ros/bags/bag_reader.h"

namespace forge {

double frameTimeOf(const Scene& scene, double now) {
  const double start = scene.frame_times.front();
  const auto frame = lastFrameTime(scene, start + now);
  if (!frame || !(start + now <= scene.frame_times.back())) {
    throw std::invalid_argument("--now " + numberText(now) + " is outside the recording: 0 to " +
                                numberText(scene.frame_times.back() - start) + " s");
  }
  return *frame;
}

IndexedScene readRecording(const std::string& bag, const Config& config) {
  std::vector<std::string> warnings;
  IndexedScene recording{readBag(bag, config, &warnings), nullptr};
  printWarnings(bag, warnings);
  recording.lanes = std::make_shared<const LaneIndex>(recording.scene.map);
  return recording;
}

}  // namespace forge
