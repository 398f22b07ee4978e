#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/forecast/ego_paths.h"
#include "collision_forge/attack/network/network_ego_futures.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/study/commands/study_commands.h"

namespace forge {
namespace {

constexpr double kHorizons[] = {2.0, 3.0, 4.0, 5.0, 6.0};  // s
constexpr double kIntervals[] = {0.5, 0.8, 0.9};           // central probability intervals
constexpr double kSampled = 9.5;                           // s, horizon of the samples for TTA 6 s
constexpr int kSamples = 64;
constexpr double kMinSpeed = 2.0;  // m/s; slower egos, which mostly stand, are skipped

struct Arguments {
  LogSource logs;
  ConfigFolder config;
  double stride = 2.0;  // s
};

/// The errors of one set of samples at one horizon.
struct Case {
  double constant_velocity = 0.0;  ///< m, error
  double mean = 0.0;               ///< m, error of the mean of the samples
  double shorter = 0.0;            ///< share 0..1 of the samples with less distance than the ego
  double crps = 0.0;  ///< m, continuous ranked probability score of the distance driven
};

using Cases = std::map<double, std::vector<Case>>;  // by horizon

double drivenUntil(const Track& track, double time) {
  double distance = 0.0;
  const AgentState* before = &track.states.front();
  for (const AgentState& state : track.states) {
    if (state.time > time + 1e-6) break;
    distance += (state.pose.position() - before->pose.position()).norm();
    before = &state;
  }
  return distance;
}

/// Returns the continuous ranked probability score of equally likely samples, in their unit.
double crpsOf(std::vector<double> samples, double truth) {
  std::sort(samples.begin(), samples.end());
  const double count = static_cast<double>(samples.size());
  double error = 0.0;
  double spread = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    error += std::abs(samples[i] - truth) / count;
    spread += samples[i] * (2.0 * static_cast<double>(i) + 1.0 - count) / (count * count);
  }
  return error - spread;
}

Case compare(const std::vector<Track>& samples, const Snapshot& snapshot, const Track& recorded,
             double time) {
  const Vector2 truth = stateAt(recorded, time)->pose.position();
  const AgentState& now = snapshot.ego.states.back();
  const Vector2 straight = now.pose.position() + (time - snapshot.now) * now.velocity;
  const double driven = drivenUntil(recorded, time);
  Vector2 mean = Vector2::Zero();
  std::vector<double> distances;
  int shorter = 0;
  for (const Track& sample : samples) {
    mean += stateAt(sample, time)->pose.position() / static_cast<double>(samples.size());
    distances.push_back(drivenUntil(sample, time));
    shorter += distances.back() < driven;
  }
  return {(straight - truth).norm(), (mean - truth).norm(),
          shorter / static_cast<double>(samples.size()), crpsOf(std::move(distances), driven)};
}

void measureAt(double now, const IndexedScene& indexed, const EgoFutureSampler& sampler,
               const Config& config, Cases& cases) {
  const Snapshot snapshot = snapshotAt(indexed.scene, now, config.attack.prediction.history_frames);
  if (egoNow(snapshot.ego).past_speeds[0] < kMinSpeed) return;
  const std::vector<Track> samples =
      sampler.sample(snapshot, *indexed.lanes, kSampled, kSamples, 0);
  const Track recorded = recordedFuture(indexed.scene, now).ego;
  for (const double horizon : kHorizons) {
    if (!stateAt(recorded, now + horizon)) continue;
    cases[horizon].push_back(compare(samples, snapshot, recorded, now + horizon));
  }
}

double average(const std::vector<Case>& cases, double Case::*value) {
  double sum = 0.0;
  for (const Case& result : cases) sum += result.*value;
  return sum / static_cast<double>(cases.size());
}

void print(const Cases& cases) {
  std::printf(
      "| s | cases | constant velocity | mean of samples | CRPS | in central 50 %% | 80 %% | 90 %% "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (const auto& [horizon, of_horizon] : cases) {
    std::printf("| %g | %zu | %.2f | %.2f | %.3f |", horizon, of_horizon.size(),
                average(of_horizon, &Case::constant_velocity), average(of_horizon, &Case::mean),
                average(of_horizon, &Case::crps));
    for (const double interval : kIntervals) {
      const auto inside = std::count_if(
          of_horizon.begin(), of_horizon.end(),
          [=](const Case& result) { return std::abs(result.shorter - 0.5) <= 0.5 * interval; });
      std::printf(" %.1f %% |",
                  100.0 * static_cast<double>(inside) / static_cast<double>(of_horizon.size()));
    }
    std::printf("\n");
  }
}

int measure(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const PredictionModels models = loadPredictionModels(config);
  SceneSource scenes(arguments.logs, {}, config, 1, {}, showReading());
  const std::vector<std::string> names = scenes.names();
  Cases cases;
  ProgressLine progress("scenes");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto indexed = scenes.at(names[i]);
    const std::vector<double>& times = indexed->scene.frame_times;
    const NetworkEgoFutures sampler(config.attack.ego_futures, models.withoutScene(names[i]));
    const double last = times.back() - kHorizons[0] + 1e-6;
    for (double at = times.front() + arguments.stride; at <= last; at += arguments.stride) {
      measureAt(*lastFrameTime(indexed->scene, at), *indexed, sampler, config, cases);
    }
    progress.show(i + 1, names.size());
  }
  print(cases);
  return kExitOk;
}

}  // namespace

void addMeasureEgoFutures(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMeasuring, "study measure ego-futures",
                           "Compares predicted futures of the ego (models.yaml) with recordings.",
                           [arguments] { return measure(*arguments); });
  addSource(app, arguments->logs)->required();
  app.add_option("--stride", arguments->stride, "time between two predictions of a scene, s")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addConfig(app, arguments->config);
}

}  // namespace forge
