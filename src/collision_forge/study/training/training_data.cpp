#include "collision_forge/study/training/training_data.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <random>
#include <thread>

#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/files/fingerprint.h"
#include "collision_forge/io/collide/collide_scene.h"
#include "collision_forge/io/collide/collide_set.h"
#include "collision_forge/io/logs/city_maps.h"
#include "collision_forge/io/logs/scene_source.h"

namespace forge {
namespace {

constexpr double kTtaStep = 0.5;  // s
constexpr int kTimesAMoment = 4;  // prediction times per sample
constexpr int kClipTimes = 3;     // prediction times per clip besides the impact

std::uint64_t seedOf(const std::string& text, std::uint64_t seed) {
  return hashOf(text, kHashBasis ^ seed);
}

/// Draws `count` TTAs (s) within the recording, stratified from short to long.
std::vector<double> drawTtas(const Track& ego, double now, double longest, int count,
                             std::mt19937_64& engine) {
  std::vector<double> known;
  for (int i = 1; i * kTtaStep <= longest + 1e-6; ++i) {
    if (stateAt(ego, now + i * kTtaStep)) known.push_back(i * kTtaStep);
  }
  std::vector<double> drawn;
  for (int i = 0; i < count && !known.empty(); ++i) {
    const double share = (i + static_cast<double>(engine() >> 11) * 0x1.0p-53) / count;
    drawn.push_back(known[static_cast<std::size_t>(share * static_cast<double>(known.size()))]);
  }
  return drawn;
}

TimedSample timedSample(const EgoPathSet& ways, const LaneIndex& lanes, const Track& ego,
                        double now, double tta, const PatternFeatureOptions& features) {
  const Pose2 there = stateAt(ego, now + tta)->pose;
  return {tta, anchorFeatures(ways, lanes, tta, features), relativeTo(ways.ego.state.pose, there)};
}

/// Returns nullopt for a moment without enough history or without future.
std::optional<TrainingSample> momentSample(const Scene& scene, double now, const LaneIndex& lanes,
                                           const LearningOptions& options,
                                           std::mt19937_64& engine) {
  const PatternFeatureOptions& features = options.pattern_features;
  const Snapshot observed = observedSnapshot(snapshotAt(scene, now, features.history_frames), {});
  if (observed.ego.states.size() < 2 || !endsAt(observed.ego, now)) return std::nullopt;
  const std::vector<double> ttas =
      drawTtas(scene.ego, now, options.training.max_tta, kTimesAMoment, engine);
  if (ttas.empty()) return std::nullopt;
  TrainingSample sample;
  sample.scene = scene.name;
  sample.features = sceneFeatures(observed, lanes, features);
  const EgoPathSet ways = egoPathSet(observed, lanes, options.training.max_tta, features.max_ways);
  sample.ego_speed = ways.ego.past_speeds[0];
  for (const double tta : ttas) {
    sample.times.push_back(timedSample(ways, lanes, scene.ego, now, tta, features));
  }
  return sample;
}

double meanSpeed(const Track& track) {
  if (track.states.size() < 2) return 0.0;
  double driven = 0.0;
  for (std::size_t i = 1; i < track.states.size(); ++i) {
    driven += (track.states[i].pose.position() - track.states[i - 1].pose.position()).norm();
  }
  return driven / (track.states.back().time - track.states.front().time);
}

/// Returns the recording with one of its vehicles in the role of the ego.
Scene seenFrom(const Scene& scene, std::size_t vehicle) {
  Scene other = scene;
  std::swap(other.ego, other.agents[vehicle]);
  other.agents[vehicle].id = "recorder";
  other.ego.id = kEgoId;
  return other;
}

void collectScene(const Scene& scene, const LaneIndex& lanes, const LearningOptions& options,
                  std::uint64_t seed, std::vector<TrainingSample>& samples) {
  std::mt19937_64 engine(seedOf(scene.name, seed));
  const auto keep = [&](std::optional<TrainingSample> sample) {
    if (sample) samples.push_back(std::move(*sample));
  };
  for (const double now : scene.frame_times) {
    keep(momentSample(scene, now, lanes, options, engine));
  }
  for (std::size_t i = 0; i < scene.agents.size(); ++i) {
    const Track& vehicle = scene.agents[i];
    if (!isCarLike(vehicle.agent_class) ||
        meanSpeed(vehicle) < options.training.min_vehicle_speed) {
      continue;
    }
    const Scene other = seenFrom(scene, i);
    double next = -1e300;
    for (const double now : scene.frame_times) {
      if (now < next - 0.1 || !stateAt(vehicle, now)) continue;
      next = now + options.training.vehicle_stride;
      keep(momentSample(other, now, lanes, options, engine));
    }
  }
}

std::vector<std::string> clipPaths(const TrainingSources& sources) {
  std::vector<std::string> paths;
  for (const std::string& split : sources.splits) {
    const auto listed = listCollideClips(sources.collide, split);
    paths.insert(paths.end(), listed.begin(), listed.end());
  }
  return paths;
}

std::optional<AttackSample> attackOf(const CollideClip& clip, const Scene& scene,
                                     const Snapshot& observed, const EgoPathSet& ways,
                                     const LearningOptions& options) {
  AttackSample attack;
  attack.type = clip.type;
  attack.tta = clip.tta();
  const Pose2 ego = stateAt(scene.ego, clip.times.back())->pose;
  attack.ego = relativeTo(ways.ego.state.pose, ego);
  bool found = false;
  for (const Track& agent : observed.agents) {
    if (!isCandidate(agent, observed, options.attack.prediction)) continue;
    if (agent.id == clip.attacker_id) {
      attack.attacker = attack.candidates.size();
      found = true;
    }
    attack.candidates.push_back(candidateNow(agent, ways.ego.state.pose));
  }
  if (!found) return std::nullopt;
  const CollideState& attacker = *clip.attacker().frames.back();
  attack.offset = relativeTo(ego, attacker.pose);
  return attack;
}

}  // namespace

bool TrainingSources::hasLogs() const {
  return collide.empty() || !logs.version.empty() || logs.format != &nuScenesFormat();
}

std::vector<std::string> sceneNames(const TrainingSources& sources) {
  std::set<std::string> names;
  if (sources.hasLogs()) {
    for (const std::string& name : readSceneNames(sources.logs)) names.insert(name);
  }
  if (!sources.collide.empty()) {
    for (const std::string& path : clipPaths(sources)) names.insert(parseCollideName(path).scene);
  }
  return {names.begin(), names.end()};
}

std::set<std::string> scenesOfFold(std::vector<std::string> names, int fold, int folds,
                                   std::uint64_t seed) {
  std::sort(names.begin(), names.end());
  std::mt19937_64 engine(seed);
  for (std::size_t i = names.size(); i > 1; --i) std::swap(names[i - 1], names[engine() % i]);
  std::set<std::string> chosen;
  for (std::size_t i = static_cast<std::size_t>(fold - 1); i < names.size();
       i += static_cast<std::size_t>(folds)) {
    chosen.insert(names[i]);
  }
  return chosen;
}

std::optional<TrainingSample> clipSample(const std::string& path, const LaneIndex& lanes,
                                         const LearningOptions& options,
                                         const PatternFeatureOptions& features, int others,
                                         std::uint64_t seed) {
  const CollideClip clip = readCollideClip(path, options.input_limits);
  const Scene scene = toScene(clip, options.evaluation.collide, nullptr);
  const Snapshot observed =
      observedSnapshot(snapshotAt(scene, clip.now(), features.history_frames), {});
  const double longest = std::max(options.training.max_tta, clip.tta());
  const EgoPathSet ways = egoPathSet(observed, lanes, longest, features.max_ways);
  TrainingSample sample;
  sample.scene = clip.scene;
  sample.features = sceneFeatures(observed, lanes, features);
  sample.ego_speed = ways.ego.past_speeds[0];
  std::mt19937_64 engine(seedOf(clip.name, seed));
  for (int i = 0; i < others; ++i) {
    const std::size_t frames = clip.times.size() - 1 - kCollideNowFrame;
    const std::size_t frame = kCollideNowFrame + 1 + engine() % frames;
    sample.times.push_back(
        timedSample(ways, lanes, scene.ego, clip.now(), clip.times[frame] - clip.now(), features));
  }
  sample.times.push_back(timedSample(ways, lanes, scene.ego, clip.now(), clip.tta(), features));
  sample.attack = attackOf(clip, scene, observed, ways, options);
  return sample;
}

std::vector<TrainingSample> collectTrainingSamples(
    const TrainingSources& sources, const LearningOptions& options,
    const std::set<std::string>& left_out, std::uint64_t seed,
    const std::function<void(std::size_t, std::size_t)>& on_item) {
  CityMaps maps(sources.logs.path, options);
  std::vector<std::string> names;
  std::optional<SceneSource> scenes;
  if (sources.hasLogs()) {
    scenes.emplace(sources.logs, std::vector<std::string>(), options, 1);
    for (const std::string& name : scenes->names()) {
      if (left_out.count(name) == 0) names.push_back(name);
    }
  }
  std::vector<std::string> clips;
  if (!sources.collide.empty()) {
    for (const std::string& path : clipPaths(sources)) {
      if (left_out.count(parseCollideName(path).scene) == 0) clips.push_back(path);
    }
  }
  std::vector<std::vector<TrainingSample>> parts(names.size() + clips.size());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr problem;
  std::size_t done = 0;
  const auto collectItem = [&](std::size_t item) {
    if (item < names.size()) {
      const auto logged = scenes->at(names[item]);
      collectScene(logged->scene, *logged->lanes, options, seed, parts[item]);
      return;
    }
    const std::string& path = clips[item - names.size()];
    const auto sample = clipSample(path, *maps.at(parseCollideName(path).city), options,
                                   options.pattern_features, kClipTimes, seed);
    if (sample) parts[item].push_back(*sample);
  };
  const auto work = [&] {
    for (std::size_t item = next++; item < parts.size(); item = next++) {
      try {
        collectItem(item);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!problem) problem = std::current_exception();
        next = parts.size();
        return;
      }
      const std::lock_guard<std::mutex> lock(mutex);
      if (on_item) on_item(++done, parts.size());
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < sources.jobs; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (problem) std::rethrow_exception(problem);
  std::vector<TrainingSample> samples;
  for (auto& part : parts) {
    std::move(part.begin(), part.end(), std::back_inserter(samples));
    part.clear();
  }
  return samples;
}

}  // namespace forge
