#include "collision_forge/study/generators/published_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "attack/search/test_scenes.h"
#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

GeneratorOptions publishedOptions() { return shippedConfig().published_network; }

/// Options that train faster than the shipped ones.
GeneratorOptions quickOptions() {
  GeneratorOptions options = publishedOptions();
  options.published_network.anchor_3 = 64;
  options.published_network.dropout = 0.0;
  options.published_network.learning_rate = 0.002;
  options.published_network.decay_from = 200;
  options.published_network.decay_every = 20;
  return options;
}

std::shared_ptr<TrafficModel> makeSeeded(const GeneratorOptions& options) {
  torch::manual_seed(0);
  return makePublishedNetwork(options.published_network, options.traffic, torch::kCPU);
}

/// On twoLaneRoad(), the ego at 6 m/s; a car comes from behind and another from ahead, and the
/// middle of either is 4 m from the ego's at the crash: the type tells which one is the attacker.
/// A bystander stands ahead, beside the road.
CollideClip crashClip(CollisionType type, int last_frame) {
  const double left = 0.5 * (last_frame - kCollideNowFrame);
  const double ego_speed = 6.0, speed = 9.0;
  const Pose2 behind{ego_speed * left - 4.0 - speed * left, 0.0, 0.0};
  const Pose2 ahead{ego_speed * left + 4.0 + speed * left, 0.0, M_PI};
  const bool is_rear = type == CollisionType::kRearEnd;
  CollideClip clip = straightClip(type, is_rear ? 0.0 : 180.0, last_frame, ego_speed,
                                  is_rear ? behind : ahead, speed);
  clip.tracks.push_back(straightClipTrack("other", is_rear ? ahead : behind, speed, last_frame));
  clip.tracks.push_back(standingClipTrack("bystander", {12.0, -6.0, 0.0}, last_frame));
  return clip;
}

TrafficBatch crashBatch(const TrafficOptions& options) {
  const LaneIndex lanes(twoLaneRoad());
  std::vector<TrafficClip> clips;
  for (const auto type : {CollisionType::kRearEnd, CollisionType::kOppositeDirection}) {
    for (const int last_frame : {10, 12, 14}) {
      clips.push_back(
          trafficOf(crashClip(type, last_frame), {{4.7, 2.0}, 2.0, 0.1}, options, &lanes));
    }
  }
  return sampleBatch(clips, options);
}

/// Returns the mean errors by name.
std::map<std::string, double> errorsOf(const TrafficModel& model, const TrafficBatch& batch) {
  const torch::NoGradGuard no_gradients;
  model.network()->eval();
  const std::vector<ErrorSum> sums = model.errorsOn(batch, noiseOf(1));
  const std::vector<std::string> names = model.errorNames();
  EXPECT_EQ(sums.size(), names.size());
  std::map<std::string, double> errors;
  for (std::size_t i = 0; i < names.size(); ++i) errors[names[i]] = sums[i].sum / sums[i].count;
  return errors;
}

/// Returns a model that is overfitted to crashBatch().
std::shared_ptr<TrafficModel> trained() {
  static std::shared_ptr<TrafficModel> model;
  if (model) return model;
  const GeneratorOptions options = quickOptions();
  model = makeSeeded(options);
  const TrafficBatch batch = crashBatch(options.traffic);
  for (int step = 0; step < 300; ++step) model->trainStep(batch);
  return model;
}

/// Returns the moment of crashClip() with the ego at `origin`.
Moment crashMoment(const Pose2& origin = {}) {
  const auto map = twoLaneRoad();
  for (Lane& lane : map->lanes) {
    for (Pose2& pose : lane.centerline) pose = compose(origin, pose);
  }
  const auto at = [&](double x, double y, double yaw) { return compose(origin, {x, y, yaw}); };
  return {snapshotOf(pastTrack(kEgoId, kEgoSize, at(0.0, 0.0, 0.0), 6.0),
                     {pastTrack("bystander", kCarSize, at(12.0, -6.0, 0.0), 0.0),
                      pastTrack("behind", kCarSize, at(-11.5, 0.0, 0.0), 9.0),
                      pastTrack("ahead", kCarSize, at(41.5, 0.0, M_PI), 9.0)},
                     map),
          std::nullopt, std::make_shared<const LaneIndex>(map)};
}

Attack answerOf(const TrafficModel& model, const Moment& moment, const CollisionRequest& request) {
  const auto method = model.method(shippedOptions());
  return method->answer(moment, request);
}

long blockSize(long from, long to) {
  const long shortcut = from == to ? 0 : from * to + to + 2 * to;
  return from * to + to + 2 * to + to * to + to + 2 * to + shortcut;
}

long linearSize(long from, long to) { return from * to + to; }

TEST(PublishedNetwork, HasThePublishedNumberOfWeights) {
  const long encoder =
      blockSize(7, 64) + 2 * blockSize(128, 64) + linearSize(128, 64) + 3 * linearSize(66, 64);
  const long condition =
      5 * 5 + linearSize(5, 32) + linearSize(1, 32) + linearSize(128, 64) + linearSize(64, 64);
  const long attacker = linearSize(64, 2) + linearSize(64, 1) + linearSize(2, 32) +
                        blockSize(96, 64) + linearSize(64, 1);
  const long yaw = blockSize(64, 64) + linearSize(64, 1);
  const long anchors = linearSize(2, 64) + linearSize(64, 128) + linearSize(128, 1024) +
                       2 * (64 + 128 + 1024) + blockSize(1024, 64) + 2 * linearSize(64, 64) +
                       blockSize(192, 64) + linearSize(64, 1);
  const long shift = blockSize(66, 64) + linearSize(64, 2);
  const long expected = encoder + condition + attacker + yaw + anchors + shift;
  GeneratorOptions options = publishedOptions();
  options.published_network.anchor_3 = 1024;
  long count = 0;
  for (const auto& parameter : makeSeeded(options)->network()->parameters()) {
    count += parameter.numel();
  }
  EXPECT_EQ(count, expected);
  EXPECT_NEAR(expected, 0.44e6, 0.01e6);
}

TEST(PublishedNetwork, OverfitsAFewClips) {
  const GeneratorOptions options = quickOptions();
  const TrafficBatch batch = crashBatch(options.traffic);
  const auto before = errorsOf(*makeSeeded(options), batch);
  auto after = errorsOf(*trained(), batch);
  EXPECT_GT(before.at("ego_m"), 2.0);
  EXPECT_LT(after.at("ego_m"), 1.01);
  EXPECT_LT(after.at("offset_m"), 0.5);
  EXPECT_LT(after.at("ego_yaw_deg"), 2.0);
  EXPECT_LT(after.at("relative_heading_deg"), 5.0);
  EXPECT_EQ(after.at("selection_missed"), 0.0);
}

TEST(PublishedNetwork, DrivesTheSelectedAttackerToThePatternOfTheType) {
  const Moment moment = crashMoment();
  const auto model = trained();
  const Attack rear = answerOf(*model, moment, requestFor(CollisionType::kRearEnd, 2.5));
  ASSERT_EQ(rear.status.code, StatusCode::kOk);
  EXPECT_EQ(rear.trajectory.attacker_id, "behind");
  EXPECT_NEAR(rear.pattern.ego.center.x, 15.0, 1.01);
  EXPECT_NEAR(rear.pattern.attacker_offset.x, -4.0, 0.5);
  const Pose2 there = poseAt(rear.trajectory, kNow + 2.5);
  const Pose2 target = compose(rear.pattern.ego.center, rear.pattern.attacker_offset);
  EXPECT_LT((there.position() - target.position()).norm(), 0.01);
  EXPECT_TRUE(rear.report.contact);
  const Attack opposite =
      answerOf(*model, moment, requestFor(CollisionType::kOppositeDirection, 2.5));
  EXPECT_EQ(opposite.trajectory.attacker_id, "ahead");
  EXPECT_NEAR(opposite.pattern.attacker_offset.x, 4.0, 0.5);
  EXPECT_NEAR(std::abs(opposite.pattern.attacker_offset.yaw), M_PI, 0.1);
}

TEST(PublishedNetwork, IsInvariantToTheOrderOfAgents) {
  const auto model = trained();
  Moment moment = crashMoment();
  const CollisionRequest request = requestFor(CollisionType::kRearEnd, 2.5);
  const Attack one = answerOf(*model, moment, request);
  std::reverse(moment.snapshot.agents.begin(), moment.snapshot.agents.end());
  const Attack other = answerOf(*model, moment, request);
  EXPECT_EQ(one.trajectory.attacker_id, other.trajectory.attacker_id);
  EXPECT_NEAR(one.pattern.ego.center.x, other.pattern.ego.center.x, 1e-4);
  EXPECT_NEAR(one.pattern.attacker_offset.x, other.pattern.attacker_offset.x, 1e-4);
}

TEST(PublishedNetwork, TheInputDoesNotRevealTheAttacker) {
  const GeneratorOptions options = quickOptions();
  const auto model = trained();
  TrafficBatch batch = crashBatch(options.traffic);
  const auto row = static_cast<long>(kAttackerAgent);
  const auto order = torch::tensor(std::vector<std::int64_t>{0, row + 1, row, row + 2});
  batch.poses = batch.poses.index_select(1, order);
  batch.seen = batch.seen.index_select(1, order);
  EXPECT_EQ(errorsOf(*model, batch).at("selection_missed"), 1.0) << "another is in its place";
}

TEST(PublishedNetwork, DrivesTheRequestedAttacker) {
  const auto model = trained();
  CollisionRequest request = requestFor(CollisionType::kRearEnd, 2.5);
  const Attack free = answerOf(*model, crashMoment(), request);
  request.attacker = "bystander";
  const Attack named = answerOf(*model, crashMoment(), request);
  EXPECT_EQ(named.trajectory.attacker_id, "bystander");
  EXPECT_NEAR(named.pattern.attacker_offset.x, free.pattern.attacker_offset.x, 1e-4);
  EXPECT_NEAR(named.pattern.ego.center.x, free.pattern.ego.center.x, 1e-4);
}

TEST(PublishedNetwork, TheAttackMovesWithTheScene) {
  const Pose2 origin{300.0, -120.0, 2.2};
  const CollisionRequest request = requestFor(CollisionType::kRearEnd, 2.5);
  const Attack here = answerOf(*trained(), crashMoment(), request);
  const Attack there = answerOf(*trained(), crashMoment(origin), request);
  const Pose2 moved = compose(origin, here.pattern.ego.center);
  EXPECT_NEAR(there.pattern.ego.center.x, moved.x, 0.01);
  EXPECT_NEAR(there.pattern.ego.center.y, moved.y, 0.01);
  EXPECT_NEAR(angleBetween(there.pattern.ego.center.yaw, moved.yaw), 0.0, 1e-3);
  const Pose2 driven = compose(origin, poseAt(here.trajectory, kNow + 2.5));
  EXPECT_LT((poseAt(there.trajectory, kNow + 2.5).position() - driven.position()).norm(), 0.02);
}

TEST(PublishedNetwork, WithoutLanesItReportsTheReason) {
  Moment moment = crashMoment();
  moment.snapshot.map = emptyMap();
  moment.lanes = std::make_shared<const LaneIndex>(emptyMap());
  const CollisionRequest request = requestFor(CollisionType::kRearEnd, 2.5);
  const Attack answer = answerOf(*trained(), moment, request);
  EXPECT_EQ(answer.status.code, StatusCode::kRoadDoesNotAllow);
  EXPECT_NE(answer.status.message.find("no lane within 53"), std::string::npos)
      << answer.status.message;
}

}  // namespace
}  // namespace forge
