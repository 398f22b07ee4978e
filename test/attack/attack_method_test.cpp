#include "collision_forge/attack/attack_method.h"

#include <gtest/gtest.h>

#include "attack/test_scenes.h"

namespace forge {
namespace {

/// Answers with the report that it is given, and tells whether it was shown what came.
class Told : public AttackMethod {
 public:
  explicit Told(CollisionReport report = {}) : report_(std::move(report)) {}

  Realization answer(const Moment& moment, const CollisionRequest&) const override {
    Realization answer;
    answer.report = report_;
    answer.trajectory.attacker_id = moment.recorded ? "knows" : "guesses";
    return answer;
  }

 private:
  CollisionReport report_;
};

CollisionReport verifiedReport() {
  CollisionReport report;
  report.contact = report.type_kept = report.on_time = report.limits_kept = true;
  return report;
}

Moment moment() {
  const auto map = twoLaneRoad();
  Future recorded;
  recorded.ego = futureTrack(kEgoId, kEgoSize, {}, 10.0);
  return {snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0), {}, map), recorded,
          std::make_shared<const LaneIndex>(map)};
}

CollisionRequest requestIn(Mode mode) {
  CollisionRequest request = requestFor();
  request.mode = mode;
  return request;
}

TEST(AttackMethod, IsShownWhatCameInReplayModeAlone) {
  EXPECT_EQ(attempt(Told(), moment(), requestIn(Mode::kHistory)).trajectory.attacker_id, "guesses");
  EXPECT_EQ(attempt(Told(), moment(), requestIn(Mode::kReplay)).trajectory.attacker_id, "knows");
}

TEST(GenerateCollision, LetsVerifiedAttacksPassAlone) {
  const PredictionOptions options = shippedOptions().prediction;
  const CollisionRequest request = requestIn(Mode::kHistory);
  EXPECT_EQ(generateCollision(Told(verifiedReport()), moment(), request, options).status.code,
            StatusCode::kOk);
  CollisionReport late = verifiedReport();
  late.on_time = false;
  const Realization refused = generateCollision(Told(late), moment(), request, options);
  EXPECT_EQ(refused.status.code, StatusCode::kNoAttackWithinLimits);
  EXPECT_NE(refused.status.message.find("wrong time"), std::string::npos) << refused.status.message;
  EXPECT_TRUE(refused.trajectory.attacker_id.empty());
}

TEST(GenerateCollision, RefusesWithoutAskingTheMethod) {
  const PredictionOptions options = shippedOptions().prediction;
  const Told method(verifiedReport());
  CollisionRequest request = requestIn(Mode::kHistory);
  request.tta = 100.0;
  EXPECT_EQ(generateCollision(method, moment(), request, options).status.code,
            StatusCode::kTtaOutOfRange);
  Moment running = moment();
  running.recorded.reset();
  EXPECT_EQ(generateCollision(method, running, requestIn(Mode::kReplay), options).status.code,
            StatusCode::kNoRecording);
}

}  // namespace
}  // namespace forge
