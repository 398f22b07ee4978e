#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/forecast/ego_futures.h"
#include "collision_forge/attack/network/predicted_scene.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/collide/collide_scene.h"
#include "collision_forge/io/collide/collide_set.h"
#include "collision_forge/io/logs/city_maps.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/study/commands/clip_options.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

struct Arguments {
  std::string collide;
  std::string dataroot;
  std::string split = "val";
  ConfigFolder config;
  bool unseen = false;
  bool seen_scenes = false;
};

/// The prediction errors of one clip.
struct ClipResult {
  CollisionType type = CollisionType::kRearEnd;
  double tta = 0.0;             ///< s
  double displacement = 0.0;    ///< m, error of the network's ego position at impact
  double kinematic = 0.0;       ///< m, the same error for the mean of KinematicEgoFutures
  double heading = 0.0;         ///< rad, absolute error of the network's ego heading
  double log_density = 0.0;     ///< log of the predicted density (1/m2) at the true position
  int rank = 0;                 ///< rank of the true attacker by score, from 1; 0: not a candidate
  double offset = 0.0;          ///< m, error of the attacker's position, given the true ego pose
  double offset_heading = 0.0;  ///< rad, absolute error of its heading, given the same
};

double errorOfMean(const EgoFutureSampler& sampler, const Snapshot& snapshot,
                   const LaneIndex& lanes, double time, const Vector2& truth) {
  constexpr int kSamples = 128;
  Vector2 mean = Vector2::Zero();
  for (const Track& track : sampler.sample(snapshot, lanes, time - snapshot.now, kSamples, 0)) {
    mean += stateAt(track, time)->pose.position() / kSamples;
  }
  return (mean - truth).norm();
}

int rankOf(std::size_t which, const std::vector<double>& scores) {
  int rank = 1;
  for (std::size_t i = 0; i < scores.size(); ++i) rank += scores[i] > scores[which];
  return rank;
}

void judgeCandidates(const PredictedScene& scene, const CollideClip& clip, const Snapshot& snapshot,
                     const StudyConfig& config, const Pose2& expected, const Pose2& truth,
                     ClipResult& result) {
  std::vector<const Track*> candidates;
  std::size_t attacker = snapshot.agents.size();
  for (const Track& agent : snapshot.agents) {
    if (!isCandidate(agent, snapshot, config.attack.prediction)) continue;
    if (agent.id == clip.attacker_id) attacker = candidates.size();
    candidates.push_back(&agent);
  }
  if (attacker >= candidates.size()) return;
  std::vector<double> scores;
  for (const CandidatePrediction& answer :
       scene.judge(candidates, expected, clip.tta(), clip.type)) {
    scores.push_back(answer.score);
  }
  result.rank = rankOf(attacker, scores);
  const Pose2 offset = scene.judge({candidates[attacker]}, truth, clip.tta(), clip.type)[0].offset;
  const Pose2 ego = compose(scene.ways().ego.state.pose, truth);
  const Pose2 recorded = relativeTo(ego, clip.attacker().frames.back()->pose);
  result.offset = (offset.position() - recorded.position()).norm();
  result.offset_heading = std::abs(angleBetween(offset.yaw, recorded.yaw));
}

void measureClip(const CollideClip& clip, const LaneIndex& lanes, const PatternNetwork& network,
                 const EgoFutureSampler& kinematic, const StudyConfig& config,
                 const Arguments& arguments, std::vector<ClipResult>& results) {
  const Scene recorded = toScene(clip, config.evaluation.collide, nullptr);
  const Snapshot snapshot =
      snapshotAt(recorded, clip.now(), network.weights().features.history_frames);
  const PredictedScene scene(network, snapshot, lanes, clip.tta());
  const auto components =
      scene.egoAfter(clip.tta(), arguments.seen_scenes ? std::optional(clip.type) : std::nullopt);
  const Pose2 expected = medianPose(components);
  const Pose2 truth =
      relativeTo(scene.ways().ego.state.pose, stateAt(recorded.ego, clip.times.back())->pose);
  ClipResult result;
  result.type = clip.type;
  result.tta = clip.nominalTta();
  result.displacement = (expected.position() - truth.position()).norm();
  result.heading = std::abs(angleBetween(expected.yaw, truth.yaw));
  result.log_density = logDensity(components, truth.position());
  const Vector2 place = stateAt(recorded.ego, clip.times.back())->pose.position();
  result.kinematic = errorOfMean(kinematic, snapshot, lanes, clip.times.back(), place);
  judgeCandidates(scene, clip, snapshot, config, expected, truth, result);
  results.push_back(result);
}

void printRow(const std::string& name, const std::vector<ClipResult>& clips) {
  if (clips.empty()) return;
  double displacement = 0.0;
  double kinematic = 0.0;
  double heading = 0.0;
  double density = 0.0;
  double offset = 0.0;
  double offset_heading = 0.0;
  int known = 0;
  int first = 0;
  int third = 0;
  std::vector<double> sorted;
  for (const ClipResult& clip : clips) {
    displacement += clip.displacement;
    sorted.push_back(clip.displacement);
    kinematic += clip.kinematic;
    heading += clip.heading;
    density += clip.log_density;
    if (clip.rank == 0) continue;
    ++known;
    first += clip.rank == 1;
    third += clip.rank <= 3;
    offset += clip.offset;
    offset_heading += clip.offset_heading;
  }
  std::sort(sorted.begin(), sorted.end());
  const double count = static_cast<double>(clips.size());
  const double of_known = std::max(known, 1);
  const double degrees = 180.0 / M_PI;
  std::printf("| %s | %zu | %.2f | %.2f | %.2f | %.2f | %.2f | %.3f | %.3f | %.2f | %.1f |\n",
              name.c_str(), clips.size(), displacement / count, sorted[sorted.size() / 2],
              kinematic / count, heading / count * degrees, density / count, first / of_known,
              third / of_known, offset / of_known, offset_heading / of_known * degrees);
}

void print(const std::vector<ClipResult>& results) {
  std::printf(
      "| clips | | displacement, m | median | kinematic futures | heading, deg | log density | "
      "attacker first | in three | offset, m | deg "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  if (results.empty()) {
    throw std::runtime_error(
        "the split contains no clip to measure; omit --unseen or change --split");
  }
  printRow("all", results);
  std::map<std::string, std::vector<ClipResult>> groups;
  for (const ClipResult& clip : results) {
    groups[std::string("type ") + toString(clip.type)].push_back(clip);
    const char* tta = clip.tta < 1.25   ? "TTA 0.5-1 s"
                      : clip.tta < 2.75 ? "TTA 1.5-2.5 s"
                      : clip.tta < 4.75 ? "TTA 3-4.5 s"
                                        : "TTA 5 s and more";
    groups[tta].push_back(clip);
  }
  for (const auto& [name, clips] : groups) printRow(name, clips);
}

int measure(const Arguments& arguments) {
  const StudyConfig config = loadStudyConfig(arguments.config);
  const PredictionModels models = loadPredictionModels(config);
  if (!models.network) {
    throw std::runtime_error("models.yaml: pattern_network is empty; name a network file");
  }
  CityMaps lanes(arguments.dataroot, config);
  ProgressLine progress("measuring");
  std::vector<ClipResult> results;
  const auto paths = listCollideClips(arguments.collide, arguments.split);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const CollideClip clip = readCollideClip(paths[i], config.input_limits);
    const PredictionModels known = arguments.seen_scenes ? models : models.withoutScene(clip.scene);
    const auto& left_out = known.network->weights().left_out_scenes;
    if (arguments.unseen &&
        std::find(left_out.begin(), left_out.end(), clip.scene) == left_out.end()) {
      continue;
    }
    const KinematicEgoFutures kinematic(config.attack.ego_futures, known.speeds);
    measureClip(clip, *lanes.at(clip.city), *known.network, kinematic, config, arguments, results);
    progress.show(static_cast<double>(i + 1) / static_cast<double>(paths.size()));
  }
  print(results);
  return kExitOk;
}

}  // namespace

void addMeasurePatterns(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMeasuring, "study measure patterns",
                           "Compares predicted collision patterns with COLLIDE clips.",
                           [arguments] { return measure(*arguments); });
  CLI::Option* collide = addCollide(app, arguments->collide)->required();
  addDataroot(app, arguments->dataroot);
  addSplit(app, arguments->split, collide);
  CLI::Option* seen = app.add_flag(
      "--seen-scenes", arguments->seen_scenes,
      "use the network trained on all scenes, with the collision type as input, as if splits "
      "shared scenes");
  app.add_flag("--unseen", arguments->unseen,
               "only clips of scenes that were left out in the training of the network used")
      ->excludes(seen);
  addConfig(app, arguments->config);
}

}  // namespace forge
