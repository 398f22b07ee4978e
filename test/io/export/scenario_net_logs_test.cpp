#include "collision_forge/io/logs/scenario_net_logs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <stdexcept>

#include "collision_forge/io/export/pickle_writer.h"
#include "collision_forge/io/export/scenario_net_scene.h"
#include "collision_forge/io/logs/scene_source.h"
#include "io/export/crash_fixture.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kEmbedded = COLLISION_FORGE_SOURCE_DIR "/data/embedded";

/// A description with ScenarioNet's own fields only, as converters of other data sets write it.
struct Description {
  void writeTrack(PickleWriter& writer, const char* id, const char* type) const {
    writer.beginObject(id);
    writer.text("type", type);
    writer.beginObject("state");
    writer.array("position", {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, 3);
    writer.array("heading", {0.0, 0.0});
    writer.array("length", {length, length});
    writer.array("width", {width, width});
    writer.flags("valid", {true, true});
    writer.endObject();
    writer.endObject();
  }

  PickleContent content() const {
    PickleWriter writer;
    writer.beginObject("tracks");
    writeTrack(writer, "7", "VEHICLE");
    writeTrack(writer, "8", "VEHICLE");
    writeTrack(writer, "9", "TRAFFIC_CONE");
    writer.endObject();
    writer.beginObject("map_features");
    writer.beginObject("12");
    writer.text("type", "LANE_SURFACE_STREET");
    writer.array("polyline", {0.0, 0.0, 10.0, 0.0}, 2);
    writer.texts("exit_lanes", {"13", "nowhere"});
    writer.number("speed_limit_kmh", 36.0);
    writer.endObject();
    writer.beginObject("13");
    writer.text("type", lane_type);
    writer.array("polyline", {10.0, 0.0, lane_end, 0.0}, 2);
    writer.endObject();
    writer.endObject();
    writer.beginObject("metadata");
    writer.text("sdc_id", ego);
    writer.array("ts", times);
    writer.endObject();
    return writer.content();
  }

  double length = 4.6;
  double width = 2.0;
  const char* lane_type = "LANE_SURFACE_UNSTRUCTURE";
  double lane_end = 20.0;
  std::string ego = "7";
  std::vector<double> times{0.0, 0.1};
};

class ScenarioNetLogsTest : public testing::Test {
 protected:
  LoggedScene read(const PickleContent& content) { return readBytes(workers_.write(content)); }

  LoggedScene readBytes(const std::string& bytes) {
    warnings_.clear();
    return readScenarioNet(folder_.write("sd_waymo_v1_a.pkl", bytes), workers_, shippedConfig(),
                           &warnings_);
  }

  std::string problemOf(const Description& description) {
    try {
      read(description.content());
      return "";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }

  /// A description with more map features, in JSON.
  static PickleContent withFeatures(const std::string& features) {
    PickleContent content = Description().content();
    const std::string key = R"("map_features":{)";
    content.json.insert(content.json.find(key) + key.size(), features);
    return content;
  }

  /// A description whose first value of a key is `value`, in JSON.
  static PickleContent with(const std::string& key, const std::string& value) {
    PickleContent content = Description().content();
    std::string& json = content.json;
    const std::size_t found = json.find('"' + key + "\":");
    EXPECT_NE(found, std::string::npos) << key;
    const std::size_t begin = found + key.size() + 3;
    int depth = 0;
    std::size_t end = begin;
    for (; depth > 0 || (json[end] != ',' && json[end] != '}'); ++end) {
      if (json[end] == '{' || json[end] == '[') ++depth;
      if (json[end] == '}' || json[end] == ']') --depth;
    }
    json.replace(begin, end - begin, value);
    return content;
  }

  const TemporaryFolder folder_;
  PickleWorkers workers_;
  std::vector<std::string> warnings_;
};

TEST_F(ScenarioNetLogsTest, RoundTripsARecording) {
  SceneSource tables({kEmbedded, ""}, {"scene-0001"}, shippedConfig(), 1);
  const auto told = tables.at("scene-0001");
  folder_.write(
      "deep/sd_collision_forge_v1_scene-0001.pkl",
      workers_.write(scenarioNetOf(told->scene, RowTimes::kAsRecorded, shippedConfig().exports)));
  ASSERT_TRUE(scenarioNetFormat().accepts(folder_.path()));
  SceneSource source({folder_.path(), "", &scenarioNetFormat()}, {}, shippedConfig(), 1);
  EXPECT_THAT(source.names(), ElementsAre("scene-0001"));
  const Scene& back = source.at("scene-0001")->scene;
  EXPECT_EQ(back.frame_times, told->scene.frame_times);
  ASSERT_EQ(back.ego.states.size(), told->scene.ego.states.size());
  for (std::size_t i = 0; i < back.ego.states.size(); ++i) {
    EXPECT_EQ(back.ego.states[i].time, told->scene.ego.states[i].time);
    EXPECT_NEAR(back.ego.states[i].pose.x, told->scene.ego.states[i].pose.x, 1e-9);
  }
  ASSERT_EQ(back.agents.size(), told->scene.agents.size());
  for (const Track& agent : told->scene.agents) {
    const auto same = std::find_if(back.agents.begin(), back.agents.end(),
                                   [&](const Track& other) { return other.id == agent.id; });
    ASSERT_NE(same, back.agents.end());
    EXPECT_EQ(same->agent_class, agent.agent_class);
    ASSERT_EQ(same->states.size(), agent.states.size());
    for (std::size_t i = 0; i < agent.states.size(); ++i) {
      EXPECT_EQ(same->states[i].time, agent.states[i].time);
      EXPECT_EQ(same->states[i].velocity, agent.states[i].velocity);
      EXPECT_NEAR(same->states[i].pose.yaw, agent.states[i].pose.yaw, 1e-12);
    }
  }
  const LaneMap& map = *told->scene.map;
  ASSERT_EQ(back.map->lanes.size(), map.lanes.size());
  for (std::size_t i = 0; i < map.lanes.size(); ++i) {
    EXPECT_EQ(back.map->lanes[i].id, map.lanes[i].id);
    EXPECT_EQ(back.map->lanes[i].is_connector, map.lanes[i].is_connector);
    EXPECT_EQ(back.map->lanes[i].is_intersection, map.lanes[i].is_intersection);
    EXPECT_EQ(back.map->lanes[i].outgoing, map.lanes[i].outgoing);
    EXPECT_EQ(back.map->lanes[i].polygon, map.lanes[i].polygon);
  }
  EXPECT_EQ(back.map->drivable_area.size(), map.drivable_area.size());
  EXPECT_EQ(back.map->driving_side, map.driving_side);
}

TEST_F(ScenarioNetLogsTest, ReadsDescriptionsOfOtherConverters) {
  const LoggedScene logged = read(Description().content());
  EXPECT_EQ(logged.recording.name, "sd_waymo_v1_a");
  EXPECT_EQ(logged.recording.ego_poses.at(0).timestamp_us, 1000000);
  EXPECT_NEAR(logged.recording.ego_poses.at(1).translation.x(),
              1.0 - shippedConfig().ego_vehicle.center_offset, 1e-12);
  const auto& agents = logged.recording.frames.at(1).annotations;
  ASSERT_EQ(agents.size(), 2U);
  EXPECT_EQ(agents[0].category, "vehicle.car");
  EXPECT_EQ(agents[1].category, "movable_object");
  EXPECT_NEAR(agents[0].velocity.x(), 10.0, 1e-9);
  ASSERT_EQ(logged.lanes->map().lanes.size(), 2U);
  const Lane& first = logged.lanes->map().lanes[0];
  EXPECT_THAT(first.outgoing, ElementsAre("13"));
  EXPECT_NEAR(*first.speed_limit, 10.0, 1e-12);
  EXPECT_EQ(first.polygon.size(), 4U);
  EXPECT_NEAR(first.polygon.at(0).y(), 0.5 * kLaneWidth, 1e-12);
  EXPECT_THAT(logged.lanes->map().lanes[1].incoming, ElementsAre("12"));
  EXPECT_TRUE(logged.lanes->map().lanes[1].is_connector);
  EXPECT_EQ(logged.lanes->map().drivable_area.size(), 2U);
  ASSERT_TRUE(logged.recording.ego_size);
  EXPECT_EQ(logged.recording.ego_size->length, 4.6);
  EXPECT_EQ(logged.recording.ego_size->width, 2.0);
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(ScenarioNetLogsTest, TheEgoHasTheBoxOfTheFile) {
  Description description;
  description.length = 5.286;
  description.width = 2.332;
  const LoggedScene logged = read(description.content());
  const Scene scene = toScene(logged.recording, shippedConfig().ego_vehicle, nullptr);
  EXPECT_EQ(scene.ego.size.length, 5.286);
  EXPECT_EQ(scene.ego.size.width, 2.332);
  EXPECT_NEAR(scene.ego.states.at(1).pose.x, 1.0, 1e-9) << "the middle of the box";
}

TEST_F(ScenarioNetLogsTest, TheTypeOfMetadataGivesTheClass) {
  PickleContent content = Description().content();
  const std::string type = R"("8":{"type":"VEHICLE",)";
  content.json.replace(content.json.find(type), type.size(),
                       type + R"("metadata":{"type":"Motorcyclist"},)");
  EXPECT_EQ(read(content).recording.frames.at(0).annotations.at(0).category, "vehicle.motorcycle")
      << "by categories.yaml";
}

TEST_F(ScenarioNetLogsTest, ANumberThatIsNotFiniteCostsItsState) {
  PickleContent content = Description().content();
  // The x of the second row of agent 8, after the 14 numbers of agent 7.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::memcpy(&content.items[8 * (14 + 3)], &nan, sizeof(nan));
  const NuScenesRecording recording = read(content).recording;
  EXPECT_EQ(recording.frames.at(0).annotations.size(), 2U);
  EXPECT_EQ(recording.frames.at(1).annotations.size(), 1U);
  EXPECT_THAT(warnings_, ElementsAre("8: 1 state with a number that is not finite left out"));
}

TEST_F(ScenarioNetLogsTest, AnAgentWithoutASizeHasTheTypicalOneOfItsType) {
  PickleContent content = Description().content();
  const std::size_t second = content.json.find(R"("8":)");
  const std::size_t begin = content.json.find(R"("length":)", second);
  content.json.replace(begin, 8, R"("other_")");
  const NuScenesAnnotation agent = read(content).recording.frames.at(0).annotations.at(0);
  EXPECT_GT(agent.size.x(), 4.0);
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("1 agent without a size (first: 8)")));
}

TEST_F(ScenarioNetLogsTest, AnAgentThatCannotBeReadCostsItselfAlone) {
  PickleContent content = Description().content();
  const std::size_t second = content.json.find(R"("8":)");
  content.json.replace(content.json.find(R"("heading":)", second), 9, R"("heading_")");
  EXPECT_EQ(read(content).recording.frames.at(0).annotations.size(), 1U);
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("tracks.8.state: lacks \"heading\"")));
}

TEST_F(ScenarioNetLogsTest, ALaneThatCannotBeReadCostsItselfAlone) {
  PickleContent content = Description().content();
  const std::size_t second = content.json.find(R"("13":)");
  content.json.replace(content.json.find(R"("polyline":)", second), 10, R"("polylin_")");
  EXPECT_EQ(read(content).lanes->map().lanes.size(), 1U);
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("map_features.13: lacks \"polyline\"")));
}

TEST_F(ScenarioNetLogsTest, LanesOfBicyclesAreNoLanesOfMotorVehicles) {
  Description description;
  description.lane_type = "LANE_BIKE_LANE";
  const LoggedScene logged = read(description.content());
  EXPECT_EQ(logged.lanes->map().lanes.size(), 1U);
  EXPECT_EQ(logged.lanes->map().drivable_area.size(), 1U);
}

TEST_F(ScenarioNetLogsTest, PaintedLinesAndLanesOfBicyclesAreFeatures) {
  const LoggedScene logged = read(
      withFeatures(R"("1":{"type":"ROAD_LINE_PASSING_DOUBLE_YELLOW","polyline":[[0,2],[9,2]]},)"
                   R"("2":{"type":"ROAD_LINE_SOLID_DOUBLE_WHITE","polyline":[[0,3],[9,3]]},)"
                   R"("3":{"type":"LANE_BIKE_LANE","polyline":[[0,-3],[5,-3],[9,-3]]},)"));
  const auto& features = logged.lanes->map().features;
  ASSERT_EQ(features.size(), 3U);
  EXPECT_EQ(features[0].kind, FeatureKind::kBrokenYellowLine);
  EXPECT_EQ(features[1].kind, FeatureKind::kSolidWhiteLine);
  EXPECT_EQ(features[2].kind, FeatureKind::kBikeLane);
  EXPECT_EQ(features[2].points.size(), 3U);
}

TEST_F(ScenarioNetLogsTest, TheRoadIsBetweenTheRoadEdges) {
  const LoggedScene logged =
      read(withFeatures(R"("1":{"type":"ROAD_EDGE_BOUNDARY","polyline":[[0,-4],[20,-4]]},)"
                        R"("2":{"type":"ROAD_EDGE_MEDIAN","polyline":[[20,3],[0,3]]},)"
                        R"("3":{"type":"CROSSWALK","polygon":[[0,-4],[3,-4],[3,3],[0,3]]},)"));
  const LaneMap& map = logged.lanes->map();
  ASSERT_EQ(map.features.size(), 3U);
  EXPECT_EQ(map.features[0].kind, FeatureKind::kRoadEdge);
  EXPECT_EQ(map.features[1].kind, FeatureKind::kMedian);
  EXPECT_EQ(map.features[2].points.size(), 4U);
  EXPECT_NEAR(*logged.lanes->offRoadShare({{10.0, -0.5, 0.0}, {18.0, 6.8}}), 0.0, 1e-9);
  EXPECT_GT(*logged.lanes->offRoadShare({{10.0, -0.5, 0.0}, {18.0, 8.0}}), 0.05);
}

TEST_F(ScenarioNetLogsTest, ARoadEdgeBeyondTheLimitsCostsItselfAlone) {
  const LoggedScene logged =
      read(withFeatures(R"("1":{"type":"ROAD_EDGE_BOUNDARY","polyline":[[0, 3], [1e30, 3]]},)"
                        R"("2":{"type":"ROAD_EDGE_BOUNDARY","polyline":[[0, -3], [20, -3]]},)"));
  EXPECT_EQ(logged.lanes->map().features.size(), 1U);
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("1 map feature beyond the limits")));
}

TEST_F(ScenarioNetLogsTest, TrafficLightsHaveTheirStatesAndStopPoints) {
  PickleContent content = Description().content();
  content.json.insert(1, R"("dynamic_map_states":{)"
                         R"("13":{"lane":13,"state":{"object_state":["LANE_STATE_STOP",null]}},)"
                         R"("12":{"lane":"12","state":{"object_state":["LANE_STATE_GO"]}},)"
                         R"("99":{"lane":99,"state":{"object_state":["LANE_STATE_GO",null]}}},)");
  const auto lights = read(content).recording.lights;
  ASSERT_EQ(lights.size(), 1U) << "no lane 99";
  EXPECT_EQ(lights[0].lane, "13");
  EXPECT_EQ(lights[0].stop_point, Vector2(10.0, 0.0)) << "where the lane begins";
  ASSERT_EQ(lights[0].states.size(), 2U);
  EXPECT_EQ(lights[0].states[0].color, LightColor::kRed);
  EXPECT_NEAR(lights[0].states[1].time, 1.1, 1e-12);
  EXPECT_EQ(lights[0].states[1].color, LightColor::kUnknown);
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("1 traffic light that cannot be read left out")));
}

TEST_F(ScenarioNetLogsTest, TrafficLightsThatAreNoDictCostThemselvesAlone) {
  PickleContent content = Description().content();
  content.json.insert(1, R"("dynamic_map_states":["LANE_STATE_STOP"],)");
  EXPECT_THAT(read(content).recording.lights, IsEmpty());
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("traffic light that cannot be read")));
}

TEST_F(ScenarioNetLogsTest, AnAgentHasItsMedianSize) {
  PickleContent content = Description().content();
  // The first length of agent 8: the items of a track are 6 positions, 2 headings, 2 lengths, ...
  const double small = 1.0;
  std::memcpy(&content.items[8 * (14 + 8)], &small, sizeof(small));
  EXPECT_EQ(read(content).recording.frames.at(0).annotations.at(0).size.x(), 4.6);
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("size is not typical of the track (first: 8)")));
}

TEST_F(ScenarioNetLogsTest, APolylineMayBeAListOfPoints) {
  PickleContent content = Description().content();
  const std::string array = R"({"ndarray":[2,2],"dtype":"f8","at":)";
  const std::size_t begin = content.json.find(array);
  content.json.replace(begin, content.json.find('}', begin) + 1 - begin,
                       "[[0, 0.5], [10, 0.5, 3]]");
  const Lane lane = read(content).lanes->map().lanes.at(0);
  ASSERT_EQ(lane.centerline.size(), 2U);
  EXPECT_EQ(lane.centerline[1].x, 10.0);
  EXPECT_EQ(lane.centerline[1].y, 0.5);
}

TEST_F(ScenarioNetLogsTest, LongVehiclesAreTrucksAndAWideEgoIsSwapped) {
  Description description;
  description.length = 2.0;
  description.width = 9.0;
  read(description.content());
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("are swapped")));
  std::swap(description.length, description.width);
  EXPECT_EQ(read(description.content()).recording.frames.at(0).annotations.at(0).category,
            "vehicle.truck");
}

TEST_F(ScenarioNetLogsTest, ASpeedLimitThatCannotBeUsedIsNone) {
  for (const char* value : {"NaN", "-3", "1e9", "\"fast\"", "[3]"}) {
    const Lane lane = read(with("speed_limit_kmh", value)).lanes->map().lanes.at(0);
    EXPECT_EQ(lane.id, "12");
    EXPECT_FALSE(lane.speed_limit) << value;
  }
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("1 value that cannot be read not used")));
}

TEST_F(ScenarioNetLogsTest, ALinkThatCannotBeReadCostsItselfAlone) {
  EXPECT_THAT(read(with("exit_lanes", R"([null, 13, {"a": 1}])")).lanes->map().lanes.at(0).outgoing,
              ElementsAre("13"));
  EXPECT_THAT(read(with("exit_lanes", "1.5")).lanes->map().lanes.at(0).outgoing, IsEmpty());
}

TEST_F(ScenarioNetLogsTest, ColumnsMayBeListsOfNumbers) {
  const LoggedScene logged = read(with("heading", "[0.5, null]"));
  ASSERT_EQ(logged.recording.ego_poses.size(), 1U) << "the second heading is not a number";
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("1 state with a number that is not finite")));
}

TEST_F(ScenarioNetLogsTest, ALengthThatCannotBeReadIsTypical) {
  EXPECT_FALSE(read(with("length", R"("long")")).recording.ego_size);
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("1 value that cannot be read not used")));
}

TEST_F(ScenarioNetLogsTest, ASceneWithoutAMapHasNoLanes) {
  EXPECT_THAT(read(with("map_features", "null")).lanes->map().lanes, IsEmpty());
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("no lane in map_features")));
}

TEST_F(ScenarioNetLogsTest, ALaneBeyondTheLimitsCostsItselfAlone) {
  Description description;
  description.lane_end = 1e9;
  const LaneMap map = read(description.content()).lanes->map();
  ASSERT_EQ(map.lanes.size(), 1U);
  EXPECT_THAT(map.lanes[0].outgoing, IsEmpty());
  EXPECT_THAT(warnings_, Contains(HasSubstr("1 lane beyond the limits of input_limits.yaml")));
}

TEST_F(ScenarioNetLogsTest, ErrorsNameFileAndField) {
  Description no_ego;
  no_ego.ego = "70";
  EXPECT_THAT(problemOf(no_ego), HasSubstr("tracks: lacks the ego \"70\" of metadata.sdc_id"));
  Description backwards;
  backwards.times = {0.1, 0.0};
  EXPECT_THAT(problemOf(backwards), HasSubstr("metadata.ts: row 1 is not after"));
  Description longer;
  longer.times = {0.0, 0.1, 0.2};
  EXPECT_THAT(problemOf(longer), HasSubstr("tracks.7.state.position: has 2 rows, not 3"));
  EXPECT_THROW(read({R"({"metadata": {}})", ""}), std::runtime_error);
  EXPECT_THROW(readBytes("cos\nsystem\n."), PickleError);
}

}  // namespace
}  // namespace forge
