#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numeric>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/collide/collide_set.h"
#include "collision_forge/io/logs/city_maps.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/statistics/statistics.h"
#include "collision_forge/study/commands/clip_options.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/evaluation/clip_question.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

struct Arguments {
  std::string collide;
  std::string dataroot;
  std::string split = "val";
  std::vector<std::string> methods;
  Mode mode = Mode::kHistory;
  std::size_t limit = 0;
  ConfigFolder config;
};

/// CPU time per request of one method.
struct Measurement {
  std::string name;
  std::vector<double> milliseconds;
};

/// Returns the CPU time of all threads of this process, s.
double processorTime() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Measures one request. The very first call of a method is repeated and not measured, because it
/// may load data that later calls reuse.
void measureClip(const CollideClip& clip, const ClipQuestion& question,
                 const ClipEvaluationSetup& setup, Measurement& measurement) {
  const MethodMaker maker = clipMethod(measurement.name, clip, setup, false);
  if (question.check(maker).code != StatusCode::kOk) return;
  const std::unique_ptr<const AttackMethod> method = maker.make();
  if (measurement.milliseconds.empty()) question.ask(*method, 0);
  const double start = processorTime();
  question.ask(*method, 0);
  const double microseconds = std::round(1e6 * (processorTime() - start));
  measurement.milliseconds.push_back(1e-3 * microseconds);
}

void print(const std::vector<Measurement>& measurements) {
  std::printf("| method | clips | median ms | mean ms | 95 %% ms |\n|---|---|---|---|---|\n");
  for (const Measurement& measurement : measurements) {
    std::vector<double> times = measurement.milliseconds;
    if (times.empty()) {
      std::printf("| %s | 0 | - | - | - |\n", measurement.name.c_str());
      continue;
    }
    std::sort(times.begin(), times.end());
    const double mean =
        std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
    std::printf("| %s | %zu | %.3f | %.3f | %.3f |\n", measurement.name.c_str(), times.size(),
                quantile(times, 0.5), mean, quantile(times, 0.95));
  }
}

int measure(const Arguments& arguments) {
  const StudyConfig config = loadStudyConfig(arguments.config);
  std::vector<std::string> paths = listCollideClips(arguments.collide, arguments.split);
  if (arguments.limit > 0 && arguments.limit < paths.size()) paths.resize(arguments.limit);
  CityMaps maps(arguments.dataroot, config);
  const PredictionModels models = loadPredictionModels(config);
  const MethodRegistry methods = loadMethods(config);
  const ClipEvaluationSetup setup{methods, models, config};
  std::vector<Measurement> measurements;
  for (const std::string& method : arguments.methods) measurements.push_back({method, {}});
  ProgressLine progress("clips");
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const CollideClip clip = readCollideClip(paths[i], config.input_limits);
    const ClipQuestion question(clip, maps.at(clip.city), arguments.mode, config);
    for (Measurement& measurement : measurements) measureClip(clip, question, setup, measurement);
    progress.show(i + 1, paths.size());
  }
  print(measurements);
  return kExitOk;
}

}  // namespace

void addMeasureMethods(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMeasuring, "study measure methods",
                           "Measures the CPU time per request of each method on COLLIDE clips.",
                           [arguments] { return measure(*arguments); });
  CLI::Option* collide = addCollide(app, arguments->collide)->required();
  addDataroot(app, arguments->dataroot);
  app.add_option("--methods", arguments->methods,
                 "methods of forge study evaluate, separated by commas")
      ->delimiter(',')
      ->required();
  addSplit(app, arguments->split, collide);
  addMode(app, arguments->mode, false);
  addLimit(app, arguments->limit, collide);
  addConfig(app, arguments->config);
  app.parse_complete_callback(
      [arguments] { checkClipMethods(arguments->methods, arguments->config); });
}

}  // namespace forge
