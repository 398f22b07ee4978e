#include "collision_forge/attack/search/driven_answer.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

Moment twoCars() {
  const auto map = twoLaneRoad();
  return {snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                     {pastTrack("behind", kCarSize, {-30.0, 0.0, 0.0}, 10.0),
                      pastTrack("ahead", kCarSize, {30.0, 0.0, 0.0}, 10.0)},
                     map),
          std::nullopt, std::make_shared<const LaneIndex>(map)};
}

TEST(TrackOf, FindsTheAgentOrSaysWhoIsMissing) {
  const Moment moment = twoCars();
  EXPECT_EQ(trackOf(moment.snapshot, "ahead").id, "ahead");
  EXPECT_THROW(trackOf(moment.snapshot, "nobody"), std::invalid_argument);
}

TEST(GoStraightOn, KeepsSpeedAndHeading) {
  AttackerTrajectory trajectory{"a", AgentClass::kCar, kCarSize, {}};
  trajectory.points.push_back({1.0, {0.0, 0.0, M_PI_2}, 4.0, 2.0, 0.1});
  goStraightOn(trajectory, 1.0, 0.1);
  ASSERT_EQ(trajectory.points.size(), 11u);
  EXPECT_NEAR(trajectory.points.back().time, 2.0, 1e-9);
  EXPECT_NEAR(trajectory.points.back().pose.y, 4.0, 1e-9);
  EXPECT_EQ(trajectory.points.back().acceleration, 0.0);
}

TEST(BestOfCandidates, TakesVerifiedBeforeTouchingBeforeAny) {
  const auto bestOf = [](bool behind_touches) {
    const PredictionOptions options = shippedOptions().prediction;
    return bestOfCandidates(twoCars(), requestFor(), options,
                            [&](const std::string& id) {
                              Realization answer;
                              answer.trajectory.attacker_id = id;
                              answer.report.contact = id == (behind_touches ? "behind" : "ahead");
                              return answer;
                            })
        .trajectory.attacker_id;
  };
  EXPECT_EQ(bestOf(true), "behind");
  EXPECT_EQ(bestOf(false), "ahead");
}

TEST(BestOfCandidates, WithoutAnybodyIsRefused) {
  Moment moment = twoCars();
  moment.snapshot.agents.clear();
  const Realization answer = bestOfCandidates(moment, requestFor(), shippedOptions().prediction,
                                              [](const std::string&) { return Realization{}; });
  EXPECT_EQ(answer.status.code, StatusCode::kNoCandidate);
}

}  // namespace
}  // namespace forge
