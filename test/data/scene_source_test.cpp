#include "collision_forge/data/scene_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "collision_forge/config/config_error.h"
#include "collision_forge/data/nuscenes_json.h"
#include "collision_forge/data/nuscenes_tables.h"
#include "collision_forge/settings/config.h"

namespace forge {
namespace {

const std::string kDataroot = COLLISION_FORGE_SOURCE_DIR "/data/embedded";
constexpr const char* kVersion = "v1.0-embedded";

Config config() { return loadConfig(COLLISION_FORGE_SOURCE_DIR "/config"); }

SceneSource source(std::size_t kept) {
  return {{kDataroot, kVersion}, {"scene-0001", "scene-0002", "scene-0007"}, config(), kept};
}

TEST(ReadSceneNames, AreThoseOfTheTable) {
  const auto names = readSceneNames({kDataroot, kVersion});
  EXPECT_EQ(names, NuScenesRoot(kDataroot, kVersion).sceneNames());
  EXPECT_THROW(readSceneNames({kDataroot, "v0"}), NuScenesError);
}

TEST(SceneSource, HasTheSceneWithItsMap) {
  SceneSource scenes = source(2);
  const auto scene = scenes.at("scene-0001");
  EXPECT_EQ(scene->scene.name, "scene-0001");
  EXPECT_GT(scene->scene.frame_times.size(), 1u);
  EXPECT_EQ(scene->scene.map->location, "embedded-right");
  EXPECT_EQ(scene->lanes->map().driving_side, DrivingSide::kRight);
  EXPECT_EQ(scenes.at("scene-0007")->lanes->map().driving_side, DrivingSide::kLeft);
}

TEST(SceneSource, SharesOneMapAmongScenesOfAPlace) {
  SceneSource scenes = source(2);
  EXPECT_EQ(scenes.at("scene-0001")->lanes, scenes.at("scene-0002")->lanes);
  EXPECT_NE(scenes.at("scene-0001")->lanes, scenes.at("scene-0007")->lanes);
}

TEST(SceneSource, HoldsTheScenesUsedLast) {
  SceneSource scenes = source(2);
  const std::weak_ptr<const IndexedScene> first = scenes.at("scene-0001");
  const std::weak_ptr<const IndexedScene> second = scenes.at("scene-0002");
  scenes.at("scene-0001");
  EXPECT_FALSE(second.expired());
  scenes.at("scene-0007");
  EXPECT_TRUE(second.expired()) << "used longest ago";
  EXPECT_FALSE(first.expired());
  EXPECT_EQ(scenes.at("scene-0001"), first.lock()) << "not read again";
}

TEST(SceneSource, MayBeAskedByManyThreads) {
  SceneSource scenes = source(1);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&scenes, i] {
      const std::string name = i % 2 == 0 ? "scene-0001" : "scene-0007";
      for (int j = 0; j < 20; ++j) EXPECT_EQ(scenes.at(name)->scene.name, name);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST(SceneSource, RefusesUnknownScenes) {
  EXPECT_THROW(SceneSource({kDataroot, kVersion}, {"scene-0099"}, config(), 1), NuScenesError);
  SceneSource scenes = source(1);
  EXPECT_THROW(scenes.at("scene-0003"), NuScenesError) << "not among the wanted";
}

}  // namespace
}  // namespace forge
