#include "collision_forge/study/evaluation/clip_evaluation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/study/evaluation/clip_methods.h"
#include "collision_forge/study/settings/study_config.h"
#include "io/collide/collide_fixture.h"

namespace forge {
namespace {

const std::string kConfig = std::string(COLLISION_FORGE_SOURCE_DIR) + "/config";

struct Evaluation {
  StudyConfig config = loadStudyConfig(kConfig);
  std::shared_ptr<const LaneIndex> lanes =
      std::make_shared<const LaneIndex>(std::make_shared<const LaneMap>());
  EvaluationPlan plan;
  PredictionModels models;  // without models

  std::vector<ResultRow> rows(const CollideClip& clip) const {
    return evaluateClip(clip, lanes, {builtInMethods(), models, config}, plan);
  }
  ResultRow row(const CollideClip& clip, const std::string& method) const {
    for (const ResultRow& row : rows(clip)) {
      if (row.method == method) return row;
    }
    throw std::out_of_range(method);
  }
};

bool meets(const ResultRow& row, Protocol protocol, const std::string& name) {
  const auto& measures = measuresOf(protocol);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (measures[i].name == name) return row.meets[i];
  }
  throw std::out_of_range(name);
}

/// The attacker approaches from behind at 5 m/s relative speed; contact 2 s after t0.
CollideClip rearEnd() {
  return straightClip(CollisionType::kRearEnd, 0.0, 11, 5.0, {-14.7, 0.0, 0.0}, 10.0);
}

TEST(ClipEvaluation, EveryPlanHasTheBaselinesAndItsSeeds) {
  Evaluation evaluation;
  const auto methods = [&] {
    std::vector<std::string> found;
    for (const ResultRow& row : evaluation.rows(rearEnd())) {
      found.push_back(row.method + std::to_string(row.seed));
    }
    EXPECT_EQ(found.size(), rowsPerClip(evaluation.plan));
    return found;
  };
  evaluation.plan.seeds = 2;
  evaluation.plan.method = "nominal";
  EXPECT_EQ(methods(), (std::vector<std::string>{"recorded0", "constant_velocity0", "nominal0"}));
  evaluation.plan.method = "search";
  EXPECT_EQ(methods(), (std::vector<std::string>{"recorded0", "constant_velocity0", "nominal0",
                                                 "search0", "search1"}));
  for (const std::string& method :
       clipMethods(builtInMethods(), nullptr, evaluation.config.evaluation).names()) {
    evaluation.plan.method = method;
    const auto found = methodsOf(evaluation.plan);
    EXPECT_NE(std::find(found.begin(), found.end(), method), found.end());
  }
}

TEST(ClipEvaluation, StrictRowsHaveAllConditions) {
  Evaluation evaluation;
  for (const char* method : {"recorded", "constant_velocity"}) {
    const ResultRow row = evaluation.row(rearEnd(), method);
    EXPECT_EQ(row.meets, std::vector<bool>(8, true)) << method;
    EXPECT_NEAR(*row.contact_after, 2.0, 1e-3);
    EXPECT_NEAR(*row.relative_heading, 0.0, 1e-6);
    EXPECT_EQ(row.note, "");
  }
}

TEST(ClipEvaluation, TheApproachDistinguishesTheTwoStrictColumns) {
  // From the left at 90 degrees: a left turn across path only by the angle.
  const CollideClip clip =
      straightClip(CollisionType::kLtap, 90.0, 11, 5.0, {10.0, 13.0, -M_PI_2}, 5.0);
  const ResultRow row = Evaluation().row(clip, "recorded");
  EXPECT_TRUE(meets(row, Protocol::kStrict, "angle_bands"));
  EXPECT_FALSE(meets(row, Protocol::kStrict, "full_definitions"));
  EXPECT_TRUE(meets(row, Protocol::kStrict, "type_angle_bands"));
  EXPECT_FALSE(meets(row, Protocol::kStrict, "type_full"));
}

TEST(ClipEvaluation, NotesNameTheBrokenLimitAndTheTouchedAgent) {
  CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, 11, 30.0, {-14.7, 0.0, 0.0}, 35.0);
  clip.tracks.push_back(straightClipTrack("third", {-10.0, 1.0, 0.0}, 30.5, 11));
  const ResultRow row = Evaluation().row(clip, "recorded");
  EXPECT_FALSE(meets(row, Protocol::kStrict, "limits_kept"));
  EXPECT_FALSE(meets(row, Protocol::kStrict, "nobody_before"));
  EXPECT_EQ(row.note, "max_speed 35.000 > 25.000; touches third");
}

TEST(ClipEvaluation, PublishedContactTimesAreRelativeToT0) {
  Evaluation evaluation;
  evaluation.plan.protocol = Protocol::kPublished;
  const ResultRow row = evaluation.row(rearEnd(), "recorded");
  EXPECT_EQ(row.meets, (std::vector<bool>{true, true}));
  EXPECT_NEAR(*row.contact_after, 2.1,
              1e-9);  // 0.5 m per step; a collision needs 0.18 m of overlap
  CollideClip clip = rearEnd();
  clip.tracks.push_back(standingClipTrack("third", {-4.0, 0.0, 0.0}, 11));
  const ResultRow miss = evaluation.row(clip, "recorded");
  EXPECT_EQ(miss.meets, (std::vector<bool>{false, false}));
  EXPECT_FALSE(miss.relative_heading);
  EXPECT_LT(*miss.contact_after, 0.0);
  EXPECT_EQ(miss.note, "ego touches third");
}

/// The ego brakes from t0 on, which its history does not show.
CollideClip brakingEgo(double deceleration) {
  CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, 15, 8.0, {-20.0, 0.3, 0.0}, 10.0);
  for (std::size_t i = kCollideNowFrame + 1; i < clip.times.size(); ++i) {
    const double t = clip.times[i] - clip.now();
    CollideState& ego = *clip.tracks.back().frames[i];
    ego.pose = {8.0 * t - 0.5 * deceleration * t * t, 0.0, 0.0};
    ego.speed = 8.0 - deceleration * t;
  }
  return clip;
}

TEST(ClipEvaluation, AnAdaptiveAttackerReactsToTheClip) {
  Evaluation evaluation;
  evaluation.lanes = std::make_shared<const LaneIndex>(twoLaneRoad());
  evaluation.plan.method = "search";
  evaluation.plan.mode = Mode::kAdaptive;
  const CollideClip clip = brakingEgo(1.5);
  const ResultRow adaptive = evaluation.row(clip, "search");
  const ResultRow fixed = evaluation.row(clip, "first_plan");
  EXPECT_FALSE(meets(fixed, Protocol::kStrict, "contact"));
  EXPECT_TRUE(meets(adaptive, Protocol::kStrict, "on_time"));
  const auto baseline = evaluation.row(clip, "nominal").contact_after;
  evaluation.plan.mode = Mode::kHistory;
  EXPECT_EQ(evaluation.row(clip, "nominal").contact_after, baseline);
  EXPECT_THROW(evaluation.row(clip, "first_plan"), std::out_of_range);
}

TEST(ClipEvaluation, NetworkMethodsAreMeasuredBesideTheSearchWithoutNetworks) {
  Evaluation evaluation;
  evaluation.models = loadPredictionModels(evaluation.config);
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 15, 8.0, {-20.0, 0.3, 0.0}, 10.0);
  evaluation.plan.method = "network+search";
  EXPECT_EQ(methodsOf(evaluation.plan),
            (std::vector<std::string>{"recorded", "constant_velocity", "nominal", "search",
                                      "network+search"}));
  const ResultRow without = evaluation.row(clip, "search");
  const ResultRow with = evaluation.row(clip, "network+search");
  EXPECT_EQ(without.status, "OK");
  EXPECT_EQ(with.status, "OK");
  EXPECT_NE(with.contact_after, without.contact_after);
  evaluation.models = evaluation.models.withoutNetwork();
  evaluation.plan.method = "search";
  EXPECT_EQ(evaluation.row(clip, "search").contact_after, without.contact_after);
}

TEST(ClipEvaluation, NetworkDrivesToItsLikeliestPattern) {
  Evaluation evaluation;
  evaluation.models = loadPredictionModels(evaluation.config);
  evaluation.plan.method = "network";
  evaluation.plan.is_seeded = false;
  evaluation.plan.mode = Mode::kReplay;
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 15, 8.0, {-20.0, 0.3, 0.0}, 10.0);
  const ResultRow row = evaluation.row(clip, "network");
  EXPECT_EQ(row.status, "OK");
  EXPECT_TRUE(meets(row, Protocol::kStrict, "contact"));
  EXPECT_TRUE(meets(row, Protocol::kStrict, "type_angle_bands"));
}

TEST(ClipEvaluation, SearchUsesOnlyTheAngleBands) {
  // A crossing at t0 and at contact, requested as left turn across path, which must come from
  // ahead.
  Evaluation evaluation;
  evaluation.plan.method = "search";
  evaluation.plan.mode = Mode::kReplay;
  const CollideClip clip =
      straightClip(CollisionType::kLtap, 90.0, 13, 5.0, {15.0, 20.0, -M_PI_2}, 6.0);
  const ResultRow row = evaluation.row(clip, "search");
  EXPECT_EQ(row.status, "OK");
  EXPECT_TRUE(meets(row, Protocol::kStrict, "angle_bands"));
  EXPECT_FALSE(meets(row, Protocol::kStrict, "full_definitions"));
}

TEST(ClipEvaluation, LimitsAreStrictForAnyConfiguration) {
  Evaluation evaluation;
  evaluation.plan.method = "search";
  evaluation.plan.mode = Mode::kReplay;
  const auto lines = [&] {
    std::vector<std::string> found;
    for (const ResultRow& row : evaluation.rows(rearEnd())) found.push_back(toCsv(row));
    return found;
  };
  evaluation.config.crash.limits = LimitSet::kDrivable;
  evaluation.config.crash.believable = true;
  const std::vector<std::string> drivable = lines();
  evaluation.config.crash = withClipRules(evaluation.config.crash);
  EXPECT_EQ(evaluation.config.crash.limits, LimitSet::kStrict);
  EXPECT_EQ(lines(), drivable);
  // The recorded attacker is judged by them too: it violates limits that allow no motion.
  ASSERT_TRUE(meets(evaluation.row(rearEnd(), "recorded"), Protocol::kStrict, "limits_kept"));
  evaluation.config.attack.verification.limits.max_speed = 1.0;
  EXPECT_FALSE(meets(evaluation.row(rearEnd(), "recorded"), Protocol::kStrict, "limits_kept"));
}

}  // namespace
}  // namespace forge
