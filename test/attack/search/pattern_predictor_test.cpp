#include "collision_forge/attack/search/pattern_predictor.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/search/placement.h"

namespace forge {
namespace {

constexpr double kTta = 4.0;

/// The ego drives east at 10 m/s from the origin.
PatternPrediction predict(CollisionType type, std::vector<Track> agents,
                          const std::optional<std::string>& attacker = std::nullopt,
                          const Future* recorded = nullptr,
                          const std::shared_ptr<LaneMap>& map = emptyMap()) {
  const Snapshot snapshot =
      snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0), std::move(agents), map);
  CollisionRequest request = requestFor();
  request.type = type;
  request.tta = kTta;
  request.attacker = attacker;
  return kinematicPredictor(shippedOptions()).predict(snapshot, LaneIndex(map), request, recorded);
}

std::vector<std::string> attackers(const PatternPrediction& prediction) {
  std::vector<std::string> ids;
  for (const CollisionPattern& pattern : prediction.patterns) ids.push_back(pattern.attacker_id);
  return ids;
}

TEST(KinematicPatternPredictor, PutsTheEgoWhereItIsPredictedAtImpact) {
  const auto prediction =
      predict(CollisionType::kRearEnd, {pastTrack("a", kCarSize, {-20.0, 0.0, 0.0}, 12.0)});
  ASSERT_EQ(prediction.status.code, StatusCode::kOk);
  ASSERT_EQ(prediction.patterns.size(), 2u);
  const CollisionPattern& pattern = prediction.patterns[0];
  EXPECT_EQ(pattern.type, CollisionType::kRearEnd);
  EXPECT_EQ(pattern.attacker_id, "a");
  EXPECT_EQ(pattern.time, kNow + kTta);
  const auto ego = stateAt(prediction.future.ego, kNow + kTta);
  ASSERT_TRUE(ego);
  EXPECT_NEAR(pattern.ego.center.x, ego->pose.x, 1e-9);
  EXPECT_NEAR(pattern.ego.center.x, 40.0, 3.0) << "four seconds at 10 m/s";
  EXPECT_EQ(pattern.ego.size.length, kEgoSize.length);
  EXPECT_GE(prediction.future.ego.states.back().time, kNow + kTta + 2.0 - 1e-9);
  EXPECT_EQ(prediction.future.agents.size(), 1u);
}

TEST(KinematicPatternPredictor, PlacesARearEndAttackerBehindAndFasterFirst) {
  const auto prediction =
      predict(CollisionType::kRearEnd, {pastTrack("a", kCarSize, {-20.0, 0.0, 0.0}, 12.0)});
  const auto& patterns = prediction.patterns;
  ASSERT_EQ(patterns.size(), 2u);
  const CollisionPattern& pattern = patterns[0];
  EXPECT_NEAR(pattern.attacker_offset.x, -0.5 * (kEgoSize.length + kCarSize.length), 1e-6);
  EXPECT_NEAR(pattern.attacker_offset.y, 0.0, 1e-9);
  EXPECT_EQ(pattern.attacker_offset.yaw, 0.0);
  const auto ego = stateAt(prediction.future.ego, kNow + kTta);
  ASSERT_TRUE(ego);
  EXPECT_NEAR(pattern.attacker_speed, ego->velocity.norm() + 4.0, 1e-6) << "closing at 4 m/s";
  EXPECT_NEAR(patterns[1].attacker_offset.x, 0.5 * (kEgoSize.length + kCarSize.length), 1e-6)
      << "the ego may run into it";
}

TEST(KinematicPatternPredictor, PlacesSideAttackersOnBothSidesHeadingTowardsTheEgo) {
  for (const CollisionType type : {CollisionType::kLaneChange, CollisionType::kJunctionCrossing}) {
    const auto prediction = predict(type, {pastTrack("a", kCarSize, {10.0, 30.0, -M_PI_2}, 1.0)});
    const double nominal = shippedCrash().types.at(type).nominal_heading;
    int left = 0;
    int right = 0;
    for (const CollisionPattern& pattern : prediction.patterns) {
      if (std::abs(pattern.attacker_offset.y) < 0.5) continue;  // in front
      const bool is_left = pattern.attacker_offset.y > 0.0;
      (is_left ? left : right) += 1;
      EXPECT_NEAR(pattern.attacker_offset.yaw, is_left ? -nominal : nominal, 1e-12);
      EXPECT_NEAR(pattern.attacker_speed, 3.0, 1e-9) << "min_impact_speed";
    }
    EXPECT_EQ(left, 1);
    EXPECT_EQ(right, 1);
  }
}

TEST(KinematicPatternPredictor, TurnsOncomingTrafficAcrossThePathFromItsSide) {
  const std::vector<Track> agents{pastTrack("a", kCarSize, {75.0, 3.5, M_PI}, 9.0)};
  const auto map = emptyMap();
  for (const DrivingSide side : {DrivingSide::kRight, DrivingSide::kLeft}) {
    map->driving_side = side;
    const auto prediction = predict(CollisionType::kLtap, agents, std::nullopt, nullptr, map);
    ASSERT_EQ(prediction.patterns.size(), 2u);
    const double sign = side == DrivingSide::kRight ? 1.0 : -1.0;
    for (const CollisionPattern& pattern : prediction.patterns) {
      const bool in_front = pattern.attacker_offset.x > 2.0;
      EXPECT_TRUE(in_front || sign * pattern.attacker_offset.y > 2.0);
      EXPECT_NEAR(pattern.attacker_offset.yaw, -sign * 1.5708, 1e-12);
    }
  }
}

TEST(KinematicPatternPredictor, ConsidersCandidatesOnly) {
  Track pedestrian = pastTrack("pedestrian", {0.7, 0.7}, {5.0, 5.0, 0.0}, 1.0);
  pedestrian.agent_class = AgentClass::kPedestrian;
  Track gone = pastTrack("gone", kCarSize, {-20.0, 4.0, 0.0}, 12.0);
  gone.states.pop_back();
  Track fresh = pastTrack("fresh", kCarSize, {-20.0, 8.0, 0.0}, 12.0);
  fresh.states = {fresh.states.back()};
  const Track far = pastTrack("far", kCarSize, {-81.0, 0.0, 0.0}, 12.0);
  const Track truck = pastTrack("near", kCarSize, {-79.0, 0.0, 0.0}, 12.0);
  EXPECT_EQ(attackers(predict(CollisionType::kRearEnd, {pedestrian, gone, fresh, far, truck})),
            (std::vector<std::string>{"near", "near"}));
  const auto nobody = predict(CollisionType::kRearEnd, {pedestrian, gone, fresh, far});
  EXPECT_EQ(nobody.status.code, StatusCode::kNoCandidate);
  EXPECT_NE(nobody.status.message.find("candidate_radius"), std::string::npos);
}

TEST(KinematicPatternPredictor, RanksAttackersWhoseSpeedFitsTheDistanceFirst) {
  // From x to 35.7 m in 4 s at a mean of 13 m/s: the fitting one starts 16.3 m behind.
  const std::vector<Track> agents{pastTrack("far", kCarSize, {-60.0, 0.0, 0.0}, 12.0),
                                  pastTrack("fits", kCarSize, {-16.0, 3.5, 0.0}, 12.0),
                                  pastTrack("close", kCarSize, {-6.0, 0.0, 0.0}, 12.0)};
  std::vector<std::string> ranked = attackers(predict(CollisionType::kRearEnd, agents));
  EXPECT_EQ(ranked.size(), 6u) << "two placements each";
  EXPECT_EQ(ranked.front(), "fits");
  EXPECT_EQ(ranked.back(), "far");
}

TEST(KinematicPatternPredictor, ConsidersAttackersThatApproachFromTheTypesDirection) {
  const auto approaching = [](CollisionType type, double yaw) {
    return predict(type, {pastTrack("a", kCarSize, {40.0, 20.0, yaw}, 8.0)}).status.code ==
           StatusCode::kOk;
  };
  for (const auto& [type, band] : shippedCrash().types) {
    for (const double sign : {1.0, -1.0}) {
      EXPECT_TRUE(approaching(type, sign * (band.min_approach + 1e-3))) << toString(type);
      EXPECT_TRUE(approaching(type, sign * (band.max_approach - 1e-3))) << toString(type);
      if (band.min_approach > 0.0) {
        EXPECT_FALSE(approaching(type, sign * (band.min_approach - 1e-3))) << toString(type);
      }
      if (band.max_approach < 3.0) {
        EXPECT_FALSE(approaching(type, sign * (band.max_approach + 1e-3))) << toString(type);
      }
    }
  }
}

TEST(KinematicPatternPredictor, TheLikeliestFutureOfTheEgoIsTheMostCentralSample) {
  const Future future =
      predict(CollisionType::kRearEnd, {pastTrack("a", kCarSize, {-20.0, 0.0, 0.0}, 12.0)}).future;
  const auto place = [](const Track& track) {
    return stateAt(track, kNow + kTta)->pose.position();
  };
  Vector2 mean = Vector2::Zero();
  for (const Track& sample : future.ego_samples) mean += place(sample);
  mean /= static_cast<double>(future.ego_samples.size());
  for (const Track& sample : future.ego_samples) {
    EXPECT_LE((place(future.ego) - mean).norm(), (place(sample) - mean).norm() + 1e-9);
  }
}

TEST(KinematicPatternPredictor, SamplesTheEgoInHistoryOnly) {
  const std::vector<Track> agents{pastTrack("a", kCarSize, {-20.0, 0.0, 0.0}, 12.0)};
  const Future history = predict(CollisionType::kRearEnd, agents).future;
  ASSERT_GT(history.ego_samples.size(), 1u);
  for (const Track& sample : history.ego_samples) {
    ASSERT_FALSE(sample.states.empty());
    EXPECT_EQ(sample.id, kEgoId);
    EXPECT_EQ(sample.size.length, kEgoSize.length);
    EXPECT_NEAR(sample.states.front().time, kNow, 1e-9);
    EXPECT_NEAR(sample.states.front().pose.position().norm(), 0.0, 1e-6);
  }
  Future recorded;
  recorded.ego = futureTrack(kEgoId, kEgoSize, {}, 5.0);
  EXPECT_TRUE(
      predict(CollisionType::kRearEnd, agents, std::nullopt, &recorded).future.ego_samples.empty());
}

TEST(KinematicPatternPredictor, UsesTheRecordedFutureInReplay) {
  Future recorded;
  recorded.ego = futureTrack(kEgoId, kEgoSize, {}, 5.0);
  const std::vector<Track> agents{pastTrack("a", kCarSize, {-20.0, 0.0, 0.0}, 12.0)};
  const auto prediction = predict(CollisionType::kRearEnd, agents, std::nullopt, &recorded);
  ASSERT_EQ(prediction.status.code, StatusCode::kOk);
  EXPECT_NEAR(prediction.patterns.at(0).ego.center.x, 20.0, 1e-9);
  EXPECT_NEAR(prediction.patterns.at(0).attacker_speed, 9.0, 1e-9);
  EXPECT_TRUE(prediction.future.agents.empty());
}

TEST(KinematicPatternPredictor, NeedsTheRecordingUpToTheImpact) {
  Future recorded;
  recorded.ego = straightTrack(kEgoId, kEgoSize, {}, 5.0, kNow, kNow, kNow + kTta - 0.5);
  const std::vector<Track> agents{pastTrack("a", kCarSize, {-20.0, 0.0, 0.0}, 12.0)};
  const auto prediction = predict(CollisionType::kRearEnd, agents, std::nullopt, &recorded);
  EXPECT_EQ(prediction.status.code, StatusCode::kBeyondRecording);
  EXPECT_NE(prediction.status.message.find("tta = 4"), std::string::npos);
  EXPECT_TRUE(prediction.patterns.empty());
}

}  // namespace
}  // namespace forge
