#include "collision_forge/planner_test/trials/request_cases.h"

#include <gtest/gtest.h>

#include <set>

#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

class RequestCasesTest : public testing::Test {
 protected:
  RequestCases casesOf(std::size_t tries, std::uint64_t seed = 0) {
    return {scenes_,
            {"search", builtInMethods(), config_.attack, {}},
            config_,
            {config_.requests, tries, seed}};
  }

  Config config_ = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  SceneSource scenes_{
      {COLLISION_FORGE_SOURCE_DIR "/data/embedded", "v1.0-embedded"}, {"scene-0001"}, config_, 1};
};

TEST_F(RequestCasesTest, DrawsDifferentRequestsOfEveryKind) {
  const RequestCases cases = casesOf(60);
  ASSERT_EQ(cases.names().size(), 60u);
  EXPECT_EQ(std::set<std::string>(cases.names().begin(), cases.names().end()).size(), 60u);
  std::set<CollisionType> types;
  std::set<AttackerChoice> choices;
  std::set<double> ttas;
  for (std::size_t i = 0; i < 60; ++i) {
    types.insert(cases.request(i).type);
    choices.insert(cases.request(i).choice);
    ttas.insert(cases.request(i).tta);
    EXPECT_TRUE(cases.request(i).manoeuvre);
  }
  EXPECT_GT(types.size(), 2u);
  EXPECT_EQ(choices.size(), 2u);
  EXPECT_GT(ttas.size(), 2u);
}

TEST_F(RequestCasesTest, TheSameSeedDrawsTheSame) {
  EXPECT_EQ(casesOf(20).names(), casesOf(20).names());
  EXPECT_EQ(casesOf(20).fingerprint(), casesOf(20).fingerprint());
  EXPECT_NE(casesOf(20).names(), casesOf(20, 1).names());
  const auto few = casesOf(5).names();
  const auto more = casesOf(20).names();
  EXPECT_TRUE(std::equal(few.begin(), few.end(), more.begin())) << "more tries begin with these";
}

TEST_F(RequestCasesTest, ThereAreNoMoreThanThereAre) {
  config_.requests.types = {CollisionType::kRearEnd};
  config_.requests.ttas = {2.0};
  config_.requests.stride = 5.0;
  const RequestCases cases = casesOf(100000);
  EXPECT_GT(cases.names().size(), 0u);
  EXPECT_LT(cases.names().size(), 100u);
  config_.requests.min_ego_speed = 1000.0;
  EXPECT_THROW(casesOf(10), std::runtime_error);
}

TEST_F(RequestCasesTest, ACaseIsTheAnswerAsItSetsOut) {
  config_.requests.types = {CollisionType::kRearEnd};
  const RequestCases cases = casesOf(10);
  int answered = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    const PlannerCase one = cases.at(i);
    EXPECT_EQ(one.name, cases.names()[i]);
    EXPECT_EQ(one.source, "until_hit");
    if (one.status.code != StatusCode::kOk) continue;
    ++answered;
    const Scenario scenario = cases.scenario(i);
    EXPECT_EQ(one.scenario.attacker.points.size(), scenario.answer.trajectory.points.size());
    EXPECT_EQ(scenario.asked.request.mode, Mode::kHistory);
  }
  EXPECT_GT(answered, 0);
}

}  // namespace
}  // namespace forge
