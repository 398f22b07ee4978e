#include "collision_forge/ros/bags/log_sources.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/io/logs/scenario_net_logs.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/bag_writer.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kEmbedded = COLLISION_FORGE_SOURCE_DIR "/data/embedded";

class LogSourcesTest : public testing::Test {
 protected:
  LoggedScene logged(const std::string& scene) const {
    const LogSource source{kEmbedded, ""};
    return source.format->open(source, {{scene}, config_, {}, {}})->recording(scene);
  }

  std::string write(const LoggedScene& logged) const {
    const std::string path = folder_.path() + "/" + logged.recording.name + ".bag";
    writeBag(path, logged.recording, logged.lanes->map());
    return path;
  }

  void writeBagOf(const std::string& scene) const { write(logged(scene)); }

  /// The warnings go to `warnings`, if it is given.
  Scene readSource(const std::string& path, std::vector<std::string>* warnings = nullptr) const {
    const LogSource source = logSourceAt(path, "");
    const OnWarnings keep = [&](const std::string& /*name*/,
                                const std::vector<std::string>& found) {
      if (warnings != nullptr) warnings->insert(warnings->end(), found.begin(), found.end());
    };
    return source.format->open(source, {{}, config_, keep, {}})
        ->read(readSceneNames(source).front())
        .scene;
  }

  const TemporaryFolder folder_;
  const Config config_ = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
};

TEST_F(LogSourcesTest, AreDetectedByTheirFiles) {
  EXPECT_EQ(logSourceAt(kEmbedded, "v").format, &nuScenesFormat());
  folder_.write("sd_a.pkl", "");
  EXPECT_EQ(logSourceAt(folder_.path(), "").format, &scenarioNetFormat());
  const std::string bag = folder_.write("a.bag", "");
  EXPECT_EQ(logSourceAt(bag, "").format, &bagFormat());
  EXPECT_EQ(logSourceAt(folder_.path(), "").format, &bagFormat());
}

TEST_F(LogSourcesTest, BagsGiveExactlyTheNumbersOfTheTables) {
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

TEST_F(LogSourcesTest, ABagIsCheckedAgainstTheInputLimits) {
  LoggedScene far = logged("scene-0001");
  far.recording.ego_poses[0].translation.x() = 1e9;
  const std::string path = write(far);
  EXPECT_THAT(errorOf<InputError>([&] { readSource(path); }),
              AllOf(HasSubstr(path), HasSubstr("ego: states[0].x = 1000000"),
                    HasSubstr("outside -100000 to 100000")));
}

TEST_F(LogSourcesTest, AgentsBeyondTheInputLimitsAreDropped) {
  LoggedScene large = logged("scene-0001");
  ASSERT_FALSE(large.recording.frames[0].annotations.empty());
  const std::string id = large.recording.frames[0].annotations[0].instance;
  for (NuScenesFrame& frame : large.recording.frames) {
    for (NuScenesAnnotation& annotation : frame.annotations) {
      if (annotation.instance == id) annotation.size.x() = 1e9;
    }
  }
  std::vector<std::string> warnings;
  const Scene scene = readSource(write(large), &warnings);
  EXPECT_THAT(warnings, ElementsAre("1 agents with a box beyond the input limits left out "
                                    "(first: " +
                                    id + ")"));
  EXPECT_FALSE(scene.agents.empty());
  for (const Track& agent : scene.agents) EXPECT_NE(agent.id, id);
}

}  // namespace
}  // namespace forge
