#include "collision_forge/study/settings/study_config.h"

#include "collision_forge/base/config/config_file.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"

namespace forge {
namespace {

Section openStudyFile(const ConfigFolder& folder, const std::string& name) {
  return openConfigFile(folder, "study/" + name + ".yaml");
}

/// Reads the only mapping of the file study/KEY.yaml by its readOptions().
template <class Options, class... More>
void readStudyFile(const ConfigFolder& folder, const std::string& key, Options& options,
                   const More&... more) {
  Section file = openStudyFile(folder, key);
  file.read(key, options, more...);
  file.finish();
}

}  // namespace

StudyConfig loadStudyConfig(const ConfigFolder& folder) {
  StudyConfig config;
  static_cast<Config&>(config) = loadConfig(folder);
  readStudyFile(folder, "speed_model_fit", config.speed_model_fit);
  readConfigFile(openStudyFile(folder, "training"), static_cast<LearningOptions&>(config));
  const int history_frames = config.attack.prediction.history_frames;
  readConfigFile(openStudyFile(folder, "generators"), config.generators, sectionsOfGenerators(),
                 history_frames);
  readConfigFile(openStudyFile(folder, "network_published"), config.published_network,
                 sectionsOf("published_network"), history_frames);
  readStudyFile(folder, "dataset", config.dataset, config.attack.search.time_margin);
  return config;
}

std::map<std::string, std::string> studyFingerprints(const ConfigFolder& folder) {
  return {{"config/study/dataset.yaml", fingerprintOfValues(folder, "study/dataset.yaml")}};
}

}  // namespace forge
