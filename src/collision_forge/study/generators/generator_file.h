#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/weights/traffic_generators.h"
#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

/// The metadata of a weight file.
struct GeneratorHeader {
  std::string name;  ///< model, one of trafficModelNames()
  /// YAML text of the sections sectionsOf(name), with which the model was made.
  std::string config;
  int history_frames = 0;                    ///< frames of history at 2 Hz, t0 included
  int epochs = 0;                            ///< number of epochs trained
  std::vector<std::string> left_out_scenes;  ///< names of the scenes left out in the training
};

/// Parses the options of a header. Throws ConfigError naming `path`.
GeneratorOptions optionsOf(const GeneratorHeader& header, const std::string& path);

/// Returns the content of a weight file (.pt, a torch archive): the key "format", the fields of the
/// header under their names, "weights" with the tensors of `model` by parameter name, and if
/// `training` is true "training", the state to resume the training.
std::string generatorBytes(const GeneratorHeader& header, const TrafficModel& model, bool training);

/// Reads the header of a weight file. Throws TrafficGeneratorError, naming the file, if it is
/// missing, damaged, or of another format or model than `name`.
GeneratorHeader readGeneratorHeader(const std::string& path, const std::string& name);
/// Loads the weights of the file `path`, and with `training` the training state, into a model that
/// was made with the options of the file's header. Throws as readGeneratorHeader(), and for weights
/// with other shapes or values that are not finite.
void readGenerator(const std::string& path, TrafficModel& model, bool training);

}  // namespace forge
