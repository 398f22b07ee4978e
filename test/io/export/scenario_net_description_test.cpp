#include "collision_forge/io/export/scenario_net_description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "collision_forge/base/files/aside_file.h"
#include "io/export/inlined.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Three rows on a square area of 40 m by 40 m.
PickleContent scenarioNamed(const std::string& name, std::optional<double> step = 0.1,
                            double radius = 60.0, const std::vector<MapFeature>& features = {},
                            const std::vector<TrafficLight>& lights = {}) {
  LaneMap map;
  map.features = features;
  map.location = "a-town";
  map.drivable_area = {{{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, {}}};
  TrackTable table{{0.0, 0.1, 0.2}, {{"ego", AgentClass::kCar, {4.0, 2.0}, {}, 1.5}}};
  for (const double time : table.times) {
    table.tracks[0].states.push_back({time, {10.0 * time, 0.0, 0.0}, {10.0, 0.0}});
  }
  const auto write_own = [&](PickleWriter& own) { own.text("scene", name); };
  ExportOptions options;
  options.radius = radius;
  return describe({name, table, step, 1, map, lights, write_own}, {{0.0, 0.0}}, options);
}

class ScenarioNetSummary : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string pathOf(const std::string& name) const { return folder_ + "/" + name; }

  const std::string folder_ = testing::TempDir() + "scenario_net_description_test";
  PickleWorkers workers_;
};

TEST(ScenarioNetDescription, MetadataHoldRowsPlaceAndEgo) {
  const std::string json = inlined(scenarioNamed("s1"));
  EXPECT_THAT(json, HasSubstr(R"("length":3,)"));
  EXPECT_THAT(json, HasSubstr(R"("map":"a-town")"));
  EXPECT_THAT(json, HasSubstr(R"("ts":[0,0.1,0.2],"current_time_index":1,"sdc_id":"ego")"));
  EXPECT_THAT(json, HasSubstr(R"("num_map_features":1)"));
}

TEST(ScenarioNetDescription, AddsFieldsThatTheFormatDoesNotDefine) {
  EXPECT_THAT(inlined(scenarioNamed("s1")),
              HasSubstr(R"("collision_forge":{"scene":"s1","driving_side":"right",)"
                        R"("drivable_area":[{"exterior":[[-20,-20],[20,-20],[20,20],[-20,20]],)"
                        R"("interiors":[]}]})"));
}

TEST(ScenarioNetDescription, WritesRoadEdgesNearThePaths) {
  EXPECT_THAT(inlined(scenarioNamed("s1")),
              HasSubstr(R"("polyline":[[-20,-20],[20,-20],[20,20],[-20,20],[-20,-20]])"));
  EXPECT_THAT(inlined(scenarioNamed("s1", 0.1, 10.0)), Not(HasSubstr("ROAD_EDGE_BOUNDARY")));
}

TEST(ScenarioNetDescription, RecordedFeaturesReplaceTheEdgesOfTheArea) {
  const std::string json =
      inlined(scenarioNamed("s1", 0.1, 60.0,
                            {{FeatureKind::kMedian, {{0, 9}, {9, 9}}},
                             {FeatureKind::kCrosswalk, {{0, 0}, {1, 0}, {1, 1}}}}));
  EXPECT_THAT(json,
              HasSubstr(R"("edge_0":{"type":"ROAD_EDGE_MEDIAN","polyline":[[0,9],[9,9]]},)"
                        R"("feature_1":{"type":"CROSSWALK","polygon":[[0,0],[1,0],[1,1]]}})"));
  EXPECT_THAT(json, Not(HasSubstr("ROAD_EDGE_BOUNDARY")));
}

TEST(ScenarioNetDescription, WritesTheLightsInRows) {
  const TrafficLight light{"7", {1.0, 2.0}, {{0.1, LightColor::kRed}, {0.2, LightColor::kGreen}}};
  const std::string json = inlined(scenarioNamed("s1", 0.1, 60.0, {}, {light}));
  EXPECT_THAT(json, HasSubstr(R"("dynamic_map_states":{"7":{"type":"TRAFFIC_LIGHT","state":{)"
                              R"("object_state":["TRAFFIC_LIGHT_UNKNOWN","TRAFFIC_LIGHT_RED",)"
                              R"("TRAFFIC_LIGHT_GREEN"]},"lane":"7","stop_point":[1,2,0],)"));
  EXPECT_THAT(json, HasSubstr(R"("num_traffic_lights":1)"));
}

TEST_F(ScenarioNetSummary, ListsAllFiles) {
  for (const std::string name : {"s1", "s2"}) {
    writeText(pathOf(scenarioNetFile(name)), workers_.write(scenarioNamed(name)));
  }
  writeScenarioNetSummary(folder_, {"s1", "s2"}, workers_);
  EXPECT_TRUE(std::filesystem::exists(pathOf("dataset_summary.pkl")));
  EXPECT_TRUE(std::filesystem::exists(pathOf("dataset_mapping.pkl")));
}

TEST_F(ScenarioNetSummary, TheNamesOfAFolderAreThoseOfItsScenarios) {
  for (const std::string& file :
       {scenarioNetFile("s2"), scenarioNetFile("s1.a"), std::string("sd_waymo_v1_s3.pkl"),
        scenarioNetFile("s4") + ".part", std::string("dataset_summary.pkl")}) {
    writeText(pathOf(file), "");
  }
  EXPECT_THAT(scenarioNetNames(folder_), ElementsAre("s1.a", "s2"));
}

}  // namespace
}  // namespace forge
