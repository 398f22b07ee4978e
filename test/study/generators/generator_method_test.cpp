#include "collision_forge/study/generators/generator_method.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

/// Predicts that all agents repeat their last step, rotated by a random angle.
class StraightGenerator : public TrafficGenerator {
 public:
  explicit StraightGenerator(double broken = 0.0)
      : TrafficGenerator(withoutLanes(shippedConfig().generators.traffic)), broken_(broken) {}

  torch::Tensor predict(const TrafficBatch& history, torch::Generator noise) const override {
    const long now = history.poses.size(2) - 1;
    const torch::Tensor pose = history.poses.select(2, now);
    const torch::Tensor step = pose - history.poses.select(2, now - 1);
    std::vector<torch::Tensor> poses;
    for (int frame = 1; frame <= 4; ++frame) poses.push_back(pose + frame * step);
    torch::Tensor driven = torch::stack(poses, 2) + broken_;
    driven.select(3, 1) += 0.1 * torch::rand({1}, noise);
    return driven;
  }
  std::vector<std::string> lossNames() const override { return {}; }
  std::vector<double> trainStep(const TrafficBatch&) override { return {}; }
  int epochs() const override { return 1; }
  int batchSize() const override { return 1; }
  std::shared_ptr<torch::nn::Module> network() const override { return nullptr; }
  void saveTraining(torch::serialize::OutputArchive&) const override {}
  void loadTraining(torch::serialize::InputArchive&) override {}

 private:
  double broken_;
};

/// The ego drives 10 m/s; one car approaches from behind, 5 m/s faster, with contact after 4 s.
Moment closingIn() {
  const double gap = 20.0 + 0.5 * (kEgoSize.length + kCarSize.length);
  const auto map = twoLaneRoad();
  return {snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                     {pastTrack("standing", kCarSize, {-30.0, 5.0, 0.0}, 0.0),
                      pastTrack("closing", kCarSize, {-gap, 0.0, 0.0}, 15.0)},
                     map),
          std::nullopt, std::make_shared<const LaneIndex>(map)};
}

GeneratorMethod methodOf(std::shared_ptr<const TrafficGenerator> generator) {
  return {std::move(generator), shippedOptions()};
}

TEST(GeneratorMethod, ChoosesTheCandidateWithContact) {
  const GeneratorMethod method = methodOf(std::make_shared<StraightGenerator>());
  const Attack answer = method.answer(closingIn(), requestFor());
  ASSERT_EQ(answer.status.code, StatusCode::kOk);
  EXPECT_EQ(answer.trajectory.attacker_id, "closing");
  EXPECT_TRUE(answer.report.contact);
  EXPECT_NEAR(answer.report.contact_time, kNow + 4.0, 0.05);
  EXPECT_NEAR(answer.trajectory.points[10].speed, 15.0, 0.2);
  EXPECT_NEAR(answer.trajectory.points[10].time, kNow + 1.0, 1e-9);
}

TEST(GeneratorMethod, ContinuesAfterTheRequestedTime) {
  const GeneratorMethod method = methodOf(std::make_shared<StraightGenerator>());
  CollisionRequest request = requestFor();
  request.attacker = "closing";
  request.tta = 5.5;  // 11 frames: three iterations, the last one is used partly
  const Attack answer = method.answer(closingIn(), request);
  EXPECT_NEAR(answer.trajectory.points.back().time, kNow + 5.5 + shippedOptions().search.tail,
              1e-9);
}

TEST(GeneratorMethod, RejectsTypesThatCollideLacks) {
  const GeneratorMethod method = methodOf(std::make_shared<StraightGenerator>());
  CollisionRequest request = requestFor();
  for (const CollisionType type : kAllCollisionTypes) {
    if (isPublished(type)) continue;
    request.type = type;
    const Attack answer = method.answer(closingIn(), request);
    EXPECT_EQ(answer.status.code, StatusCode::kInvalidInput);
    EXPECT_NE(answer.status.message.find(toString(type)), std::string::npos);
  }
}

TEST(GeneratorMethod, NonFiniteValuesAreAnError) {
  const GeneratorMethod method = methodOf(std::make_shared<StraightGenerator>(NAN));
  EXPECT_THROW(method.answer(closingIn(), requestFor()), std::runtime_error);
}

TEST(RollOut, AgentsWithoutFullHistoryDisappear) {
  const StraightGenerator generator;
  TrafficClip clip = sampleClips(generator.traffic(), 1).front();
  clip.agents.push_back(clip.agents[1]);
  clip.agents[2][2].reset();
  rollOut(generator, 0, clip);
  EXPECT_TRUE(clip.agents[1][12]);
  EXPECT_FALSE(clip.agents[2][12]);
  EXPECT_NEAR(clip.agents[1][12]->x, -20.0 + 5 * 4.5, 1e-3);
}

}  // namespace
}  // namespace forge
