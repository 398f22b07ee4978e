#include "collision_forge/ros/messages/possible_collisions.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace forge {
namespace {

using collision_forge::CollisionAnswer;
using collision_forge::PossibleCollision;
using Message = collision_forge::CollisionRequest;

const std::vector<double> kUsual = {2.0, 4.0};  // s

std::vector<std::pair<std::string, double>> askedFor(const Message& request,
                                                     const std::vector<std::string>& types,
                                                     const std::vector<double>& ttas) {
  std::vector<std::pair<std::string, double>> asked;
  const auto requests = requestsForEach(request, types, ttas, kUsual, {});
  for (const CollisionRequest& one : std::get<std::vector<CollisionRequest>>(requests)) {
    EXPECT_EQ(one.seed, request.seed);
    asked.emplace_back(toString(one.type), one.tta);
  }
  return asked;
}

Status refusalOf(const Message& request, const std::vector<std::string>& types) {
  return std::get<Status>(requestsForEach(request, types, {}, kUsual, {}));
}

TEST(RequestsForEach, AreOrderedByTypeThenTime) {
  Message request;
  request.seed = 7;
  const std::vector<std::pair<std::string, double>> expected = {
      {"ltap", 3.0}, {"ltap", 5.0}, {"rear_end", 3.0}, {"rear_end", 5.0}};
  EXPECT_EQ(askedFor(request, {"LTAP", "rear_end"}, {3.0, 5.0}), expected);
}

TEST(RequestsForEach, DefaultToAllTypesAndTheUsualTimes) {
  const auto asked = askedFor({}, {}, {});
  ASSERT_EQ(asked.size(), 10u);
  EXPECT_EQ(asked[0].second, 2.0);
  EXPECT_EQ(asked[1].second, 4.0);
  EXPECT_NE(asked[0].first, asked[9].first);
}

TEST(RequestsForEach, AManoeuvreImpliesItsType) {
  Message request;
  request.manoeuvre = "cut_in";
  const std::vector<std::pair<std::string, double>> expected = {{"lane_change", 2.0},
                                                                {"lane_change", 4.0}};
  EXPECT_EQ(askedFor(request, {}, {}), expected);
}

TEST(RequestsForEach, RejectContradictoryRequests) {
  Message typed;
  typed.collision_type = "ltap";
  EXPECT_EQ(refusalOf(typed, {}).code, StatusCode::kInvalidInput);
  Message timed;
  timed.tta = 4.0;
  EXPECT_EQ(refusalOf(timed, {}).code, StatusCode::kInvalidInput);
  Message odd;
  odd.ego_side = "roof";
  EXPECT_EQ(refusalOf(odd, {}).code, StatusCode::kInvalidInput);
  const Status unknown = refusalOf({}, {"ltap", "sideswipe"});
  EXPECT_EQ(unknown.code, StatusCode::kUnknownType);
  EXPECT_NE(unknown.message.find("\"sideswipe\""), std::string::npos);
}

collision_forge::Attack attackOf(const std::string& id, double confidence) {
  collision_forge::Attack attack;
  attack.header.stamp = ros::Time(100.0);
  attack.trajectory.attacker_id = id;
  attack.report.confidence = confidence;
  attack.report.manoeuvre = "cut_in";
  attack.report.contact_time = ros::Time(103.75);
  attack.report.impact_speed = 6.5;
  return attack;
}

CollisionAnswer answerOf(StatusCode code) {
  CollisionAnswer answer;
  answer.collision_type = "lane_change";
  answer.tta = 4.0;
  answer.code = static_cast<std::uint8_t>(code);
  answer.message = toString(code);
  return answer;
}

TEST(ListPossible, SummarisesEveryAttackByDescendingConfidence) {
  CollisionAnswer answer = answerOf(StatusCode::kOk);
  answer.attack = attackOf("a", 0.5);
  answer.alternatives = {attackOf("b", 0.9), attackOf("c", 0.1)};
  std::vector<PossibleCollision> found;
  EXPECT_EQ(listPossible({answer}, found).code, StatusCode::kOk);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].attacker_id, "b");
  EXPECT_EQ(found[1].attacker_id, "a");
  EXPECT_EQ(found[2].attacker_id, "c");
  EXPECT_EQ(found[1].collision_type, "lane_change");
  EXPECT_EQ(found[1].tta, 4.0);
  EXPECT_EQ(found[0].alternative, 2u);
  EXPECT_EQ(found[1].alternative, 1u);
  EXPECT_EQ(found[1].attacker_class, "car");
  EXPECT_EQ(found[1].manoeuvre, "cut_in");
  EXPECT_NEAR(found[1].contact_after, 3.75, 1e-6);
  EXPECT_EQ(found[1].impact_speed, 6.5);
}

TEST(ListPossible, SkipsFailuresOfTheSceneAndReturnsFailuresOfTheRequest) {
  CollisionAnswer possible = answerOf(StatusCode::kOk);
  possible.attack = attackOf("a", 0.5);
  std::vector<PossibleCollision> found;
  EXPECT_EQ(
      listPossible({answerOf(StatusCode::kRoadDoesNotAllow), answerOf(StatusCode::kNoCandidate),
                    possible, answerOf(StatusCode::kLowConfidence)},
                   found)
          .code,
      StatusCode::kOk);
  EXPECT_EQ(found.size(), 1u);
  const Status wrong = listPossible(
      {answerOf(StatusCode::kNoCandidate), answerOf(StatusCode::kUnknownAttacker)}, found);
  EXPECT_EQ(wrong.code, StatusCode::kUnknownAttacker);
  EXPECT_EQ(wrong.message, "UNKNOWN_ATTACKER");
}

TEST(ListPossible, NamesTheMostFrequentReasonIfNothingIsPossible) {
  std::vector<PossibleCollision> found;
  const Status status =
      listPossible({answerOf(StatusCode::kNoCandidate), answerOf(StatusCode::kBeyondRecording),
                    answerOf(StatusCode::kBeyondRecording)},
                   found);
  EXPECT_EQ(status.code, StatusCode::kOk);
  EXPECT_NE(status.message.find("2 of 3 requests: BEYOND_RECORDING"), std::string::npos)
      << status.message;
}

TEST(AnswerMessage, HasAnAttackOnlyWithCodeOk) {
  CollisionRequest request;
  request.type = CollisionType::kLaneChange;
  Attack answer;
  answer.trajectory.attacker_id = "a";
  const CollisionAnswer attack = toMessage(request, answer, "search", 100.0);
  EXPECT_EQ(attack.code, 0);
  EXPECT_EQ(attack.attack.method, "search");
  EXPECT_FALSE(attack.summary.empty());
  const CollisionAnswer refusal =
      toMessage(request, rejection({StatusCode::kNoCandidate, "nobody"}), "search", 100.0);
  EXPECT_EQ(refusal.collision_type, "lane_change");
  EXPECT_EQ(refusal.message, "nobody");
  EXPECT_TRUE(refusal.attack.trajectory.attacker_id.empty());
}

}  // namespace
}  // namespace forge
