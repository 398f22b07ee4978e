#include "collision_forge/export/scenario_net_description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "collision_forge/files/aside_file.h"
#include "export/pickle_items.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Three rows in a square place of 40 m by 40 m.
std::string scenarioNamed(const std::string& name, std::optional<double> step = 0.1,
                          double radius = 60.0) {
  LaneMap map;
  map.location = "a-town";
  map.drivable_area = {{{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, {}}};
  TrackTable table{{0.0, 0.1, 0.2}, {{"ego", AgentClass::kCar, {4.0, 2.0}, {}}}};
  for (const double time : table.times) {
    table.tracks[0].states.push_back({time, {10.0 * time, 0.0, 0.0}, {10.0, 0.0}});
  }
  PickleWriter own;
  own.text("scene", name);
  ExportOptions options;
  options.radius = radius;
  options.heights[AgentClass::kCar] = 1.5;
  return pickledScenario({name, table, step, 1, map, own}, {{0.0, 0.0}}, options);
}

class ScenarioNetSummary : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string pathOf(const std::string& name) const { return folder_ + "/" + name; }

  std::string read(const std::string& name) const {
    std::ifstream file(pathOf(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const std::string folder_ = testing::TempDir() + "scenario_net_description_test";
};

TEST(ScenarioNetDescription, FilesAreNamedAsTheFormatWants) {
  EXPECT_EQ(scenarioNetFile("scene-0001_7"), "sd_collision_forge_v1_scene-0001_7.pkl");
}

TEST(ScenarioNetDescription, MetadataTellRowsPlaceAndWhoDrivesItself) {
  const std::string bytes = scenarioNamed("s1");
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::count, "length", 3)));
  EXPECT_THAT(bytes, HasSubstr(textItem("map", "a-town")));
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::numbers, "ts", {0.0, 0.1, 0.2}, 0) +
                               item(&PickleWriter::count, "current_time_index", 1) +
                               textItem("sdc_id", "ego")));
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::count, "num_map_features", 1)));
}

TEST(ScenarioNetDescription, RowsThatAreNotEvenHaveNoRate) {
  EXPECT_THAT(scenarioNamed("s1"), HasSubstr(item(&PickleWriter::number, "sample_rate", 0.1)));
  EXPECT_THAT(scenarioNamed("s1", std::nullopt), Not(HasSubstr(pickledText("sample_rate"))));
}

TEST(ScenarioNetDescription, WhatTheFormatHasNoWordForIsAddedToTheOwn) {
  PickleWriter rings;
  rings.numbers("exterior", {-20, -20, 20, -20, 20, 20, -20, 20}, 2);
  rings.matrices("interiors", {}, 2);
  PickleWriter own;
  own.text("scene", "s1");
  own.text("driving_side", "right");
  own.values("drivable_area", {rings.dict()});
  EXPECT_THAT(scenarioNamed("s1"),
              HasSubstr(item(&PickleWriter::value, "collision_forge", own.dict())));
}

TEST(ScenarioNetDescription, TheEdgeOfTheRoadIsToldNearTheWays) {
  EXPECT_THAT(scenarioNamed("s1"),
              HasSubstr(item(&PickleWriter::numbers, "polyline",
                             {-20, -20, 20, -20, 20, 20, -20, 20, -20, -20}, 2)));
  EXPECT_THAT(scenarioNamed("s1", 0.1, 10.0), Not(HasSubstr(pickledText("ROAD_EDGE_BOUNDARY"))));
}

TEST_F(ScenarioNetSummary, OfAllHoldsTheMetadataOfEach) {
  PickleWriter summary;
  PickleWriter mapping;
  for (const std::string name : {"s1", "s2"}) {
    const std::string file = scenarioNetFile(name);
    const std::string bytes = scenarioNamed(name);
    writeText(pathOf(file), bytes);
    const std::string key = pickledText("metadata");
    const std::size_t begin = bytes.rfind(key) + key.size();
    summary.value(file, bytes.substr(begin, bytes.size() - 2 - begin));
    mapping.text(file, "");
  }
  writeScenarioNetSummary(folder_, {"s1", "s2"});
  EXPECT_EQ(read("dataset_summary.pkl"), summary.pickle());
  EXPECT_EQ(read("dataset_mapping.pkl"), mapping.pickle());
}

TEST_F(ScenarioNetSummary, TheNamesOfAFolderAreThoseOfItsScenarios) {
  for (const std::string& file :
       {scenarioNetFile("s2"), scenarioNetFile("s1.a"), std::string("sd_waymo_v1_s3.pkl"),
        scenarioNetFile("s4") + ".part", std::string("dataset_summary.pkl")}) {
    writeText(pathOf(file), "");
  }
  EXPECT_THAT(scenarioNetNames(folder_), ElementsAre("s1.a", "s2"));
}

TEST_F(ScenarioNetSummary, AFileThatIsGoneIsNamed) {
  try {
    writeScenarioNetSummary(folder_, {"gone_1"});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("sd_collision_forge_v1_gone_1.pkl: is no scenario"));
  }
}

}  // namespace
}  // namespace forge
