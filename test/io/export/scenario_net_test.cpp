#include "collision_forge/io/export/scenario_net.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "collision_forge/base/files/plain_name.h"
#include "io/export/inlined.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kStep = 0.1;  // s

/// States at steps, 10 m/s along x from x = 10 * time.
std::vector<AgentState> statesAt(std::initializer_list<int> steps, double y) {
  std::vector<AgentState> states;
  for (const int step : steps) {
    states.push_back({step * kStep, {step * 1.0, y, 0.25}, {10.0, 0.0}});
  }
  return states;
}

CrashRecord sampleRecord() {
  CrashRecord record;
  record.name = "scene-0001_7";
  record.scenario.asked.scene = "scene-0001";
  record.scenario.asked.request.seed = 3000000000U;
  record.scenario.answer.report.manoeuvre = Manoeuvre::kCutIn;
  record.step = kStep;
  record.now = 0.2;
  record.contact = 0.35;
  record.ego = {kEgoId, AgentClass::kCar, {4.0, 2.0}, statesAt({0, 1, 2, 3}, 0.0), 1.5};
  record.attacker = {"a1", AgentClass::kTruck, {8.0, 2.5}, statesAt({1, 2, 3}, 4.0), 1.5};
  record.other_agents = {{"b1", AgentClass::kPedestrian, {0.5, 0.75}, statesAt({0, 3}, -9.0), 1.5}};
  record.lanes.location = "a-town";
  return record;
}

ExportPlan planIn(const std::string& folder) {
  ExportPlan plan;
  plan.folder = folder;
  plan.options.radius = 60.0;
  return plan;
}

class ScenarioNet : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Returns the path of the record's file.
  std::string fileOf(const CrashRecord& record) const {
    return pathIn(folder_, makeScenarioNetWriter(planIn(folder_))->write(record).at(0));
  }

  /// Returns the content of the record's file as JSON.
  std::string written(const CrashRecord& record) const {
    return inlined(PickleWorkers().read(fileOf(record)));
  }

  const std::string folder_ = testing::TempDir() + "scenario_net_test";
};

TEST_F(ScenarioNet, WritesRoadEdgesAlongEgoAndAttacker) {
  CrashRecord record = sampleRecord();
  const std::string edge = "ROAD_EDGE_BOUNDARY";
  record.lanes.drivable_area = {{{{500, 0}, {540, 0}, {540, 40}}, {}}};
  EXPECT_EQ(written(record).find(edge), std::string::npos);
  record.attacker.states.back().pose.x = 520.0;
  EXPECT_NE(written(record).find(edge), std::string::npos);
}

TEST_F(ScenarioNet, MetadataHoldRequestAndResult) {
  const std::string json = written(sampleRecord());
  EXPECT_THAT(json, HasSubstr(R"("collision_forge":{"scene":"scene-0001","type":"rear_end",)"
                              R"("mode":"history","tta":4.0,"seed":3000000000,)"
                              R"("manoeuvre":"cut_in","attacker":"a1","attacker_is_added":false,)"
                              R"("now":0.2,"contact_time":0.35,"driving_side":"right",)"
                              R"("drivable_area":[]})"));
  EXPECT_THAT(json, HasSubstr(R"("current_time_index":2)"));
}

TEST_F(ScenarioNet, AnAttackerThatMissesHasNoContactTime) {
  CrashRecord record = sampleRecord();
  record.contact.reset();
  EXPECT_THAT(written(record), HasSubstr(R"("contact_time":null)"));
}

TEST_F(ScenarioNet, TheSummaryIsOfAllCrashes) {
  const auto writer = makeScenarioNetWriter(planIn(folder_));
  writer->write(sampleRecord());
  writer->finish({{"scene-0001_7", "scene-0001", "a-town", 4}});
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/dataset_summary.pkl"));
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/dataset_mapping.pkl"));
}

}  // namespace
}  // namespace forge
