#include <iostream>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/forecast/speed_profile_collection.h"
#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/weights/speed_profiles_file.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/study/commands/study_commands.h"

namespace forge {
namespace {

struct Arguments {
  LogSource logs;
  std::string out;
  std::string config;
};

int collect(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const OutputLock lock = OutputLock::ofFile(arguments.out);
  SceneSource scenes(arguments.logs, {}, config, 1, {}, showReading());
  const std::vector<std::string> names = scenes.names();
  std::vector<SpeedProfileRow> rows;
  ProgressLine progress("scenes");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto indexed = scenes.at(names[i]);
    const auto collected =
        collectSpeedProfiles(indexed->scene, *indexed->lanes, config.attack.ego_futures.paths);
    rows.insert(rows.end(), collected.begin(), collected.end());
    progress.show(i + 1, names.size());
  }
  writeSpeedProfiles(rows, arguments.out);
  std::cout << counted(rows.size(), "row") << " of " << counted(names.size(), "scene") << "\n";
  return kExitOk;
}

}  // namespace

void addSpeedsCollect(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app =
      line.add(kTraining, "study speeds collect", "Collects how the egos of recorded scenes drove.",
               [arguments] { return collect(*arguments); });
  addSource(app, arguments->logs)->required();
  addOut(app, arguments->out, "CSV to write, a row a frame");
  addConfig(app, arguments->config);
}

}  // namespace forge
