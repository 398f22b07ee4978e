#include "collision_forge/io/logs/scene_source.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "collision_forge/base/config/config_error.h"
#include "collision_forge/io/logs/nuscenes_json.h"
#include "collision_forge/io/logs/nuscenes_tables.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

const std::string kDataroot = COLLISION_FORGE_SOURCE_DIR "/data/embedded";
constexpr const char* kVersion = "v1.0-embedded";

Config config() { return loadConfig(COLLISION_FORGE_SOURCE_DIR "/config"); }

SceneSource source(std::size_t kept) {
  return {{kDataroot, kVersion}, {"scene-0001", "scene-0002", "scene-0007"}, config(), kept};
}

TEST(ReadSceneNames, ReturnsTheNamesOfTheTable) {
  const auto names = readSceneNames({kDataroot, kVersion});
  EXPECT_EQ(names, NuScenesRoot(kDataroot, kVersion).sceneNames());
  EXPECT_THROW(readSceneNames({kDataroot, "v0"}), NuScenesError);
}

TEST(SceneSource, ReturnsTheSceneWithItsMap) {
  SceneSource scenes = source(2);
  const auto scene = scenes.at("scene-0001");
  EXPECT_EQ(scene->scene.name, "scene-0001");
  EXPECT_GT(scene->scene.frame_times.size(), 1u);
  EXPECT_EQ(scene->scene.map->location, "embedded-right");
  EXPECT_EQ(scene->lanes->map().driving_side, DrivingSide::kRight);
  EXPECT_EQ(scenes.at("scene-0007")->lanes->map().driving_side, DrivingSide::kLeft);
}

TEST(SceneSource, CachesTheMostRecentlyUsedScenes) {
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

/// A source of empty scenes. Reading a scene blocks until the wanted number of scenes is being
/// read.
struct SlowReader : SceneReader {
  static inline std::mutex mutex;
  static inline std::condition_variable changed;
  static inline std::map<std::string, int> reads;
  static inline std::size_t together = 1;
  static inline int failures = 0;

  std::vector<std::string> names() const override { return {"a", "b"}; }
  LoggedScene recording(const std::string& /*name*/) override { return {}; }
  IndexedScene read(const std::string& name) override {
    std::unique_lock<std::mutex> lock(mutex);
    ++reads[name];
    changed.notify_all();
    const bool are_together =
        changed.wait_for(lock, std::chrono::seconds(20), [] { return reads.size() >= together; });
    if (!are_together) throw std::runtime_error("the scenes are read one after the other");
    if (failures-- > 0) throw std::runtime_error("cannot be read");
    IndexedScene scene;
    scene.scene.name = name;
    return scene;
  }
};

std::unique_ptr<SceneReader> openSlow(const LogSource& /*source*/, const SceneReading& /*how*/) {
  return std::make_unique<SlowReader>();
}

SceneSource slowSource(std::size_t together, int failures) {
  static const LogFormat format{"slow", nullptr, nullptr, openSlow};
  SlowReader::reads.clear();
  SlowReader::together = together;
  SlowReader::failures = failures;
  return {{"", "", &format}, {}, config(), 2};
}

TEST(SceneSource, ReadsDifferentScenesAtTheSameTimeAndEachOnce) {
  SceneSource scenes = slowSource(2, 0);
  std::vector<std::thread> threads;
  for (const std::string name : {"a", "b", "a", "b"}) {
    threads.emplace_back([&scenes, name] { EXPECT_EQ(scenes.at(name)->scene.name, name); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(SlowReader::reads, (std::map<std::string, int>{{"a", 1}, {"b", 1}}));
}

TEST(SceneSource, RetriesASceneThatCouldNotBeRead) {
  SceneSource scenes = slowSource(1, 1);
  EXPECT_THROW(scenes.at("a"), std::runtime_error);
  EXPECT_EQ(scenes.at("a")->scene.name, "a");
  EXPECT_EQ(SlowReader::reads.at("a"), 2);
}

TEST(SceneSource, ForEachLeavesOutScenesThatCannotBeRead) {
  SceneSource scenes = slowSource(1, 1);
  std::vector<std::string> names;
  const auto problems =
      scenes.forEach([&](const IndexedScene& scene) { names.push_back(scene.scene.name); });
  EXPECT_EQ(names, std::vector<std::string>{"b"});
  EXPECT_EQ(problems, std::vector<std::string>{"a: cannot be read"});
}

TEST(SceneSource, RefusesUnknownScenes) {
  EXPECT_THROW(SceneSource({kDataroot, kVersion}, {"scene-0099"}, config(), 1), NuScenesError);
  SceneSource scenes = source(1);
  EXPECT_THROW(scenes.at("scene-0003"), NuScenesError) << "not among the wanted";
}

}  // namespace
}  // namespace forge
