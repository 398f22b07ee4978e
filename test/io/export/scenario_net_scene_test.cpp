#include "collision_forge/io/export/scenario_net_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "collision_forge/io/export/scenario_net_map.h"
#include "io/export/crash_fixture.h"
#include "io/export/inlined.h"

namespace forge {
namespace {

using testing::HasSubstr;
using testing::Not;

/// straightScene() with a frame every 0.5 s, from 3 s before to 6 s after kNow.
Scene sampleScene() {
  Scene scene = straightScene().scene;
  for (const AgentState& state : scene.ego.states) scene.frame_times.push_back(state.time);
  return scene;
}

std::string told(const Scene& scene, RowTimes rows) {
  return inlined(scenarioNetOf(scene, rows, shippedConfig().exports));
}

std::string arrayItem(const char* key, const std::vector<double>& values, std::size_t columns = 0) {
  const std::string dict =
      inlined([&](PickleWriter& writer) { writer.array(key, values, columns); });
  return dict.substr(1, dict.size() - 2);
}

std::string validItem(const std::vector<bool>& values) {
  const std::string dict = inlined([&](PickleWriter& writer) { writer.flags("valid", values); });
  return dict.substr(1, dict.size() - 2);
}

/// Returns the arrays of a track; `state` returns each row's state.
template <class StateOfRow>
std::string statesItem(const Track& track, std::size_t rows, const StateOfRow& state_of_row) {
  std::vector<double> positions, headings, velocities;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::optional<AgentState> found = state_of_row(row);
    const AgentState state = found.value_or(AgentState{});
    positions.insert(positions.end(), {state.pose.x, state.pose.y, 0.0});
    headings.push_back(state.pose.yaw);
    velocities.insert(velocities.end(), {state.velocity.x(), state.velocity.y()});
  }
  const std::string type = track.agent_class == AgentClass::kBicycle ? "CYCLIST" : "VEHICLE";
  return '"' + track.id + R"(":{"type":")" + type + R"(","state":{)" +
         arrayItem("position", positions, 3) + ',' + arrayItem("heading", headings) + ',' +
         arrayItem("velocity", velocities, 2);
}

TEST(ScenarioNetScene, RowsEveryStepAreBetweenTheFrames) {
  const Scene scene = sampleScene();
  std::vector<double> times;
  for (int i = 0; i <= 90; ++i) times.push_back(i / 10.0);
  const std::string json = told(scene, RowTimes::kEveryStep);
  EXPECT_THAT(json, HasSubstr(R"("sample_rate":0.1,)" + arrayItem("ts", times)));
  EXPECT_THAT(json, HasSubstr(R"("length":91,)"));
  // In sight from 2 s before t0 (row 20) on: the first and last frame are rows of their own.
  std::vector<bool> seen(91, true);
  std::fill(seen.begin(), seen.begin() + 20, false);
  EXPECT_THAT(json, HasSubstr(validItem(seen)));
}

TEST(ScenarioNetScene, RowsOutOfSightAreZero) {
  const Scene scene = sampleScene();
  const Track& bicycle = scene.agents.back();
  ASSERT_EQ(bicycle.id, "bicycle");
  const std::size_t count = scene.frame_times.size();
  EXPECT_THAT(told(scene, RowTimes::kAsRecorded),
              HasSubstr(statesItem(bicycle, count, [&](std::size_t row) {
                return stateAt(bicycle, scene.frame_times[row]);
              })));
  EXPECT_THAT(told(scene, RowTimes::kEveryStep), HasSubstr(statesItem(bicycle, 91, [&](int row) {
                return row % 5 == 0 ? stateAt(bicycle, scene.frame_times[row / 5])
                                    : stateAt(bicycle, scene.frame_times[0] + row / 10.0);
              })));
}

TEST(ScenarioNetScene, FillsFramesWithoutAnnotationOnlyAtEveryStep) {
  Scene scene = sampleScene();
  Track& walker = scene.agents[1];
  ASSERT_EQ(walker.id, "walker");
  walker.states.erase(walker.states.begin() + 3);
  std::vector<bool> seen(scene.frame_times.size(), true);
  seen[3] = false;
  const std::string gap = validItem(seen);
  EXPECT_THAT(told(scene, RowTimes::kAsRecorded), HasSubstr(gap));
  scene.agents = {walker};
  const std::string always = validItem(std::vector<bool>(91, true));
  const std::string json = told(scene, RowTimes::kEveryStep);
  EXPECT_NE(json.find(always), json.rfind(always));  // of the ego and the pedestrian
}

TEST(ScenarioNetScene, MetadataHoldClockFramesAndGround) {
  Scene scene = sampleScene();
  auto map = std::make_shared<LaneMap>(*scene.map);
  map->driving_side = DrivingSide::kLeft;
  map->drivable_area = {{{{-50, -4}, {90, -4}, {90, 4}, {-50, 4}}, {}}};
  scene.map = map;
  std::vector<double> frames;
  for (const double time : scene.frame_times) frames.push_back(time - scene.frame_times[0]);
  const std::string own = inlined([&](PickleWriter& writer) {
    writer.text("scene", "scene-0001");
    writer.number("start", kNow - 3.0);
    writer.array("frame_times", frames);
    writeGround(writer, *map);
  });
  for (const RowTimes rows : {RowTimes::kEveryStep, RowTimes::kAsRecorded}) {
    const std::string json = told(scene, rows);
    EXPECT_THAT(json, HasSubstr(R"("collision_forge":)" + own));
    EXPECT_THAT(json, HasSubstr(R"("current_time_index":0,"sdc_id":"ego")"));
    EXPECT_THAT(json, HasSubstr("ROAD_EDGE_BOUNDARY"));
  }
}

TEST(ScenarioNetScene, FramesWithoutTheEgoAreLeftOut) {
  Scene scene = sampleScene();
  scene.ego.states.erase(scene.ego.states.begin());
  scene.ego.states.pop_back();
  const std::string json = told(scene, RowTimes::kAsRecorded);
  EXPECT_THAT(json, HasSubstr(R"("start":1533153455.9,)"));
  EXPECT_THAT(json, HasSubstr(R"("length":17,)"));
  EXPECT_THAT(told(scene, RowTimes::kEveryStep), HasSubstr(R"("length":81,)"));
}

TEST(ScenarioNetScene, RejectsASceneWithoutTheEgo) {
  Scene scene = sampleScene();
  scene.frame_times.clear();
  EXPECT_THROW(told(scene, RowTimes::kEveryStep), std::runtime_error);
  scene.frame_times = {kNow + 60.0};
  EXPECT_THROW(told(scene, RowTimes::kAsRecorded), std::runtime_error);
}

}  // namespace
}  // namespace forge
