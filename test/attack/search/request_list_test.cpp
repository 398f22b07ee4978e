#include "collision_forge/attack/search/request_list.h"

#include <gtest/gtest.h>

#include <set>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// Frames at 2 Hz from 100 s to 110 s; the ego and a car at 10 m/s, a pedestrian, and a truck that
/// is there from 105 s on.
Scene tenSeconds() {
  Scene scene;
  scene.name = "scene";
  scene.ego = straightTrack(kEgoId, kEgoSize, {}, 10.0, 100.0, 100.0, 110.0);
  for (const AgentState& state : scene.ego.states) scene.frame_times.push_back(state.time);
  scene.agents = {straightTrack("car", kCarSize, {30.0, 3.5, 0.0}, 10.0, 100.0, 100.0, 110.0),
                  straightTrack("walker", {0.6, 0.6}, {9.0, 9.0, 0.0}, 1.0, 100.0, 100.0, 110.0),
                  straightTrack("truck", kCarSize, {60.0, 3.5, 0.0}, 10.0, 100.0, 105.0, 110.0)};
  scene.agents[1].agent_class = AgentClass::kPedestrian;
  scene.agents[2].agent_class = AgentClass::kTruck;
  return scene;
}

RequestListOptions everyTwoSeconds() {
  RequestListOptions options;
  options.stride = 2.0;
  options.ttas = {3.0};
  options.min_ego_speed = 2.0;
  options.types = {CollisionType::kRearEnd};
  return options;
}

std::vector<double> nowsOf(const std::vector<SceneRequest>& requests) {
  std::vector<double> nows;
  for (const SceneRequest& request : requests) nows.push_back(request.now);
  return nows;
}

std::vector<double> nowsOf(const Scene& scene, const RequestListOptions& options) {
  return nowsOf(
      listRequests(scene, options, shippedOptions().prediction, shippedCrash().time_tolerance));
}

TEST(ListRequests, AreStrideApartWithHistoryAndContactWithinTheRecording) {
  // 100 s has one frame of history; 106 + 3 + 0.5 is within the recording, 108 + 3 is not.
  EXPECT_EQ(nowsOf(tenSeconds(), everyTwoSeconds()), (std::vector<double>{102.0, 104.0, 106.0}));
}

TEST(ListRequests, KeepTheToleranceBeforeTheRecordingsEnd) {
  RequestListOptions options = everyTwoSeconds();
  options.ttas = {3.5};
  EXPECT_EQ(nowsOf(tenSeconds(), options).back(), 106.0) << "106 + 3.5 + 0.5 is the end";
  options.ttas = {3.6};
  EXPECT_EQ(nowsOf(tenSeconds(), options).back(), 104.0);
}

TEST(ListRequests, UseTheNearestFrameWhereTheClockJitters) {
  Scene scene = tenSeconds();
  for (std::size_t i = 0; i < scene.frame_times.size(); ++i) {
    const double jitter = i % 3 == 0 ? 0.004 : -0.003;
    scene.frame_times[i] += jitter;
    scene.ego.states[i].time += jitter;
  }
  const std::vector<double> nows = nowsOf(scene, everyTwoSeconds());
  ASSERT_EQ(nows.size(), 3u);
  for (std::size_t i = 0; i < nows.size(); ++i) EXPECT_NEAR(nows[i], 102.0 + 2.0 * i, 0.01);
}

TEST(ListRequests, UseNoFrameTwice) {
  RequestListOptions options = everyTwoSeconds();
  options.stride = 0.2;
  const std::vector<double> nows = nowsOf(tenSeconds(), options);
  EXPECT_EQ(std::set<double>(nows.begin(), nows.end()).size(), nows.size());
  EXPECT_EQ(nows.front(), 100.5);
}

TEST(ListRequests, SkipASlowEgo) {
  RequestListOptions options = everyTwoSeconds();
  options.min_ego_speed = 10.5;
  EXPECT_TRUE(nowsOf(tenSeconds(), options).empty());
  options.min_ego_speed = 9.5;
  EXPECT_EQ(nowsOf(tenSeconds(), options).size(), 3u);
}

TEST(ListRequests, AreNoneWithoutAnEgo) {
  Scene scene = tenSeconds();
  scene.ego.states.clear();
  RequestListOptions options = everyTwoSeconds();
  options.min_ego_speed = 0.0;
  EXPECT_TRUE(nowsOf(scene, options).empty());
}

TEST(ListRequests, CountInstantsWithoutARequestByReason) {
  RequestListOptions options = everyTwoSeconds();
  RequestTally tally;
  const auto list = [&] {
    return listRequests(tenSeconds(), options, shippedOptions().prediction,
                        shippedCrash().time_tolerance, {}, &tally);
  };
  EXPECT_EQ(list().size(), 3u);
  EXPECT_EQ(tally.instants, 6u);
  EXPECT_EQ(tally.slow, 1u) << "one frame of history shows no motion";
  EXPECT_EQ(tally.late, 2u);
  options.min_ego_speed = 20.0;
  EXPECT_TRUE(list().empty());
  EXPECT_EQ(tally.instants, 12u) << "adds to the counts";
  EXPECT_EQ(tally.slow, 7u);
}

TEST(ListRequests, CoverEveryTtaAndTypeInOrder) {
  RequestListOptions options = everyTwoSeconds();
  options.ttas = {2.0, 3.0};
  options.types = {CollisionType::kLtap, CollisionType::kRearEnd};
  options.seed = 17;
  const auto requests = listRequests(tenSeconds(), options, shippedOptions().prediction,
                                     shippedCrash().time_tolerance);
  ASSERT_EQ(requests.size(), 12u);
  const std::pair<double, CollisionType> expected[] = {{2.0, CollisionType::kLtap},
                                                       {2.0, CollisionType::kRearEnd},
                                                       {3.0, CollisionType::kLtap},
                                                       {3.0, CollisionType::kRearEnd}};
  for (std::size_t i = 0; i < requests.size(); ++i) {
    EXPECT_EQ(requests[i].scene, "scene");
    EXPECT_EQ(requests[i].now, 102.0 + 2.0 * static_cast<double>(i / 4));
    EXPECT_EQ(requests[i].request.tta, expected[i % 4].first);
    EXPECT_EQ(requests[i].request.type, expected[i % 4].second);
    EXPECT_EQ(requests[i].request.seed, 17u);
    EXPECT_FALSE(requests[i].request.attacker);
  }
}

TEST(ListRequests, NameEachPossibleAttacker) {
  RequestListOptions options = everyTwoSeconds();
  options.attackers = Attackers::kEach;
  std::vector<std::pair<double, std::string>> asked;
  for (const SceneRequest& request : listRequests(
           tenSeconds(), options, shippedOptions().prediction, shippedCrash().time_tolerance)) {
    asked.emplace_back(request.now, request.request.attacker.value());
  }
  const std::vector<std::pair<double, std::string>> expected = {
      {102.0, "car"}, {104.0, "car"}, {106.0, "car"}, {106.0, "truck"}};
  EXPECT_EQ(asked, expected);
}

TEST(ListRequests, UseTheControlsThatTheTypeAllows) {
  RequestListOptions options = everyTwoSeconds();
  options.types = {CollisionType::kLtap, CollisionType::kRearEnd};
  CollisionRequest asked;
  asked.choice = AttackerChoice::kExisting;
  asked.manoeuvre = Manoeuvre::kLeadSlow;
  const auto requests = listRequests(tenSeconds(), options, shippedOptions().prediction,
                                     shippedCrash().time_tolerance, asked);
  ASSERT_EQ(requests.size(), 3u);
  for (const SceneRequest& request : requests) {
    EXPECT_EQ(request.request.type, CollisionType::kRearEnd);
    EXPECT_EQ(request.request.manoeuvre, Manoeuvre::kLeadSlow);
    EXPECT_EQ(request.request.choice, AttackerChoice::kExisting);
  }
}

TEST(ListRequests, SkipTtasOutOfRange) {
  RequestListOptions options = everyTwoSeconds();
  options.ttas = {0.4};
  EXPECT_TRUE(nowsOf(tenSeconds(), options).empty());
}

TEST(ListRequests, RejectAStrideThatIsNotPositive) {
  RequestListOptions options = everyTwoSeconds();
  for (const double stride : {0.0, -1.0, std::nan("")}) {
    options.stride = stride;
    EXPECT_THROW(listRequests(tenSeconds(), options, shippedOptions().prediction,
                              shippedCrash().time_tolerance),
                 std::invalid_argument);
  }
}

}  // namespace
}  // namespace forge
