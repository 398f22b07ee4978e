#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/evaluation.h"
#include "collision_forge/app/options.h"
#include "collision_forge/batch/dispatch.h"
#include "collision_forge/data/city_maps.h"
#include "collision_forge/data/collide_clip.h"
#include "collision_forge/data/collide_set.h"
#include "collision_forge/data/pattern_network_file.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/settings/config_fingerprint.h"
#include "collision_forge/study/clip_methods.h"

namespace forge {
namespace {

std::vector<std::string> listClips(const EvaluationArguments& arguments, const Config& config) {
  std::vector<std::string> paths =
      arguments.by_scene ? listCollideClipsByScene(arguments.collide, arguments.split,
                                                   config.evaluation.collide.held_out_share)
                         : listCollideClips(arguments.collide, arguments.split);
  if (arguments.limit > 0 && arguments.limit < paths.size()) paths.resize(arguments.limit);
  return paths;
}

std::vector<std::string> describe(const EvaluationArguments& arguments, const Config& config) {
  std::vector<std::string> lines;
  for (const auto& [name, print] : fingerprintsOf(config, arguments.config)) {
    lines.push_back(name + " = " + print);
  }
  const auto add = [&lines](const char* key, const auto& value) {
    std::ostringstream line;
    line << key << " = " << value;
    lines.push_back(line.str());
  };
  add("collide", arguments.collide);
  add("dataroot", arguments.dataroot);
  add("split", arguments.split);
  add("by-scene", arguments.by_scene ? "yes" : "no");
  add("seen-scenes", arguments.plan.seen_scenes ? "yes" : "no");
  add("protocol", toString(arguments.plan.protocol));
  add("method", arguments.plan.method);
  add("mode", toString(arguments.plan.mode));
  add("seeds", arguments.plan.seeds);
  add("limit", arguments.limit);
  return lines;
}

ResultFile::Run describeRun(const EvaluationArguments& arguments, const Config& config,
                            const std::vector<std::string>& paths) {
  ResultFile::Run run{
      arguments.plan.protocol, {}, rowsPerClip(arguments.plan), describe(arguments, config)};
  for (const std::string& path : paths) {
    run.items.push_back(std::filesystem::path(path).stem().string());
  }
  return run;
}

/// What is measured, on one line.
std::string headline(const EvaluationArguments& arguments, std::size_t clips) {
  return "COLLIDE " + arguments.split + (arguments.by_scene ? " by scene" : "") + ", " +
         toString(arguments.plan.protocol) + " protocol, " + toString(arguments.plan.mode) +
         " mode, " + std::to_string(clips) + " clips";
}

}  // namespace

int evaluateClips(const EvaluationArguments& arguments) {
  const bool is_master = isMaster();
  const Config config = loadConfig(arguments.config);
  const std::vector<std::string> paths = listClips(arguments, config);
  CityMaps maps(arguments.dataroot, config);
  const Foresight foresight = loadForesight(config);
  const MethodRegistry methods = loadMethods(config);
  const MethodMaker checked(arguments.plan.method, clipMethods(methods, nullptr, config.evaluation),
                            config.attack, foresight);
  const auto work = [&](std::size_t index) {
    const CollideClip clip = readCollideClip(paths[index]);
    const auto lanes = maps.at(clip.city);
    return rowBytes(evaluateClip(clip, lanes, {methods, foresight, config}, arguments.plan));
  };
  const std::vector<ResultRow> rows =
      runEvaluation(arguments.out, describeRun(arguments, config, paths), arguments.jobs, work);
  if (!is_master) return kExitOk;
  const StatisticsOptions& statistics = config.evaluation.statistics;
  const std::string title = headline(arguments, paths.size());
  std::string text = reportTitle(title, statistics);
  for (const RateTable& table :
       tabulate(rows, arguments.plan.protocol, methodsOf(arguments.plan), statistics)) {
    text += "\n" + toMarkdown(table);
    if (table.measure.is_headline) drawTable(table, title, arguments.out, config.drawing);
  }
  writeText(arguments.out + "/table.md", text);
  std::cout << text;
  return kExitOk;
}

}  // namespace forge
