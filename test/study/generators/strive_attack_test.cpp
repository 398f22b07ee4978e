#include "collision_forge/study/generators/strive_attack.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/study/generators/strive.h"
#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

/// The ego at 10 m/s, a car 18 m behind it on the same lane at 12 m/s: no contact within 4 s.
Moment farBehind() {
  const auto map = twoLaneRoad();
  return {snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                     {pastTrack("follower", kCarSize, {-18.0, 0.0, 0.0}, 12.0)}, map),
          std::nullopt, std::make_shared<const LaneIndex>(map)};
}

/// A model trained to continue the motion, and its methods.
class StriveAttacks : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const GeneratorOptions options = shippedConfig().generators;
    torch::manual_seed(0);
    model_ = makeStrive(options.c_strive, options.strive_optimised, options.traffic, torch::kCPU);
    const TrafficBatch batch = sampleBatch(sampleClips(options.traffic, 4), options.traffic);
    model_->network()->train();
    for (int step = 0; step < 150; ++step) model_->trainStep(batch);
    model_->network()->eval();
    for (torch::Tensor& parameter : model_->network()->parameters()) {
      parameter.set_requires_grad(false);
    }
  }
  static void TearDownTestSuite() { model_.reset(); }

  static Realization answer(const std::string& method, const Moment& moment) {
    CollisionRequest request = requestFor();
    request.attacker = "follower";
    return model_->method(method, shippedOptions())->answer(moment, request);
  }

  static std::shared_ptr<TrafficGenerator> model_;
};
std::shared_ptr<TrafficGenerator> StriveAttacks::model_;

TEST_F(StriveAttacks, FindsACrashThatTheModelAloneDoesNotPredict) {
  Moment moment = farBehind();
  moment.recorded = predictFuture(moment.snapshot, *moment.lanes, 8.0, shippedOptions().prediction);
  EXPECT_FALSE(answer("c_strive", moment).report.contact);
  const Realization found = answer("strive_optimised", moment);
  ASSERT_EQ(found.status.code, StatusCode::kOk);
  EXPECT_TRUE(found.report.contact);
  EXPECT_NEAR(found.report.contact_time, kNow + 4.0, 0.6);
  EXPECT_NEAR(found.report.relative_heading, 0.0, 0.3);
}

TEST(StriveAttack, NonFiniteValuesAreAnError) {
  GeneratorOptions options = shippedConfig().generators;
  options.strive_optimised.iterations = 1;
  const auto model =
      makeStrive(options.c_strive, options.strive_optimised, options.traffic, torch::kCPU);
  model->network()->eval();
  for (torch::Tensor& parameter : model->network()->parameters()) {
    parameter.set_requires_grad(false);
  }
  model->network()->parameters()[0].fill_(NAN);
  CollisionRequest request = requestFor();
  request.attacker = "follower";
  EXPECT_THROW(model->method("strive_optimised", shippedOptions())->answer(farBehind(), request),
               std::runtime_error);
}

}  // namespace
}  // namespace forge
