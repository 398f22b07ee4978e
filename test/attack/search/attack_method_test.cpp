#include "collision_forge/attack/search/generate_collision.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// Returns the given report, and records whether `moment.recorded` was set.
class Told : public AttackMethod {
 public:
  explicit Told(CollisionReport report = {}) : report_(std::move(report)) {}

  std::vector<AgentState> past;

  Attack answer(const Moment& moment, const CollisionRequest&) const override {
    Attack answer;
    answer.report = report_;
    answer.trajectory.attacker_id = moment.recorded ? "knows" : "guesses";
    answer.trajectory.past = past;
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

TEST(AttackMethod, SeesTheRecordedFutureInReplayModeOnly) {
  EXPECT_EQ(attempt(Told(), moment(), requestIn(Mode::kHistory)).trajectory.attacker_id, "guesses");
  EXPECT_EQ(attempt(Told(), moment(), requestIn(Mode::kReplay)).trajectory.attacker_id, "knows");
}

TEST(GenerateCollision, ReturnsVerifiedAttacksOnly) {
  const PredictionOptions options = shippedOptions().prediction;
  const CollisionRequest request = requestIn(Mode::kHistory);
  EXPECT_EQ(generateCollision(Told(verifiedReport()), moment(), request, options).status.code,
            StatusCode::kOk);
  CollisionReport late = verifiedReport();
  late.on_time = false;
  const Attack refused = generateCollision(Told(late), moment(), request, options);
  EXPECT_EQ(refused.status.code, StatusCode::kNoAttackWithinLimits);
  EXPECT_NE(refused.status.message.find("wrong time"), std::string::npos) << refused.status.message;
  EXPECT_TRUE(refused.trajectory.attacker_id.empty());
}

/// Finds attacks of some types, each with a confidence.
class Finds : public AttackMethod {
 public:
  explicit Finds(std::map<CollisionType, double> confidences)
      : confidences_(std::move(confidences)) {}

  Attack answer(const Moment&, const CollisionRequest& request) const override {
    EXPECT_NE(request.type, CollisionType::kAny);
    const auto found = confidences_.find(request.type);
    if (found == confidences_.end()) return rejection({StatusCode::kNoCandidate, "none"});
    Attack answer;
    answer.report = verifiedReport();
    answer.report.confidence = found->second;
    return answer;
  }

 private:
  std::map<CollisionType, double> confidences_;
};

TEST(GenerateCollision, AnyTypeIsTheTypeWithTheHighestConfidence) {
  const PredictionOptions options = shippedOptions().prediction;
  CollisionRequest request = requestFor(CollisionType::kAny);
  for (request.seed = 0; request.seed < 20; ++request.seed) {
    const Finds method({{CollisionType::kRearEnd, 0.4}, {CollisionType::kAngleSameDirection, 0.6}});
    const Attack found = generateCollision(method, moment(), request, options);
    ASSERT_EQ(found.status.code, StatusCode::kOk);
    EXPECT_EQ(found.pattern.type, CollisionType::kAngleSameDirection);
    EXPECT_EQ(withTypeOf(request, found).type, CollisionType::kAngleSameDirection);
  }
}

TEST(GenerateCollision, AmongEqualTypesTheSeedDecides) {
  const PredictionOptions options = shippedOptions().prediction;
  CollisionRequest request = requestFor(CollisionType::kAny);
  std::set<CollisionType> found;
  for (request.seed = 0; request.seed < 20; ++request.seed) {
    const Finds method({{CollisionType::kRearEnd, 1.0}, {CollisionType::kLtap, 1.0}});
    found.insert(generateCollision(method, moment(), request, options).pattern.type);
  }
  EXPECT_EQ(found, (std::set{CollisionType::kRearEnd, CollisionType::kLtap}));
}

TEST(GenerateCollision, AnyTypeIsRejectedWithTheReasonsOfAllTypes) {
  const PredictionOptions options = shippedOptions().prediction;
  CollisionRequest request = requestFor(CollisionType::kAny);
  const Status none = generateCollision(Finds({}), moment(), request, options).status;
  EXPECT_EQ(none.code, StatusCode::kNoCandidate);
  for (const CollisionType type : kAllCollisionTypes) {
    EXPECT_NE(none.message.find(std::string(toString(type)) + " NO_CANDIDATE"), std::string::npos)
        << none.message;
  }
  request.manoeuvre = Manoeuvre::kLeadBrakes;
  request.from_side = Side::kLeft;
  EXPECT_EQ(generateCollision(Finds({}), moment(), request, options).status.code,
            StatusCode::kInvalidInput)
      << "no type has both";
}

TEST(GenerateCollision, PlausibleAttacksNeedAMapWithLanes) {
  const PredictionOptions options = shippedOptions().prediction;
  Moment bare = moment();
  bare.lanes = std::make_shared<const LaneIndex>(emptyMap());
  CollisionRequest request = believableRequestFor(CollisionType::kRearEnd);
  const Status status = generateCollision(Told(verifiedReport()), bare, request, options).status;
  EXPECT_EQ(status.code, StatusCode::kRoadDoesNotAllow);
  EXPECT_NE(status.message.find("set believable = false, or convert the log with a map"),
            std::string::npos);
  request.crash.believable = false;
  EXPECT_EQ(generateCollision(Told(verifiedReport()), bare, request, options).status.code,
            StatusCode::kOk);
}

TEST(GenerateCollision, RejectsAttacksThatViolateTheControls) {
  const PredictionOptions options = shippedOptions().prediction;
  CollisionReport report = verifiedReport();
  report.manoeuvre = Manoeuvre::kLeadSlow;
  report.ego_side = Side::kFront;
  report.impact_speed = 5.0;
  report.overlap = 0.4;
  Told method(report);
  const CollisionRequest plain = requestIn(Mode::kHistory);
  const auto refusalOf = [&](const CollisionRequest& request) {
    const Status status = generateCollision(method, moment(), request, options).status;
    EXPECT_EQ(status.code, StatusCode::kNoAttackWithinLimits) << status.message;
    return status.message;
  };
  const auto passes = [&](const CollisionRequest& request) {
    return generateCollision(method, moment(), request, options).status.code == StatusCode::kOk;
  };
  CollisionRequest request = plain;
  request.manoeuvre = Manoeuvre::kLeadBrakes;
  EXPECT_NE(refusalOf(request).find("lead_slow"), std::string::npos);
  request.manoeuvre = Manoeuvre::kLeadSlow;
  EXPECT_TRUE(passes(request));
  request = plain;
  request.ego_side = Side::kRear;
  EXPECT_NE(refusalOf(request).find("front"), std::string::npos);
  request.ego_side = Side::kFront;
  EXPECT_TRUE(passes(request));
  request = plain;
  request.impact_speed = Range{5.1, 9.0};
  EXPECT_NE(refusalOf(request).find("too slowly"), std::string::npos);
  request.impact_speed = Range{1.0, 4.9};
  EXPECT_NE(refusalOf(request).find("too fast"), std::string::npos);
  request.impact_speed = Range{5.0, 5.0};
  EXPECT_TRUE(passes(request));
  request.overlap = Range{0.41, 1.0};
  EXPECT_NE(refusalOf(request).find("too little"), std::string::npos);
  request.overlap = Range{0.0, 0.39};
  EXPECT_NE(refusalOf(request).find("too much"), std::string::npos);
  request.overlap = Range{0.4, 0.4};
  EXPECT_TRUE(passes(request));
  request = plain;
  request.attacker_class = AgentClass::kTruck;
  EXPECT_NE(refusalOf(request).find("by a car"), std::string::npos);
  request = plain;
  request.choice = AttackerChoice::kNew;
  EXPECT_NE(refusalOf(request).find("recorded vehicle"), std::string::npos);
  method.past = {{}};
  EXPECT_TRUE(passes(request));
  request.choice = AttackerChoice::kExisting;
  EXPECT_NE(refusalOf(request).find("added vehicle"), std::string::npos);
}

TEST(GenerateCollision, SaysWhyAnAttackIsNotBelievable) {
  const PredictionOptions options = shippedOptions().prediction;
  CollisionReport report = verifiedReport();
  report.unbelievable = "drives against the lane direction for 9 % of its motion";
  CollisionRequest request = believableRequestFor(CollisionType::kRearEnd);
  const Attack refused = generateCollision(Told(report), moment(), request, options);
  EXPECT_EQ(refused.status.code, StatusCode::kNotBelievable);
  EXPECT_NE(refused.status.message.find("9 %"), std::string::npos) << refused.status.message;
  request.crash.believable = false;
  EXPECT_EQ(generateCollision(Told(report), moment(), request, options).status.code,
            StatusCode::kOk);
}

TEST(GenerateCollision, RejectsWithoutCallingTheMethod) {
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
