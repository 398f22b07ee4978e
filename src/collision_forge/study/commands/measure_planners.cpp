#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/statistics/statistics.h"
#include "collision_forge/study/commands/study_commands.h"

namespace forge {
namespace {

struct Arguments {
  LogSource logs;
  std::vector<std::string> scenes;
  std::vector<std::string> planners = plannerNames();
  std::string planner_file;
  ConfigFolder config;
};

/// CPU time and number of observed agents of each planning step of one planner.
struct Measurement {
  std::string name;
  std::vector<double> milliseconds;
  std::vector<double> agents;
};

Observation observationAt(const Scene& scene, double now, int frames) {
  const Snapshot snapshot = snapshotAt(scene, now, frames);
  const AgentState& ego = snapshot.ego.states.back();
  Observation observation;
  observation.ego = {now, ego.pose, std::max(ego.velocity.dot(ego.pose.heading()), 0.0), 0.0, 0.0};
  for (const Track& track : snapshot.agents) {
    if (endsAt(track, now)) observation.agents.push_back(track);
  }
  observation.red_lanes = redLanes(scene.lights, now);
  return observation;
}

/// Returns the CPU time of this process and of the planner's worker processes, s.
double processorTime(const Planner& planner) {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC + planner.otherProcessorTime();
}

void measureScene(const IndexedScene& indexed, const Config& config, Measurement& measurement) {
  const Scene& scene = indexed.scene;
  const PlannerOptions& options = config.planners;
  const std::unique_ptr<Planner> planner = makePlanner(measurement.name, options, "").planner;
  planner->initialize({indexed.lanes, routeOf(scene.ego, *indexed.lanes, options.planning.route),
                       egoVehicleOf(scene, config.ego_vehicle.center_offset),
                       options.car.wheelbase});
  for (const double now : scene.frame_times) {
    const Observation observation =
        observationAt(scene, now, config.attack.prediction.history_frames);
    const double start = processorTime(*planner);
    planner->plan(observation);
    const double microseconds = std::round(1e6 * (processorTime(*planner) - start));
    measurement.milliseconds.push_back(1e-3 * microseconds);
    measurement.agents.push_back(static_cast<double>(observation.agents.size()));
  }
}

void print(Measurement& measurement) {
  auto& [name, milliseconds, agents] = measurement;
  std::sort(milliseconds.begin(), milliseconds.end());
  std::sort(agents.begin(), agents.end());
  std::cout << "| " << name << " | " << milliseconds.size() << " | " << quantile(agents, 0.5)
            << " | " << agents.back() << " | " << quantile(milliseconds, 0.5) << " | "
            << quantile(milliseconds, 0.99) << " | " << milliseconds.back() << " |\n";
}

int measure(const Arguments& arguments) {
  Config config = loadConfig(arguments.config);
  usePlannerFile(arguments.planner_file, arguments.planners, config);
  SceneSource scenes(arguments.logs, arguments.scenes, config, 1, {}, showReading());
  const std::vector<std::string> names = scenes.names();
  std::vector<Measurement> measurements;
  for (const std::string& planner : arguments.planners) measurements.push_back({planner, {}, {}});
  ProgressLine progress("scenes");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::shared_ptr<const IndexedScene> scene = scenes.at(names[i]);
    for (Measurement& measurement : measurements) measureScene(*scene, config, measurement);
    progress.show(i + 1, names.size());
  }
  std::cout << "| planner | steps | agents p50 | agents max | p50 ms | p99 ms | max ms |\n"
               "|---|---|---|---|---|---|---|\n";
  for (Measurement& measurement : measurements) print(measurement);
  return kExitOk;
}

}  // namespace

void addMeasurePlanners(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMeasuring, "study measure planners",
                           "Measures the CPU time per planning step at every frame of scenes.",
                           [arguments] { return measure(*arguments); });
  addSource(app, arguments->logs)->required();
  addScenes(app, arguments->scenes);
  app.add_option("--planners", arguments->planners, "planners to measure, separated by commas")
      ->delimiter(',')
      ->transform(oneOf(plannerNames()))
      ->capture_default_str();
  addPlannerFile(app, arguments->planner_file);
  addConfig(app, arguments->config);
}

}  // namespace forge
