#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/forecast/ego_futures.h"
#include "collision_forge/attack/forecast/ego_paths.h"
#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/network/network_ego_futures.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/io/weights/speed_model_file.h"
#include "collision_forge/io/weights/speed_profiles_file.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/statistics/statistics.h"
#include "collision_forge/study/commands/study_commands.h"

namespace forge {
namespace {

constexpr double kHorizons[] = {2.0, 3.0, 4.0, 5.0, 6.0};  // s
constexpr double kIntervals[] = {0.5, 0.8, 0.9};           // central ones, of probability
constexpr std::size_t kPitBins = 10;

struct Arguments {
  LogSource logs;
  std::string profiles;
  std::string speed_model;
  std::string networks;
  std::string out;
  std::string config;
  double stride = 2.0;     // s
  double min_speed = 2.0;  // m/s
  double horizon = 9.5;    // s that are sampled
  int count = 64;
};

/// What one set of samples was worth at one horizon. Metres; along and across the recorded heading.
struct Case {
  double constant_velocity = 0.0;
  double lane_following = 0.0;  ///< predictFuture()
  double mean = 0.0;
  double along = 0.0;
  double across = 0.0;
  double medoid = 0.0;
  double best = 0.0;
  double pit = 0.0;   ///< share of the samples that drove less far than the ego
  double crps = 0.0;  ///< m, continuous ranked probability score of the distance driven
};

struct Results {
  std::map<double, std::vector<Case>> cases;  ///< by horizon
  std::vector<double> milliseconds;           ///< one a call
};

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

std::vector<Vector2> positionsAt(const std::vector<Track>& tracks, double time) {
  std::vector<Vector2> positions;
  for (const Track& track : tracks) positions.push_back(stateAt(track, time)->pose.position());
  return positions;
}

double meanDistance(const std::vector<Vector2>& points, const Vector2& from) {
  double sum = 0.0;
  for (const Vector2& point : points) sum += (point - from).norm();
  return sum / static_cast<double>(points.size());
}

Vector2 medoidOf(const std::vector<Vector2>& points) {
  return *std::min_element(points.begin(), points.end(), [&](const Vector2& a, const Vector2& b) {
    return meanDistance(points, a) < meanDistance(points, b);
  });
}

/// Continuous ranked probability score of equally likely samples.
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

Case compare(const std::vector<Track>& samples, const Track& lane_following,
             const Snapshot& snapshot, const Track& recorded, double time) {
  const Pose2 truth = stateAt(recorded, time)->pose;
  const std::vector<Vector2> points = positionsAt(samples, time);
  const Vector2 mean =
      std::accumulate(points.begin(), points.end(), Vector2(0.0, 0.0)) / points.size();
  const AgentState& now = snapshot.ego.states.back();
  const Vector2 straight = now.pose.position() + (time - snapshot.now) * now.velocity;
  const Pose2 error = relativeTo(truth, {mean.x(), mean.y(), 0.0});
  Case result;
  result.constant_velocity = (straight - truth.position()).norm();
  result.lane_following =
      (stateAt(lane_following, time)->pose.position() - truth.position()).norm();
  result.mean = (mean - truth.position()).norm();
  result.along = std::abs(error.x);
  result.across = std::abs(error.y);
  result.medoid = (medoidOf(points) - truth.position()).norm();
  result.best = std::numeric_limits<double>::infinity();
  for (const Vector2& point : points) {
    result.best = std::min(result.best, (point - truth.position()).norm());
  }
  const double driven = drivenUntil(recorded, time);
  std::vector<double> distances;
  int shorter = 0;
  for (const Track& sample : samples) {
    distances.push_back(drivenUntil(sample, time));
    shorter += distances.back() < driven;
  }
  result.pit = shorter / static_cast<double>(samples.size());
  result.crps = crpsOf(std::move(distances), driven);
  return result;
}

void measureAt(double now, const Scene& scene, const LaneIndex& lanes,
               const EgoFutureSampler& sampler, const Config& config, const Arguments& arguments,
               std::ostream& csv, Results& results) {
  const Snapshot snapshot = snapshotAt(scene, now, config.attack.prediction.history_frames);
  if (egoNow(snapshot.ego).past_speeds[0] < arguments.min_speed) return;
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<Track> samples =
      sampler.sample(snapshot, lanes, arguments.horizon, arguments.count, 0);
  const std::chrono::duration<double, std::milli> duration =
      std::chrono::steady_clock::now() - begin;
  results.milliseconds.push_back(duration.count());
  const Track recorded = recordedFuture(scene, now).ego;
  const Track lane_following =
      predictFuture(snapshot, lanes, arguments.horizon, config.attack.prediction).ego;
  for (const double horizon : kHorizons) {
    if (!stateAt(recorded, now + horizon)) continue;
    const Case result = compare(samples, lane_following, snapshot, recorded, now + horizon);
    results.cases[horizon].push_back(result);
    csv << scene.name << ',' << now - scene.frame_times.front() << ',' << horizon << ','
        << result.constant_velocity << ',' << result.lane_following << ',' << result.mean << ','
        << result.along << ',' << result.across << ',' << result.medoid << ',' << result.best << ','
        << result.pit << ',' << result.crps << '\n';
  }
}

double average(const std::vector<Case>& cases, double Case::*value) {
  double sum = 0.0;
  for (const Case& result : cases) sum += result.*value;
  return sum / static_cast<double>(cases.size());
}

void printErrors(const Results& results) {
  std::printf(
      "| s | cases | constant velocity | predictFuture() | mean of samples | along | across | "
      "medoid | best | CRPS |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& [horizon, cases] : results.cases) {
    std::printf("| %g | %zu | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.3f |\n", horizon,
                cases.size(), average(cases, &Case::constant_velocity),
                average(cases, &Case::lane_following), average(cases, &Case::mean),
                average(cases, &Case::along), average(cases, &Case::across),
                average(cases, &Case::medoid), average(cases, &Case::best),
                average(cases, &Case::crps));
  }
}

void printCalibration(const Results& results) {
  std::printf(
      "\n| s | in central 50 %% | 80 %% | 90 %% | PIT, shares of tenths "
      "|\n|---|---|---|---|---|\n");
  for (const auto& [horizon, cases] : results.cases) {
    std::printf("| %g |", horizon);
    for (const double interval : kIntervals) {
      int inside = 0;
      for (const Case& result : cases) inside += std::abs(result.pit - 0.5) <= 0.5 * interval;
      std::printf(" %.1f %% |", 100.0 * inside / static_cast<double>(cases.size()));
    }
    std::vector<int> bins(kPitBins, 0);
    for (const Case& result : cases) {
      ++bins[std::min(static_cast<std::size_t>(result.pit * kPitBins), kPitBins - 1)];
    }
    for (const int bin : bins) {
      std::printf(" %.3f", static_cast<double>(bin) / static_cast<double>(cases.size()));
    }
    std::printf(" |\n");
  }
}

void printTimes(std::vector<double> milliseconds) {
  if (milliseconds.empty()) return;
  std::sort(milliseconds.begin(), milliseconds.end());
  std::printf("\nsampling: p50 %.2f ms, p95 %.2f ms, longest %.2f ms\n",
              quantile(milliseconds, 0.5), quantile(milliseconds, 0.95), milliseconds.back());
}

std::shared_ptr<const SpeedForecaster> readSpeeds(const Arguments& arguments,
                                                  const Config& config) {
  if (!arguments.profiles.empty()) {
    return std::make_shared<const SpeedProfiles>(
        readSpeedProfiles(arguments.profiles, config.recorded_speeds));
  }
  if (arguments.speed_model.empty()) return nullptr;
  return std::make_shared<const SpeedModel>(readSpeedModel(arguments.speed_model));
}

int measure(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const Foresight foresight{
      readSpeeds(arguments, config), loadPatternNetwork(arguments.networks), {}};
  std::optional<OutputLock> lock;
  std::optional<AsideFile> file;
  if (!arguments.out.empty()) {
    lock.emplace(OutputLock::ofFile(arguments.out));
    file.emplace(arguments.out);
  }
  SceneSource scenes(arguments.logs, {}, config, 1, {}, showReading());
  const std::vector<std::string> names = scenes.names();
  std::ostream nowhere(nullptr);
  std::ostream& csv = file ? file->stream() : nowhere;
  csv << "scene,now,horizon,constant_velocity,lane_following,mean,along,across,medoid,best,pit,"
         "crps\n";
  Results results;
  ProgressLine progress("scenes");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto indexed = scenes.at(names[i]);
    const Scene& scene = indexed->scene;
    const NetworkEgoFutures sampler(config.attack.ego_futures, foresight.withoutScene(names[i]));
    const double last = scene.frame_times.back() - kHorizons[0] + 1e-6;
    for (double at = scene.frame_times.front() + arguments.stride; at <= last;
         at += arguments.stride) {
      measureAt(*lastFrameTime(scene, at), scene, *indexed->lanes, sampler, config, arguments, csv,
                results);
    }
    progress.show(i + 1, names.size());
  }
  if (file) file->commit();
  printErrors(results);
  printCalibration(results);
  printTimes(results.milliseconds);
  return kExitOk;
}

}  // namespace

void addMeasureEgoFutures(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMeasuring, "study measure ego-futures",
                           "Compares sampled futures of the ego with recordings.",
                           [arguments] { return measure(*arguments); });
  addSource(app, arguments->logs)->required();
  CLI::Option* profiles = app.add_option("--profiles", arguments->profiles,
                                         "CSV of forge study speeds collect; none by default");
  app.add_option("--speed-model", arguments->speed_model,
                 "file of forge study speeds fit; none by default")
      ->excludes(profiles);
  app.add_option("--networks", arguments->networks,
                 "file of trained networks; none by default: kinematic futures");
  app.add_option("--out", arguments->out, "CSV to write, a row a case and horizon");
  app.add_option("--stride", arguments->stride, "seconds between the times sampled from")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--min-speed", arguments->min_speed, "m/s; slower egos are left out")
      ->capture_default_str();
  app.add_option("--horizon", arguments->horizon, "seconds sampled, 6 at least")
      ->check(CLI::Range(6.0, 60.0))
      ->capture_default_str();
  app.add_option("--count", arguments->count, "samples")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addConfig(app, arguments->config);
}

}  // namespace forge
