#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/weights/traffic_generators.h"
#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

/// Which model a file holds, and what it was made with.
struct GeneratorHeader {
  std::string name;
  std::string config;  ///< text with the mappings of sectionsOf()
  int history_frames = 0;
  int epochs = 0;                            ///< that it was trained
  std::vector<std::string> left_out_scenes;  ///< that it was not trained on
};

/// Options of a header; throws ConfigError naming `path`.
GeneratorOptions optionsOf(const GeneratorHeader& header, const std::string& path);

/// The bytes of a file with the weights of a model, and with `training` all that going on takes.
std::string generatorBytes(const GeneratorHeader& header, const TrafficModel& model, bool training);

/// Throws TrafficGeneratorError, naming the file, for one that is absent, damaged, of another
/// format or generator than `name`, and for weights of another shape or that are not finite.
GeneratorHeader readGeneratorHeader(const std::string& path, const std::string& name);
/// The same of what fills a model that was made with that header's options.
void readGenerator(const std::string& path, TrafficModel& model, bool training);

}  // namespace forge
