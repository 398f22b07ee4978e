#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/instant.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/planner_test_run.h"
#include "collision_forge/app/scenario_run.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/planner_test/sweeps/draw_sweep_map.h"
#include "collision_forge/planner_test/sweeps/sweep_cells.h"
#include "collision_forge/planner_test/sweeps/sweep_map.h"
#include "collision_forge/planner_test/sweeps/sweep_parameters.h"
#include "collision_forge/ros/bags/log_sources.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

struct Arguments : PlannerTestArguments {
  std::string bag;
  std::string scene;
  std::optional<double> now;
  std::string type;
  std::optional<double> tta;
  RequestControls controls;
  std::string method;
  Mode mode = Mode::kReplay;
  std::uint64_t seed = 0;
  std::vector<std::string> vary;
  std::size_t samples = 0;  ///< of a Latin hypercube; 0: a grid
  std::vector<std::string> map;
  std::vector<SweepAxis> axes;  ///< the parsed `vary`

  bool varies(const std::string& name) const {
    return std::any_of(axes.begin(), axes.end(),
                       [&](const SweepAxis& axis) { return axis.parameter->name == name; });
  }
  std::string fileIn(const std::string& name) const { return (fs::path(out) / name).string(); }
};

/// Parses --vary and checks the options that depend on it. Throws CLI::ValidationError.
void parseAxes(Arguments& arguments) {
  const auto refuse = [](const std::string& option, const std::string& problem) {
    throw CLI::ValidationError(option, problem);
  };
  try {
    for (const std::string& text : arguments.vary) {
      const SweepAxis axis = parseSweepAxis(text, arguments.samples > 0);
      if (arguments.varies(axis.parameter->name)) refuse("--vary", text + ": is varied twice");
      arguments.axes.push_back(axis);
    }
    if (arguments.samples == 0) gridOf(arguments.axes);
  } catch (const std::invalid_argument& error) {
    refuse("--vary", error.what());
  }
  const auto require = [&](const std::string& name, bool is_given) {
    if (is_given == arguments.varies(name)) {
      refuse("--" + name, is_given ? "is varied by --vary, too"
                                   : "is required unless --vary " + name + "=... is given");
    }
  };
  require("now", arguments.now.has_value());
  require("type", !arguments.type.empty());
  require("tta", arguments.tta.has_value());
  for (const std::string& name : arguments.map) {
    if (!arguments.varies(name)) refuse("--map", "\"" + name + "\" is not varied by --vary");
  }
  if (arguments.map.size() > 2 ||
      (arguments.map.size() == 2 && arguments.map[0] == arguments.map[1])) {
    refuse("--map", "takes one or two different parameters");
  }
}

SweepLayout layoutOf(const Arguments& arguments) {
  SweepLayout layout;
  layout.is_grid = arguments.samples == 0;
  for (const SweepAxis& axis : arguments.axes) layout.parameters.push_back(axis.parameter->name);
  const std::vector<std::string>& map = arguments.map.empty() ? layout.parameters : arguments.map;
  layout.x = map.front();
  if (map.size() > 1) layout.y = map[1];
  return layout;
}

/// The values of all cells and their requests, in the same order.
struct Design {
  std::vector<std::vector<double>> values;
  std::vector<SceneRequest> requests;
};

Design designOf(const Arguments& arguments, const Scene& scene, const Config& config) {
  SceneRequest base{scene.name, arguments.now.value_or(0.0), {}};
  base.request.crash = config.crash;
  base.request.mode = arguments.mode;
  base.request.seed = arguments.seed;
  base.request.tta = arguments.tta.value_or(base.request.tta);
  if (!arguments.type.empty()) base.request.type = *collisionTypeFromString(arguments.type);
  arguments.controls.applyTo(base.request);
  Design design;
  design.values = arguments.samples > 0
                      ? latinHypercubeOf(arguments.axes, arguments.samples, arguments.seed)
                      : gridOf(arguments.axes);
  for (const std::vector<double>& values : design.values) {
    SceneRequest asked = base;
    for (std::size_t i = 0; i < values.size(); ++i) {
      arguments.axes[i].parameter->set(asked, values[i], config.planners.sweep);
    }
    asked.now = frameTimeOf(scene, asked.now);
    design.requests.push_back(asked);
  }
  return design;
}

/// Solves the requests and tests the planners in the attacks.
std::vector<PlannerTestResult> test(const Arguments& arguments, const PlannerTestRun& run,
                                    const Design& design, SceneSource& scenes) {
  const std::string path = arguments.fileIn("scenarios.jsonl");
  writeScenarios({path, path, design.requests, arguments.method, arguments.mode, arguments.jobs},
                 arguments.logs, scenes, run.config(), [](const Scenario&) {});
  return run.run(*openScenarioCases({path}, arguments.logs, 1, run.config()), {}, true);
}

/// Returns a table with a line for each planner and careful driver.
std::string verdictTable(const std::vector<SweepCell>& cells, const SweepMap& map) {
  std::string text =
      "planner or driver                      hit  avoided  hit other  failed  changes\n";
  for (const MapPanel& panel : map.panels) {
    std::map<SweepVerdict, int> counts;
    for (const SweepCell& cell : cells) {
      for (const SweepOutcome& outcome : outcomesOf(cell)) {
        if (outcome.name == panel.name) ++counts[outcome.verdict];
      }
    }
    text +=
        formatted("%-36s %5d %8d %10d %7d %8zu\n", panel.name.c_str(), counts[SweepVerdict::kHit],
                  counts[SweepVerdict::kAvoided], counts[SweepVerdict::kHitOther],
                  counts[SweepVerdict::kFailed], panel.boundaries.size());
  }
  return text;
}

void writeFiles(const Arguments& arguments, const SweepLayout& layout,
                const std::vector<SweepCell>& cells, const SweepMap& map,
                const DrawingOptions& drawing) {
  std::string lines;
  for (std::size_t i = 0; i < cells.size(); ++i) lines += sweepLine(layout, cells[i], i) + "\n";
  writeText(arguments.fileIn("sweep.jsonl"), lines);
  writeText(arguments.fileIn("sweep.csv"), sweepCsv(layout, cells));
  writeText(arguments.fileIn("boundary.csv"), boundaryCsv(layout, map));
  std::string title = "Sweep in " + arguments.scene;
  if (!arguments.type.empty()) {
    title += std::string(": ") + toString(*collisionTypeFromString(arguments.type));
  }
  if (arguments.now) title += ", t0 " + numberText(*arguments.now) + " s";
  if (arguments.tta) title += ", TTA " + numberText(*arguments.tta) + " s";
  drawSweepMap(arguments.fileIn("map.png"), map, title,
               counted(cells.size(), "cell") + ": " + statusCounts(cells), drawing);
}

int sweep(Arguments arguments) {
  if (!arguments.bag.empty()) {
    arguments.logs = logSourceAt(arguments.bag, "");
    arguments.scene = fs::path(arguments.bag).stem().string();
  }
  const PlannerTestRun run(arguments);
  SceneSource scenes(arguments.logs, {arguments.scene}, run.config(), 1, printWarnings,
                     showReading());
  const Design design = designOf(arguments, scenes.at(arguments.scene)->scene, run.config());
  const std::vector<PlannerTestResult> results = test(arguments, run, design, scenes);
  std::vector<SweepCell> cells;
  for (std::size_t i = 0; i < results.size(); ++i) cells.push_back({design.values[i], results[i]});
  const SweepLayout layout = layoutOf(arguments);
  const SweepMap map = sweepMap(layout, cells);
  writeFiles(arguments, layout, cells, map, run.config().drawing);
  run.writePage({arguments.fileIn("scenarios.jsonl"), arguments.fileIn("map.png")}, arguments.logs);
  const bool is_feasible = anyTested(results);
  std::cout << counted(cells.size(), "cell") << ": " << statusCounts(cells) << "\n"
            << (is_feasible ? verdictTable(cells, map) : "") << "in " << arguments.out
            << ": map.png, sweep.csv, boundary.csv, sweep.jsonl\n";
  if (is_feasible) return run.applyCriteria(results, kExitOk);
  std::cerr << "NOTHING_FEASIBLE: no cell of the sweep has an attack; docs/rejections.md explains "
               "the codes\n";
  return kExitNoAttack;
}

void addRequestOptions(CLI::App& app, Arguments& arguments) {
  CLI::Option_group& recording =
      *app.add_option_group("recording", "a bag, or one scene of a source");
  recording.add_option("--bag", arguments.bag, "recorded bag, as written by forge convert");
  CLI::Option* source = addSource(app, arguments.logs, "recorded scenes, requires --scene");
  recording.add_option(source);
  recording.require_option(1);
  source->needs(app.add_option("--scene", arguments.scene, "name of the scene, e.g. scene-0061")
                    ->needs(source));
  app.add_option("--now", arguments.now,
                 "time of the request t0, s from the first frame; uses the frame at or before");
  app.add_option("--type", arguments.type, "requested collision type: " + collisionTypeWords())
      ->check(checkType);
  app.add_option("--tta", arguments.tta, "time to attack, s: time from t0 to contact");
  addAttacker(app, arguments.controls);
  addControls(app, arguments.controls);
  addMethod(app, arguments.method, arguments.config);
  addMode(app, arguments.mode, true);
  addSeed(app, arguments.seed, "random seed of the candidates and of the Latin hypercube");
}

}  // namespace

void addSweep(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kPlanners, "sweep",
                           "Varies fields of one request; maps where planners and careful drivers "
                           "avoid the crash.",
                           [arguments] { return sweep(*arguments); });
  addRequestOptions(app, *arguments);
  std::string names;
  for (const SweepParameter& parameter : sweepParameters()) {
    names += (names.empty() ? "" : ", ") + parameter.name;
  }
  app.add_option("--vary", arguments->vary,
                 "field and its values: NAME=MIN:MAX:STEP or NAME=VALUE,VALUE, with "
                 "--latin-hypercube also NAME=MIN:MAX; repeatable. Fields: " +
                     names)
      ->required();
  app.add_option("--latin-hypercube", arguments->samples,
                 "number of samples in place of the grid of all combinations")
      ->check(CLI::Range(std::size_t{1}, kMaxSweepCells));
  app.add_option(
         "--map", arguments->map,
         "parameters on the axes of the map: horizontal,vertical; default: the first two of "
         "--vary")
      ->delimiter(',');
  addPolicies(app, arguments->policies, "fixed");
  addPlannerTestOptions(app, *arguments);
  app.final_callback([arguments] { parseAxes(*arguments); });
  app.footer(
      "Exit codes: 0 success, 1 error, 2 invalid command line, 3 no cell has an attack (the files "
      "are written), 4 a planner fails --fail-if.");
}

}  // namespace forge
