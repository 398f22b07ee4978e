#include "collision_forge/study/dataset/attempts.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "base/scene/shipped_limits.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

SceneRequest sampleRequest(CollisionType type, double tta) {
  SceneRequest asked;
  asked.scene = "scene-0001";
  asked.now = 10.0;
  asked.request.type = type;
  asked.request.tta = tta;
  return asked;
}

/// A line of a clip request without attack.
std::string lineOf(const SceneRequest& asked) {
  Scenario scenario;
  scenario.asked = asked;
  scenario.ego = {{4.0, 1.7}, 1.3};
  scenario.answer.status = {StatusCode::kNoCandidate, "nobody"};
  return scenarioLine(scenario);
}

Attempt validAttempt(CollisionType type, double tta) {
  Attempt attempt;
  attempt.asked = sampleRequest(type, tta);
  attempt.valid = true;
  return attempt;
}

TEST(Attempt, LengthCountsTheFramesUntilImpact) {
  // Seven frames of 0.5 s before t0, and one for each half second after it.
  EXPECT_EQ(validAttempt(CollisionType::kRearEnd, 2.0).length(), 7 + 4);
  EXPECT_EQ(validAttempt(CollisionType::kRearEnd, 4.5).length(), 7 + 9);
}

TEST(ReadAttempt, ReadsTheRequestAndThatNoClipWasFound) {
  const SceneRequest asked = sampleRequest(CollisionType::kLtap, 3.0);
  const Attempt attempt = readAttempt("line 1", lineOf(asked), asked, shippedLimits());
  EXPECT_EQ(attempt.asked.scene, "scene-0001");
  EXPECT_EQ(attempt.asked.request.type, CollisionType::kLtap);
  EXPECT_FALSE(attempt.valid);
}

TEST(ReadAttempt, RejectsALineOfAnotherRequest) {
  const std::string line = lineOf(sampleRequest(CollisionType::kLtap, 3.0));
  try {
    readAttempt("file: line 3", line, sampleRequest(CollisionType::kLtap, 3.5), shippedLimits());
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("file: line 3: belongs to the request"));
  }
}

TEST(ChooseClips, ReturnsIndicesIntoAllAttempts) {
  std::vector<Attempt> attempts(5);
  attempts[1] = validAttempt(CollisionType::kLtap, 3.0);
  attempts[4] = validAttempt(CollisionType::kLtap, 3.0);
  BalanceOptions options;
  options.max_tta_ratio = 2.0;
  EXPECT_THAT(chooseClips(attempts, options, 0), ElementsAre(1, 4));
}

}  // namespace
}  // namespace forge
