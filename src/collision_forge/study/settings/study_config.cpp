#include "collision_forge/study/settings/study_config.h"

#include "collision_forge/base/config/section.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

StudyConfig loadStudyConfig(const std::string& directory) {
  StudyConfig config;
  static_cast<Config&>(config) = loadConfig(directory);
  readConfigFile(directory, "speed_model_fit", config.speed_model_fit);
  readConfigFile(openConfigFile(directory, "training.yaml"), static_cast<LearningOptions&>(config));
  readConfigFile(directory, "planner_training", config.planner_training);
  const int history_frames = config.attack.prediction.history_frames;
  readConfigFile(openConfigFile(directory, "generators.yaml"), config.generators,
                 sectionsOfGenerators(), history_frames);
  readConfigFile(openConfigFile(directory, "network_published.yaml"), config.published_network,
                 sectionsOf("published_network"), history_frames);
  readConfigFile(directory, "evaluation", config.evaluation);
  readConfigFile(directory, "dataset", config.dataset, config.attack.search.time_margin);
  return config;
}

}  // namespace forge
