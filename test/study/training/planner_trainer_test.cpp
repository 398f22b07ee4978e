#include "collision_forge/study/training/planner_trainer.h"

#include <gtest/gtest.h>

#include "base/files/file_size_limit.h"
#include "collision_forge/planner_test/planners/planner_contract.h"
#include "collision_forge/planner_test/planners/planner_worker.h"
#include "io/logs/nuscenes_fixture.h"
#include "planner_test/planners/planner_scenes.h"
#include "study/settings/shipped_study.h"

namespace forge {
namespace {

constexpr double kAcceleration = 0.5;  // m/s2

/// A sample that starts at this speed on a straight route and accelerates; some recordings end
/// early.
PlannerSample acceleratingSample(double speed, std::size_t known) {
  PlannerSample sample;
  sample.known = known;
  sample.ego_history.assign(kContractInputs[kEgoHistory].count(), 0.0f);
  const std::size_t now = (kContractFrames - 1) * kContractEgoNumbers;
  sample.ego_history[now + 3] = static_cast<float>(speed);
  sample.ego_history[now + 5] = 1.0f;
  sample.route.assign(kContractInputs[kRoute].count(), 0.0f);
  for (std::size_t i = 0; i < kContractRoutePoints; ++i) {
    sample.route[3 * i] = 2.0f * static_cast<float>(i);
  }
  sample.poses.assign(kContractOutput.count(), 0.0f);
  for (std::size_t i = 0; i < known; ++i) {
    const double time = kContractPoseStep * static_cast<double>(i + 1);
    sample.poses[3 * i] = static_cast<float>(speed * time + 0.5 * kAcceleration * time * time);
  }
  return sample;
}

struct Learning {
  std::vector<PlannerSample> samples;
  std::vector<std::size_t> all;
  PlannerTrainingOptions options;
};

Learning smallLearning() {
  Learning learning;
  for (std::size_t i = 0; i < 64; ++i) {
    learning.samples.push_back(
        acceleratingSample(0.2 * static_cast<double>(i), i % 2 == 0 ? kContractPoses : 30));
    learning.all.push_back(i);
  }
  learning.options = shippedStudy().planner_training;
  learning.options.hidden = 16;
  learning.options.batch = 16;
  learning.options.epochs = 40;
  learning.options.learning_rate = 0.01;
  return learning;
}

TEST(DisplacementErrors, AreMeansOverThePosesUpToEachTime) {
  const Learning learning = smallLearning();
  const DisplacementErrors errors = constantVelocityErrors(learning.samples, learning.all);
  for (std::size_t i = 0; i < DisplacementErrors::kTimes.size(); ++i) {
    // The error of constant velocity is a t^2 / 2, averaged over t = 0.1, 0.2, ... up to the time.
    const int poses = static_cast<int>(std::lround(DisplacementErrors::kTimes[i] / 0.1));
    double sum = 0.0;
    for (int k = 1; k <= poses; ++k) sum += 0.5 * kAcceleration * 0.01 * k * k;
    EXPECT_NEAR(errors.means[i], sum / poses, 1e-4);
    EXPECT_EQ(errors.moments[i], poses <= 30 ? 64u : 32u);
  }
}

TEST(PlannerTrainer, BeatsConstantVelocity) {
  const Learning learning = smallLearning();
  PlannerTrainer trainer(learning.options, 1, 0);
  const double first = trainer.trainEpoch(learning.samples, learning.all);
  double last = first;
  for (int i = 1; i < learning.options.epochs; ++i) {
    last = trainer.trainEpoch(learning.samples, learning.all);
  }
  EXPECT_LT(last, 0.5 * first);
  EXPECT_LT(trainer.errors(learning.samples, learning.all).means.back(),
            0.5 * constantVelocityErrors(learning.samples, learning.all).means.back());
}

TEST(PlannerTrainer, SavesATorchScriptFileOfTheContract) {
  const TemporaryFolder folder;
  const Learning learning = smallLearning();
  PlannerTrainer trainer(learning.options, 1, 0);
  trainer.trainEpoch(learning.samples, learning.all);
  TorchscriptFileOptions options = shippedStudy().planners.torchscript;
  options.file = folder.path() + "/planner.pt";
  options.device = "cpu";
  trainer.save(options.file, {"scene-0001"});
  const PlannerSample& sample = learning.samples.front();
  std::vector<float> inputs(kContractNumbers);
  std::copy(sample.ego_history.begin(), sample.ego_history.end(), inputs.begin());
  std::copy(sample.route.begin(), sample.route.end(),
            inputs.begin() + static_cast<long>(contractStart(kRoute)));
  PlannerWorker worker(options);
  worker.begin();
  const std::vector<float> poses = worker.plan(inputs);
  double error = 0.0;
  for (std::size_t i = 0; i < kContractPoses; ++i) {
    error += std::hypot(poses[3 * i] - sample.poses[3 * i], poses[3 * i + 1]);
  }
  EXPECT_NEAR(error / kContractPoses, trainer.errors(learning.samples, {0}).means.back(), 1e-3);
}

}  // namespace
}  // namespace forge
