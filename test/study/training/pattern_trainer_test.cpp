#include "collision_forge/study/training/pattern_trainer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

#include "attack/network/sample_network.h"
#include "collision_forge/attack/network/pattern_network.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/study/settings/study_config.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

TrainingOptions quickTraining() {
  TrainingOptions options = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config").training;
  options.epochs = 4;
  options.batch = 4;
  options.times = 2;
  options.dropout = 0.1;
  options.context_dropout = 0.2;
  return options;
}

PatternTrainer trainerOf(const TrainingOptions& options, std::uint64_t seed = 0,
                         const PatternFeatureOptions& features = smallFeatures()) {
  return {features, smallLayers(), options, "cpu", 1, seed};
}

/// Samples with different ego speeds; the second vehicle is the attacker.
std::vector<TrainingSample> samplesOf(const PatternFeatureOptions& options, int count) {
  std::vector<TrainingSample> samples;
  for (int i = 0; i < count; ++i) {
    Snapshot snapshot = junctionSnapshot();
    const double speed = 4.0 + i;
    snapshot.ego = pastTrack(kEgoId, kEgoSize, {-40.0, -1.75, 0.0}, speed);
    const Snapshot observed = observedSnapshot(snapshot, {});
    const LaneIndex lanes = lanesOf(snapshot);
    const EgoPathSet ways = egoPathSet(observed, lanes, 9.0, options.max_ways);
    TrainingSample sample;
    sample.scene = "scene-" + std::to_string(i);
    sample.features = sceneFeatures(observed, lanes, options);
    sample.ego_speed = speed;
    for (const double tta : {1.0, 3.0}) {
      sample.times.push_back({tta,
                              anchorFeatures(ways, lanes, tta, options),
                              {0.9 * speed * tta, 0.1 * tta, 0.02 * i}});
    }
    if (i % 2 == 0) {
      AttackSample attack;
      attack.type = CollisionType::kJunctionCrossing;
      attack.tta = 3.0;
      attack.ego = sample.times.back().ego;
      for (const Track& agent : observed.agents) {
        attack.candidates.push_back(candidateNow(agent, snapshot.ego.states.back().pose));
      }
      attack.attacker = 1;
      attack.offset = {1.0, -3.0, M_PI_2};
      sample.attack = attack;
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

std::vector<std::size_t> all(const std::vector<TrainingSample>& samples) {
  std::vector<std::size_t> indices(samples.size());
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i;
  return indices;
}

class Heads : public testing::TestWithParam<EgoHead> {
 protected:
  PatternFeatureOptions features() const {
    PatternFeatureOptions options = smallFeatures();
    options.head = GetParam();
    return options;
  }
};
INSTANTIATE_TEST_SUITE_P(PatternTrainer, Heads,
                         testing::Values(EgoHead::kRegionProposal, EgoHead::kTargetPoints,
                                         EgoHead::kRegression),
                         [](const auto& info) { return std::string(toString(info.param)); });

/// Compares gradients with finite differences, for layers with names that begin with `prefix`, or
/// for all others.
void checkGradients(PatternTrainer trainer, const std::vector<TrainingSample>& samples,
                    const std::string& prefix, bool others) {
  std::map<std::string, std::vector<double>> gradients;
  trainer.lossAndGradients(samples, &gradients);
  constexpr double kStep = 1e-6;
  for (const auto& [layer, numbers] : gradients) {
    if ((layer.rfind(prefix, 0) == 0) == others) continue;
    std::size_t largest = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (std::abs(numbers[i]) > std::abs(numbers[largest])) largest = i;
    }
    for (const std::size_t number : {largest, numbers.size() / 2, numbers.size() - 1}) {
      trainer.nudge(layer, number, kStep);
      const double above = trainer.lossAndGradients(samples, nullptr);
      trainer.nudge(layer, number, -2.0 * kStep);
      const double below = trainer.lossAndGradients(samples, nullptr);
      trainer.nudge(layer, number, kStep);
      const double slope = (above - below) / (2.0 * kStep);
      EXPECT_NEAR(slope, numbers[number], 1e-4 * std::abs(numbers[number]) + 1e-6) << layer;
    }
  }
}

TEST_P(Heads, GradientsMatchFiniteDifferences) {
  const auto samples = samplesOf(features(), 3);
  TrainingOptions options = quickTraining();
  // The weights of the anchors' heading errors are detached, so finite differences would not agree.
  if (GetParam() != EgoHead::kRegression) options.heading_weight = 0.0;
  checkGradients(trainerOf(options, 3, features()), samples, "candidate_", false);
  // The layers of the ego position are trained only by its loss.
  options.offset_weight = 0.0;
  options.selection_weight = 0.0;
  checkGradients(trainerOf(options, 3, features()), samples, "candidate_", true);
}

TEST_P(Heads, OverfitAFewMoments) {
  const auto samples = samplesOf(features(), 4);
  TrainingOptions options = quickTraining();
  options.epochs = 500;
  options.dropout = 0.0;
  options.context_dropout = 0.0;
  options.weight_decay = 0.0;
  options.mirrored_share = 0.0;
  options.learning_rate = 0.01;
  PatternTrainer trainer = trainerOf(options, 1, features());
  const double before = trainer.losses(samples, all(samples)).total;
  for (int i = 0; i < options.epochs; ++i) trainer.trainEpoch(samples, all(samples));
  const TrainingLosses after = trainer.losses(samples, all(samples));
  EXPECT_LT(after.total, before - 2.0);
  EXPECT_LT(after.selection, 0.1);
  EXPECT_LT(after.offset, 1e-2);
  EXPECT_LT(after.heading, 1e-2);
  const PatternNetwork network(trainer.weights());
  const Eigen::VectorXf scene = network.encode(samples[1].features);
  const TimedSample& time = samples[1].times.back();
  const Pose2 pose = medianPose(network.ego(
      network.withRequest(scene, requestFeatures(std::nullopt, time.tta)), time.anchors));
  if (GetParam() == EgoHead::kTargetPoints) return;  // several points are close to each other
  EXPECT_NEAR(pose.x, time.ego.x, 2.0);
  EXPECT_NEAR(pose.y, time.ego.y, 0.5);
}

TEST_P(Heads, InferenceReproducesTheTrainingLoss) {
  const auto samples = samplesOf(features(), 4);
  TrainingOptions options = quickTraining();
  options.heading_weight = options.offset_weight = options.selection_weight = 0.0;
  options.clip_weight = 1.0;
  PatternTrainer trainer = trainerOf(options, 2, features());
  const double loss = trainer.lossAndGradients(samples, nullptr);
  const PatternNetwork network(trainer.currentWeights());
  double sum = 0.0;
  for (const TrainingSample& sample : samples) {
    SceneFeatures seen = sample.features;
    if (sample.attack) {  // as in the training on clips
      for (Eigen::Index row = 8; row < seen.agent_mask.size(); ++row) {
        if (row % 8 != 7) seen.agent_mask[row] = 0.0F;
      }
    }
    const Eigen::VectorXf scene = network.encode(seen);
    for (const TimedSample& time : sample.times) {
      const bool impact = sample.attack && &time == &sample.times.back();
      const auto type = impact ? std::optional(sample.attack->type) : std::nullopt;
      const auto components =
          network.ego(network.withRequest(scene, requestFeatures(type, time.tta)), time.anchors);
      sum -= logDensity(components, time.ego.position());
    }
  }
  EXPECT_NEAR(sum / 8.0, loss, 1e-4 * std::abs(loss) + 1e-5);
}

/// Training on `samples`, with the trainer replaced by one from its saved state after `stop`
/// epochs.
PatternWeights trainedWithAStop(const std::vector<TrainingSample>& samples, int stop) {
  const std::string path = (fs::path(testing::TempDir()) / "trainer_state.pt").string();
  TrainingOptions options = quickTraining();
  options.batch = 2;
  PatternTrainer first = trainerOf(options);
  for (int i = 0; i < stop; ++i) first.trainEpoch(samples, all(samples));
  writeText(path, first.state());
  PatternTrainer second = trainerOf(options);
  second.load(path);
  fs::remove(path);
  EXPECT_EQ(second.epochsDone(), stop);
  for (int i = stop; i < options.epochs; ++i) second.trainEpoch(samples, all(samples));
  return second.weights();
}

void expectTheSameBits(const PatternWeights& a, const PatternWeights& b) {
  for (const auto& [name, layer] : a.layers) {
    EXPECT_EQ(layer.matrix, b.layers.at(name).matrix) << name;
    EXPECT_EQ(layer.bias, b.layers.at(name).bias) << name;
  }
}

TEST(PatternTrainer, ResumesToTheSameBits) {
  const auto often = samplesOf(smallFeatures(), 6);
  auto once = often;
  for (std::size_t i = 1; i < once.size(); ++i) once[i].attack.reset();
  auto never = once;
  never[0].attack.reset();
  for (const auto& samples : {often, once, never}) {
    const PatternWeights whole = trainedWithAStop(samples, 4);
    for (const int stop : {1, 2, 3}) expectTheSameBits(whole, trainedWithAStop(samples, stop));
  }
}

TEST(PatternTrainer, RejectsDamagedAndForeignStates) {
  const std::string path = (fs::path(testing::TempDir()) / "trainer_damaged.pt").string();
  writeText(path, trainerOf(quickTraining(), 1).state());
  PatternTrainer other = trainerOf(quickTraining(), 2);
  EXPECT_THROW(other.load(path), TrainingError);
  fs::resize_file(path, fs::file_size(path) / 2);
  PatternTrainer same = trainerOf(quickTraining(), 1);
  const std::string complaint = errorOf<std::runtime_error>([&] { same.load(path); });
  EXPECT_NE(complaint, "");
  EXPECT_EQ(complaint.find('\n'), std::string::npos);
  EXPECT_THROW(same.load(path + ".not"), TrainingError);
  fs::remove(path);
}

}  // namespace
}  // namespace forge
