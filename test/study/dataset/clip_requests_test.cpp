#include "collision_forge/study/dataset/clip_requests.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

using testing::ElementsAre;

constexpr double kStart = 1000.0;  // s, of the first frame

DatasetOptions options() {
  DatasetOptions options;
  options.begin_stride = 0.5;
  options.min_length = 4.5;
  options.max_length = 6.0;
  for (const CollisionType type : kCollisionTypes) options.attempts[type] = 2;
  return options;
}

/// A scene with an ego that drives straight at 5 m/s, with frames at these times.
Scene sceneOf(const std::vector<double>& times, double speed = 5.0) {
  Scene scene;
  scene.name = "scene-0007";
  scene.frame_times = times;
  scene.ego = {kEgoId, AgentClass::kCar, kEgoSize, {}};
  for (const double time : times) {
    scene.ego.states.push_back({time, {speed * (time - kStart), 0.0, 0.0}, {speed, 0.0}});
  }
  return scene;
}

std::vector<double> framesEvery(double interval, int count) {
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(kStart + interval * i);
  return times;
}

std::vector<SceneRequest> list(const Scene& scene, const DatasetOptions& options,
                               std::uint64_t seed = 0) {
  return listClipRequests(scene, options, shippedOptions().prediction, seed);
}

TEST(ClipRequests, LengthsAreFramesWithinTheLimits) {
  EXPECT_THAT(clipLengths(options()), ElementsAre(9, 10, 11, 12));
  DatasetOptions odd = options();
  odd.min_length = 4.6;
  odd.max_length = 5.9;
  EXPECT_THAT(clipLengths(odd), ElementsAre(10, 11));
}

TEST(ClipRequests, FasterFramesGiveTheRequestsOfTwoHertz) {
  const auto requests = list(sceneOf(framesEvery(0.5, 20)), options());
  const auto faster = list(sceneOf(framesEvery(1.0 / 12.0, 6 * 19 + 1)), options());
  ASSERT_EQ(faster.size(), requests.size());
  for (std::size_t i = 0; i < requests.size(); ++i) {
    EXPECT_NEAR(faster[i].now, requests[i].now, 1e-9);
    EXPECT_NEAR(faster[i].request.tta, requests[i].request.tta, 1e-9);
  }
}

TEST(ClipRequests, EachBeginAndTypeGetsTheConfiguredNumberOfLengths) {
  // The impact is in frame 9 to 12 from the begin and has a frame after it: 20 frames hold begins 0
  // to 9; the last of them 9 alone, the one before 9 and 10.
  const auto requests = list(sceneOf(framesEvery(0.5, 20)), options());
  std::map<std::pair<double, CollisionType>, std::set<double>> ttas;
  for (const SceneRequest& request : requests) {
    EXPECT_EQ(request.scene, "scene-0007");
    EXPECT_EQ(request.request.mode, Mode::kReplay);
    EXPECT_FALSE(request.request.attacker);
    const double tta = request.request.tta;
    EXPECT_TRUE(ttas[std::make_pair(request.now, request.request.type)].insert(tta).second);
    EXPECT_GE(tta, 1.0);
    EXPECT_LE(tta, 2.5);
    EXPECT_EQ(std::fmod(tta, 0.5), 0.0);
    EXPECT_LE(request.now + tta, kStart + 9.0);
  }
  EXPECT_EQ(ttas.size(), 5U * 10U);
  for (const auto& [key, found] : ttas) {
    EXPECT_EQ(found.size(), key.first == kStart + 8.0 ? 1U : 2U) << key.first;
  }
}

TEST(ClipRequests, TtaIsTheRecordedTimeToTheImpactFrame) {
  std::vector<double> times = framesEvery(0.5, 12);
  for (std::size_t i = 0; i < times.size(); i += 2) times[i] += 0.03;
  DatasetOptions one = options();
  one.max_length = 4.5;
  for (const SceneRequest& request : list(sceneOf(times), one)) {
    const auto now = std::find(times.begin(), times.end(), request.now);
    ASSERT_NE(now, times.end());
    EXPECT_DOUBLE_EQ(request.request.tta, *(now + 2) - *now);
  }
}

TEST(ClipRequests, SeedsDifferAndAreDeterministic) {
  const Scene scene = sceneOf(framesEvery(0.5, 30));
  std::set<std::uint64_t> seeds;
  const auto requests = list(scene, options());
  for (const SceneRequest& request : requests) seeds.insert(request.request.seed);
  EXPECT_EQ(seeds.size(), requests.size());
  const auto again = list(scene, options());
  ASSERT_EQ(again.size(), requests.size());
  for (std::size_t i = 0; i < requests.size(); ++i) {
    EXPECT_EQ(again[i].request.seed, requests[i].request.seed);
    EXPECT_EQ(again[i].request.tta, requests[i].request.tta);
  }
  EXPECT_EQ(seeds.count(list(scene, options(), 1).front().request.seed), 0U);
}

TEST(ClipRequests, FramesNotAtTwoHertzYieldNoRequests) {
  EXPECT_TRUE(list(sceneOf(framesEvery(0.6, 40)), options()).empty());
  std::vector<double> gap = framesEvery(0.5, 20);
  for (std::size_t i = 5; i < gap.size(); ++i) gap[i] += 0.5;
  for (const SceneRequest& request : list(sceneOf(gap), options())) {
    EXPECT_GE(request.now, gap[5] + 3.5);
  }
}

TEST(ClipRequests, SlowEgosAreSkipped) {
  DatasetOptions fast = options();
  fast.min_ego_speed = 5.5;
  EXPECT_TRUE(list(sceneOf(framesEvery(0.5, 20)), fast).empty());
  fast.min_ego_speed = 4.5;
  EXPECT_FALSE(list(sceneOf(framesEvery(0.5, 20)), fast).empty());
  EXPECT_FALSE(list(sceneOf(framesEvery(0.5, 20), 0.0), options()).empty());
}

}  // namespace
}  // namespace forge
