#include "collision_forge/ros/log_sources.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "collision_forge/data/scenario_net_logs.h"
#include "collision_forge/data/scene_source.h"
#include "collision_forge/ros/bag_file.h"
#include "collision_forge/ros/bag_writer.h"
#include "collision_forge/settings/config.h"
#include "data/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::ElementsAre;

const std::string kEmbedded = COLLISION_FORGE_SOURCE_DIR "/data/embedded";

class LogSourcesTest : public testing::Test {
 protected:
  void writeBagOf(const std::string& scene) {
    const LogSource source{kEmbedded, ""};
    const auto logged = source.format->open(source, {{scene}, config_, {}, {}})->recording(scene);
    writeBag(folder_.path() + "/" + scene + ".bag", logged.recording, logged.lanes->map());
  }

  const TemporaryFolder folder_;
  const Config config_ = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
};

TEST_F(LogSourcesTest, AreKnownByWhatIsThere) {
  EXPECT_EQ(logSourceAt(kEmbedded, "v").format, &nuScenesFormat());
  folder_.write("sd_a.pkl", "");
  EXPECT_EQ(logSourceAt(folder_.path(), "").format, &scenarioNetFormat());
  const std::string bag = folder_.write("a.bag", "");
  EXPECT_EQ(logSourceAt(bag, "").format, &bagFormat());
  EXPECT_EQ(logSourceAt(folder_.path(), "").format, &bagFormat());
}

TEST_F(LogSourcesTest, BagsGiveTheVeryNumbersOfTheTables) {
  writeBagOf("scene-0001");
  writeBagOf("scene-0002");
  SceneSource tables({kEmbedded, ""}, {"scene-0002"}, config_, 1);
  SceneSource bags(logSourceAt(folder_.path(), ""), {}, config_, 1);
  EXPECT_THAT(bags.names(), ElementsAre("scene-0001", "scene-0002"));
  const Scene& expected = tables.at("scene-0002")->scene;
  const Scene& scene = bags.at("scene-0002")->scene;
  EXPECT_EQ(scene.name, "scene-0002");
  EXPECT_EQ(scene.frame_times, expected.frame_times);
  ASSERT_EQ(scene.agents.size(), expected.agents.size());
  for (std::size_t i = 0; i < scene.agents.size(); ++i) {
    EXPECT_EQ(scene.agents[i].id, expected.agents[i].id);
    ASSERT_EQ(scene.agents[i].states.size(), expected.agents[i].states.size());
    EXPECT_EQ(scene.agents[i].states[0].velocity, expected.agents[i].states[0].velocity);
    EXPECT_EQ(scene.agents[i].states[0].time, expected.agents[i].states[0].time);
  }
  ASSERT_EQ(scene.ego.states.size(), expected.ego.states.size());
  EXPECT_NEAR(scene.ego.states[5].velocity.x(), expected.ego.states[5].velocity.x(), 1e-9);
}

TEST_F(LogSourcesTest, ABagAloneIsASource) {
  writeBagOf("scene-0001");
  const LogSource source = logSourceAt(folder_.path() + "/scene-0001.bag", "");
  EXPECT_THAT(readSceneNames(source), ElementsAre("scene-0001"));
  const auto reader = source.format->open(source, {{}, config_, {}, {}});
  EXPECT_EQ(reader->read("scene-0001").scene.name, "scene-0001");
  EXPECT_THROW(reader->recording("scene-0001"), std::runtime_error);
  EXPECT_THROW(readSceneNames({"/nowhere", "", &bagFormat()}), BagError);
}

}  // namespace
}  // namespace forge
