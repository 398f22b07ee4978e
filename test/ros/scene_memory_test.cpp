#include "collision_forge/ros/nodes/scene_memory.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <chrono>
#include <future>
#include <string>

#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

constexpr double kClock = 5000.0;  // s; that of the node goes its own way

class SceneMemoryTest : public testing::Test {
 protected:
  using Found = std::variant<SceneMemory::Scene, Status>;

  static LiveOptions options() {
    LiveOptions options;
    options.max_scene_age = 1.0;
    options.kept_for = 10.0;
    options.wait_for = 0.05;
    return options;
  }

  void add(double stamp, double clock = kClock) {
    auto scene = boost::make_shared<collision_forge::SceneSnapshot>();
    scene->header.stamp = ros::Time(stamp);
    memory_.add(scene, clock);
  }

  static double stampOf(const Found& found) {
    return std::get<SceneMemory::Scene>(found)->header.stamp.toSec();
  }
  static StatusCode codeOf(const Found& found) { return std::get<Status>(found).code; }
  static std::string messageOf(const Found& found) { return std::get<Status>(found).message; }

  SceneMemory memory_{options()};
};

TEST_F(SceneMemoryTest, TheNewestSceneBecomesStale) {
  add(100.0, kClock);
  add(100.5, kClock + 0.5);
  EXPECT_EQ(stampOf(memory_.newest(kClock + 0.5)), 100.5);
  EXPECT_EQ(stampOf(memory_.newest(kClock + 1.4)), 100.5);
  const Found old = memory_.newest(kClock + 23.5);
  EXPECT_EQ(codeOf(old), StatusCode::kStaleScene);
  EXPECT_NE(messageOf(old).find("23.0 s ago"), std::string::npos) << messageOf(old);
  EXPECT_NE(messageOf(old).find("/tf"), std::string::npos);
}

TEST_F(SceneMemoryTest, AStampSelectsTheSceneAtOrBeforeIt) {
  for (int i = 0; i <= 4; ++i) add(100.0 + 0.5 * i);
  EXPECT_EQ(stampOf(memory_.at(ros::Time(100.0))), 100.0);
  EXPECT_EQ(stampOf(memory_.at(ros::Time(101.2))), 101.0);
  EXPECT_EQ(stampOf(memory_.at(ros::Time(102.0))), 102.0);
  EXPECT_EQ(codeOf(memory_.at(ros::Time(99.9))), StatusCode::kNoScene);
}

TEST_F(SceneMemoryTest, AStampWithNanosecondsSelectsItsFrame) {
  for (const std::uint32_t nanoseconds : {123456499u, 123456500u, 123456789u}) {
    const ros::Time agents(1600000000, nanoseconds);
    SceneMemory memory(options());
    for (const double later : {0.0, 0.5}) {
      auto scene = boost::make_shared<collision_forge::SceneSnapshot>();
      scene->header.stamp = forge::stampOf((agents + ros::Duration(later)).toSec());
      memory.add(scene, kClock);
      const Found found = memory.at(agents + ros::Duration(later));
      ASSERT_TRUE(std::holds_alternative<SceneMemory::Scene>(found)) << messageOf(found);
      EXPECT_EQ(std::get<SceneMemory::Scene>(found), scene);
    }
  }
}

TEST_F(SceneMemoryTest, WaitsForASceneThatIsStillToCome) {
  LiveOptions patient = options();
  patient.wait_for = 30.0;
  SceneMemory memory(patient);
  auto found = std::async(std::launch::async, [&] { return memory.at(ros::Time(101.0)); });
  for (const double stamp : {100.0, 100.5, 101.0}) {
    EXPECT_EQ(found.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout) << stamp;
    auto scene = boost::make_shared<collision_forge::SceneSnapshot>();
    scene->header.stamp = ros::Time(stamp);
    memory.add(scene, kClock);
  }
  EXPECT_EQ(stampOf(found.get()), 101.0);
}

TEST_F(SceneMemoryTest, ARestartedReplayDropsKeptScenes) {
  add(200.0);
  add(100.0);
  EXPECT_EQ(stampOf(memory_.newest(kClock)), 100.0);
  EXPECT_EQ(codeOf(memory_.at(ros::Time(200.0))), StatusCode::kStaleScene);
}

}  // namespace
}  // namespace forge
