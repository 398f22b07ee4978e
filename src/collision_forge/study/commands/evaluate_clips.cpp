#include <cmath>
#include <filesystem>
#include <iostream>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/file_fingerprint.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/io/collide/collide_set.h"
#include "collision_forge/io/logs/city_maps.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"
#include "collision_forge/study/commands/evaluation.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/commands/study_run_config.h"
#include "collision_forge/study/evaluation/clip_methods.h"
#include "collision_forge/study/evaluation/row_rates.h"

namespace forge {
namespace {

std::vector<std::string> listClips(const EvaluationArguments& arguments,
                                   const StudyConfig& config) {
  std::vector<std::string> paths =
      arguments.by_scene ? listCollideClipsByScene(arguments.collide, arguments.split,
                                                   config.evaluation.collide.held_out_share)
                         : listCollideClips(arguments.collide, arguments.split);
  if (arguments.limit > 0 && arguments.limit < paths.size()) paths.resize(arguments.limit);
  return paths;
}

ResumableFile::Options runOptions(const EvaluationArguments& arguments, const StudyConfig& config,
                                  const std::vector<std::string>& paths) {
  ResumableFile::Options options = studyInputsOf(config, arguments.logs);
  options["collide"] = std::filesystem::canonical(arguments.collide).string();
  options["clips"] = fingerprintOfFiles(paths);
  options["split"] = arguments.split;
  options["by-scene"] = arguments.by_scene ? "yes" : "no";
  options["seen-scenes"] = arguments.plan.seen_scenes ? "yes" : "no";
  options["protocol"] = toString(arguments.plan.protocol);
  options["limits"] = toString(LimitSet::kStrict);
  options["method"] = arguments.plan.method;
  options["mode"] = toString(arguments.plan.mode);
  options["seeds"] = std::to_string(arguments.plan.seeds);
  options["limit"] = std::to_string(arguments.limit);
  return options;
}

std::vector<std::string> namesOf(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    names.push_back(std::filesystem::path(path).stem().string());
  }
  return names;
}

/// Returns the title of the tables: data set, protocol, limits, mode and number of clips.
std::string headline(const EvaluationArguments& arguments, std::size_t clips) {
  return "COLLIDE " + arguments.split + (arguments.by_scene ? " by scene" : "") + ", " +
         toString(arguments.plan.protocol) + " protocol, " +
         (arguments.plan.protocol == Protocol::kStrict
              ? std::string(toString(LimitSet::kStrict)) + " limits, "
              : "") +
         toString(arguments.plan.mode) + " mode, " + std::to_string(clips) + " clips";
}

}  // namespace

int evaluateClips(const EvaluationArguments& arguments) {
  const StudyConfig config = loadStudyConfig(arguments.config);
  const std::vector<std::string> paths = listClips(arguments, config);
  const OutputLocks locks = lockFolders({arguments.out});
  CityMaps maps(arguments.logs.path, config);
  const PredictionModels models = loadPredictionModels(config);
  const MethodRegistry methods = loadMethods(config);
  const MethodMaker checked(arguments.plan.method, clipMethods(methods, nullptr, config.evaluation),
                            config.attack, models);
  const auto rows_of = [&](std::size_t index) {
    const CollideClip clip = readCollideClip(paths[index], config.input_limits);
    const auto lanes = maps.at(clip.city);
    return evaluateClip(clip, lanes, {methods, models, config}, arguments.plan);
  };
  const std::vector<ResultRow> rows = runEvaluation(
      {arguments.out, runOptions(arguments, config, paths), arguments.plan.protocol, RowsOf::kClips,
       "clips", namesOf(paths), rowsPerClip(arguments.plan), arguments.jobs, rows_of});
  const std::string title = headline(arguments, paths.size());
  std::string text = reportTitle(title);
  const std::vector<RateTable> tables =
      tabulate(rows, arguments.plan.protocol, methodsOf(arguments.plan));
  for (const RateTable& table : tables) text += "\n" + toMarkdown(table);
  writeText(arguments.out + "/table.md", text);
  writeRates(tables, arguments.out);
  std::cout << text;
  return kExitOk;
}

}  // namespace forge
