#include "collision_forge/attack/network/network_pattern_predictor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "attack/network/sample_network.h"
#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/network/predicted_scene.h"

namespace forge {
namespace {

CollisionRequest crossing() {
  CollisionRequest request = requestFor(CollisionType::kJunctionCrossing);
  request.crash.rules = TypeRules::kAngle;  // every agent is a candidate
  return request;
}

std::shared_ptr<const PatternNetwork> networkOf(std::uint64_t seed) {
  return std::make_shared<const PatternNetwork>(randomWeights(seed));
}

PatternPrediction predicted(const std::shared_ptr<const PatternNetwork>& network,
                            const Future* recorded = nullptr,
                            std::optional<CollisionType> known_type = std::nullopt) {
  const Snapshot snapshot = junctionSnapshot();
  const LaneIndex lanes = lanesOf(snapshot);
  return NetworkPatternPredictor(shippedOptions(), {nullptr, network, known_type})
      .predict(snapshot, lanes, crossing(), recorded);
}

std::vector<std::string> attackersOf(const PatternPrediction& prediction) {
  std::vector<std::string> ids;
  for (const CollisionPattern& pattern : prediction.patterns) {
    if (ids.empty() || ids.back() != pattern.attacker_id) ids.push_back(pattern.attacker_id);
  }
  return ids;
}

TEST(NetworkPatternPredictor, UsesTheTypeForTheEgoInKnownScenesOnly) {
  const auto chosen = networkOf(0);
  const Snapshot snapshot = junctionSnapshot();
  const LaneIndex lanes = lanesOf(snapshot);
  const PredictedScene scene(*chosen, snapshot, lanes, 4.0);
  const Pose2 with_type = medianPose(scene.egoAfter(4.0, CollisionType::kJunctionCrossing));
  const Pose2 without_type = medianPose(scene.egoAfter(4.0, std::nullopt));
  ASSERT_GT((with_type.position() - without_type.position()).norm(), 1e-3);
  const auto placeOf = [&](std::optional<CollisionType> known_type) {
    const CollisionPattern pattern = predicted(chosen, nullptr, known_type).patterns[0];
    return relativeTo(snapshot.ego.states.back().pose, pattern.ego.center);
  };
  EXPECT_NEAR(placeOf(CollisionType::kJunctionCrossing).x, with_type.x, 1e-6);
  EXPECT_NEAR(placeOf(std::nullopt).x, without_type.x, 1e-6);
}

TEST(NetworkPatternPredictor, ReplacesTheNearestPatternOfEachAttacker) {
  const PatternPrediction without = predicted(nullptr);
  const PatternPrediction with = predicted(networkOf(0));
  ASSERT_EQ(with.patterns.size(), without.patterns.size());
  EXPECT_EQ(attackersOf(with).size(), 3U);
  const auto ofAttacker = [](const PatternPrediction& prediction, const std::string& id) {
    std::vector<CollisionPattern> patterns;
    for (const CollisionPattern& pattern : prediction.patterns) {
      if (pattern.attacker_id == id) patterns.push_back(pattern);
    }
    return patterns;
  };
  for (const std::string& id : attackersOf(with)) {
    const auto before = ofAttacker(without, id);
    const auto after = ofAttacker(with, id);
    double least = 1e9;
    std::size_t replaced = before.size();
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double apart =
          cornerMiss(missBetween(after[0].attacker_offset, before[i].attacker_offset), kCarSize);
      if (apart < least) replaced = i;
      least = std::min(least, apart);
    }
    EXPECT_GT(least, 0.0) << "the first is the network's";
    for (std::size_t i = 0, rest = 1; i < before.size(); ++i) {
      if (i == replaced) continue;
      EXPECT_EQ(after[rest++].attacker_offset.x, before[i].attacker_offset.x);
    }
  }
}

TEST(NetworkPatternPredictor, RanksByTheNetwork) {
  const auto chosen = networkOf(0);
  const Snapshot snapshot = junctionSnapshot();
  const LaneIndex lanes = lanesOf(snapshot);
  const PredictedScene scene(*chosen, snapshot, lanes, 4.0);
  const Pose2 ego = medianPose(scene.egoAfter(4.0, std::nullopt));
  std::vector<const Track*> vehicles;
  for (const Track& agent : snapshot.agents) vehicles.push_back(&agent);
  const auto answers = scene.judge(vehicles, ego, 4.0, CollisionType::kJunctionCrossing);
  std::vector<std::size_t> order = {0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return answers[a].score > answers[b].score; });
  const PatternPrediction prediction = predicted(chosen);
  const auto ids = attackersOf(prediction);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(ids[i], vehicles[order[i]]->id);
  EXPECT_NEAR(prediction.patterns[0].attacker_offset.x, answers[order[0]].offset.x, 1e-9);
  const Pose2 place = compose(snapshot.ego.states.back().pose, ego);
  EXPECT_NEAR(prediction.patterns[0].ego.center.x, place.x, 1e-9);
}

TEST(NetworkPatternPredictor, TakesTheRecordedEgoInReplay) {
  const Snapshot snapshot = junctionSnapshot();
  Future recorded;
  recorded.ego = futureTrack(kEgoId, kEgoSize, {-30.0, -1.75, 0.0}, 5.0);
  const PatternPrediction prediction = predicted(networkOf(0), &recorded);
  ASSERT_FALSE(prediction.patterns.empty());
  EXPECT_NEAR(prediction.patterns[0].ego.center.x, -10.0, 1e-9);
}

TEST(NetworkPatternPredictor, RejectsARequestWithoutCandidates) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.agents.clear();
  const LaneIndex lanes = lanesOf(snapshot);
  const PatternPrediction prediction =
      NetworkPatternPredictor(shippedOptions(), {nullptr, networkOf(0), {}})
          .predict(snapshot, lanes, crossing(), nullptr);
  EXPECT_EQ(prediction.status.code, StatusCode::kNoCandidate);
}

}  // namespace
}  // namespace forge
