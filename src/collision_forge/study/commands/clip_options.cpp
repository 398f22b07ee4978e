#include "collision_forge/study/commands/clip_options.h"

#include <stdexcept>

#include "collision_forge/app/options.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/study/evaluation/clip_methods.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {

void addDataroot(CLI::App& app, std::string& dataroot) {
  app.add_option("--source,--dataroot", dataroot, "nuScenes root, used for maps/expansion")
      ->required()
      ->check(CLI::ExistingDirectory);
}

CLI::Option* addCollide(CLI::App& app, std::string& collide) {
  return app.add_option("--collide", collide, "folder of COLLIDE clips, contains trajectory/SPLIT")
      ->check(CLI::ExistingDirectory);
}

CLI::Option* addSplit(CLI::App& app, std::string& split, CLI::Option* collide) {
  return app.add_option("--split", split, "split of the clips of --collide")
      ->transform(oneOf({"train", "val", "test"}))
      ->capture_default_str()
      ->needs(collide);
}

void addLimit(CLI::App& app, std::size_t& limit, CLI::Option* collide) {
  app.add_option("--limit", limit, "use only the first N clips of --collide; 0: all")
      ->capture_default_str()
      ->needs(collide);
}

void checkClipMethods(const std::vector<std::string>& methods, const ConfigFolder& config) {
  try {
    const StudyConfig read = loadStudyConfig(config);
    const MethodRegistry known = clipMethods(loadMethods(read), nullptr, read.evaluation);
    for (const std::string& method : methods) known.at(method);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--methods", error.what());
  } catch (const std::runtime_error&) {
    return;  // the run loads the configuration again and reports its errors
  }
}

}  // namespace forge
