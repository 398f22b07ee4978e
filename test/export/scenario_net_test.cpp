#include "collision_forge/export/scenario_net.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <tuple>

#include "collision_forge/export/pickle_writer.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double kStep = 0.1;  // s

/// States at steps, 10 m/s along x from x = 10 * time.
std::vector<AgentState> statesAt(std::initializer_list<int> steps, double y) {
  std::vector<AgentState> states;
  for (const int step : steps) {
    states.push_back({step * kStep, {step * 1.0, y, 0.25}, {10.0, 0.0}});
  }
  return states;
}

Lane lane(const std::string& id, double x) {
  Lane lane;
  lane.id = id;
  lane.centerline = {{x, 0.0, 0.0}, {x + 20.0, 0.0, 0.0}};
  return lane;
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
  record.ego = {kEgoId, AgentClass::kCar, {4.0, 2.0}, statesAt({0, 1, 2, 3}, 0.0)};
  record.attacker = {"a1", AgentClass::kTruck, {8.0, 2.5}, statesAt({1, 2, 3}, 4.0)};
  record.others = {{"b1", AgentClass::kPedestrian, {0.5, 0.75}, statesAt({0, 3}, -9.0)}};
  record.lanes.location = "a-town";
  return record;
}

ExportPlan planIn(const std::string& folder) {
  ExportPlan plan;
  plan.folder = folder;
  plan.options.radius = 60.0;
  for (const AgentClass agent_class :
       {AgentClass::kCar, AgentClass::kTruck, AgentClass::kMotorcycle, AgentClass::kBicycle,
        AgentClass::kPedestrian, AgentClass::kAnimal, AgentClass::kStaticObject}) {
    plan.options.heights[agent_class] = 1.5;
  }
  return plan;
}

/// An item of a dict as its bytes.
template <class... Arguments>
std::string item(void (PickleWriter::*write)(const std::string&, Arguments...),
                 const std::string& key, std::decay_t<Arguments>... arguments) {
  PickleWriter writer;
  (writer.*write)(key, arguments...);
  const std::string dict = writer.dict();
  return dict.substr(2, dict.size() - 3);
}

std::string textItem(const std::string& key, const std::string& value) {
  return item(&PickleWriter::text, key, value);
}

class ScenarioNet : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string read(const std::string& name) const {
    std::ifstream file(std::filesystem::path(folder_) / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// The bytes of the record's file.
  std::string written(const CrashRecord& record) const {
    return read(makeScenarioNetWriter(planIn(folder_))->write(record).at(0));
  }

  const std::string folder_ = testing::TempDir() + "scenario_net_test";
};

TEST_F(ScenarioNet, FilesAreNamedAsTheFormatWants) {
  EXPECT_THAT(makeScenarioNetWriter(planIn(folder_))->write(sampleRecord()),
              ElementsAre("sd_collision_forge_v1_scene-0001_7.pkl"));
}

TEST_F(ScenarioNet, TheSameRecordGivesTheSameBytes) {
  const std::string once = written(sampleRecord());
  EXPECT_GT(once.size(), 1000u);
  EXPECT_EQ(written(sampleRecord()), once);
}

TEST_F(ScenarioNet, TracksHaveARowAStepAndZerosWhereNobodyIsSeen) {
  const std::string bytes = written(sampleRecord());
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::count, "length", 4)));
  PickleWriter state;
  state.numbers("position", {0, 0, 0, 1, 4, 0, 2, 4, 0, 3, 4, 0}, 3);
  state.numbers("heading", {0, 0.25, 0.25, 0.25});
  state.numbers("velocity", {0, 0, 10, 0, 10, 0, 10, 0}, 2);
  state.numbers("length", {0, 8, 8, 8});
  state.numbers("width", {0, 2.5, 2.5, 2.5});
  state.numbers("height", {0, 1.5, 1.5, 1.5});
  state.flags("valid", {false, true, true, true});
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::value, "state", state.dict())));
}

TEST_F(ScenarioNet, ATrackOutOfSightForATimeIsZeroThere) {
  EXPECT_THAT(written(sampleRecord()),
              HasSubstr(item(&PickleWriter::flags, "valid", {true, false, false, true})));
}

TEST_F(ScenarioNet, TheEgoIsTheSelfDrivingCar) {
  const std::string bytes = written(sampleRecord());
  EXPECT_THAT(bytes, HasSubstr(textItem("sdc_id", kEgoId)));
  EXPECT_THAT(bytes, HasSubstr(textItem("object_id", kEgoId)));
}

TEST_F(ScenarioNet, EveryClassHasATypeOfTheFormat) {
  for (const auto& [agent_class, length, type] :
       {std::tuple(AgentClass::kMotorcycle, 2.0, "CYCLIST"),
        std::tuple(AgentClass::kBicycle, 2.0, "CYCLIST"),
        std::tuple(AgentClass::kTruck, 8.0, "VEHICLE"),
        std::tuple(AgentClass::kPedestrian, 0.5, "PEDESTRIAN"),
        std::tuple(AgentClass::kAnimal, 0.5, "OTHER"),
        std::tuple(AgentClass::kStaticObject, 0.4, "TRAFFIC_CONE"),
        std::tuple(AgentClass::kStaticObject, 2.5, "TRAFFIC_BARRIER")}) {
    CrashRecord record = sampleRecord();
    record.others[0].agent_class = agent_class;
    record.others[0].size.length = length;
    EXPECT_THAT(written(record),
                HasSubstr(textItem("type", type) + textItem("class", toString(agent_class)) +
                          textItem("object_id", "b1")));
  }
}

TEST_F(ScenarioNet, ABarrierMayStandAcross) {
  CrashRecord record = sampleRecord();
  record.others[0].agent_class = AgentClass::kStaticObject;
  record.others[0].size = {0.5, 2.5};
  EXPECT_THAT(written(record), HasSubstr(textItem("type", "TRAFFIC_BARRIER")));
}

TEST_F(ScenarioNet, TheMetadataTellWhatWasAskedForAndAnswered) {
  const std::string bytes = written(sampleRecord());
  PickleWriter crash;
  crash.text("scene", "scene-0001");
  crash.text("type", "rear_end");
  crash.text("mode", "history");
  crash.number("tta", 4.0);
  crash.count("seed", 3000000000U);
  crash.text("manoeuvre", "cut_in");
  crash.text("attacker", "a1");
  crash.flag("attacker_is_added", false);
  crash.number("now", 0.2);
  crash.number("contact_time", 0.35);
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::value, "collision_forge", crash.dict())));
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::count, "current_time_index", 2)));
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::numbers, "ts",
                                    {0 * kStep, 1 * kStep, 2 * kStep, 3 * kStep}, 0)));
}

TEST_F(ScenarioNet, AnAttackerThatMissesHasNoContactTime) {
  CrashRecord record = sampleRecord();
  record.contact.reset();
  EXPECT_THAT(written(record), HasSubstr(item(&PickleWriter::none, "contact_time")));
}

TEST_F(ScenarioNet, TheSummaryOfATrackTellsItsWayAndHowLongItIsSeen) {
  PickleWriter summary;
  summary.text("type", "PEDESTRIAN");
  summary.text("object_id", "b1");
  summary.count("track_length", 4);
  summary.number("moving_distance", 3.0);
  summary.count("valid_length", 2);
  summary.count("continuous_valid_length", 1);
  EXPECT_THAT(written(sampleRecord()), HasSubstr(item(&PickleWriter::value, "b1", summary.dict())));
}

TEST_F(ScenarioNet, LanesLeadToLanesThatAreThere) {
  CrashRecord record = sampleRecord();
  record.lanes.lanes = {lane("l1", 0.0), lane("l2", 20.0), lane("point", 40.0)};
  record.lanes.lanes[0].outgoing = {"l2", "point"};
  record.lanes.lanes[1].is_connector = true;
  record.lanes.lanes[1].incoming = {"l1"};
  record.lanes.lanes[1].speed_limit = 10.0;
  record.lanes.lanes[2].centerline.pop_back();
  const std::string bytes = written(record);
  PickleWriter connector;
  connector.text("type", "LANE_SURFACE_UNSTRUCTURE");
  connector.numbers("polyline", {20, 0, 40, 0}, 2);
  connector.texts("entry_lanes", {"l1"});
  connector.texts("exit_lanes", {});
  connector.texts("left_neighbor", {});
  connector.texts("right_neighbor", {});
  connector.number("speed_limit_kmh", 36.0);
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::value, "l2", connector.dict())));
  EXPECT_THAT(bytes, HasSubstr(textItem("type", "LANE_SURFACE_STREET")));
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::texts, "exit_lanes", {"l2"})));
  EXPECT_THAT(bytes, Not(HasSubstr(pickledText("point"))));
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::count, "num_map_features", 2)));
}

TEST_F(ScenarioNet, AnOutlineFarFromItsLaneIsLeftOut) {
  CrashRecord record = sampleRecord();
  record.lanes.lanes = {lane("l1", 0.0)};
  record.lanes.lanes[0].polygon = {{0.0, -1.5}, {20.0, -1.5}, {20.0, 1.5}};
  EXPECT_THAT(written(record),
              HasSubstr(item(&PickleWriter::numbers, "polygon", {0, -1.5, 20, -1.5, 20, 1.5}, 2)));
  record.lanes.lanes[0].polygon = {{400.0, -1.5}, {20.0, -1.5}, {20.0, 1.5}};
  EXPECT_THAT(written(record), Not(HasSubstr(pickledText("polygon"))));
}

TEST_F(ScenarioNet, WalkwaysAndTheEdgeOfTheRoadAreTold) {
  CrashRecord record = sampleRecord();
  record.lanes.drivable_area = {{{{0, -4}, {20, -4}, {20, 4}, {0, 4}}, {}}};
  record.lanes.walkways = {{{{0, 4}, {20, 4}, {20, 6}}, {}}};
  const std::string bytes = written(record);
  PickleWriter walkway;
  walkway.text("type", "ROAD_EDGE_SIDEWALK");
  walkway.numbers("polygon", {0, 4, 20, 4, 20, 6}, 2);
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::value, "walkway_0", walkway.dict())));
  PickleWriter edge;
  edge.text("type", "ROAD_EDGE_BOUNDARY");
  edge.numbers("polyline", {0, -4, 20, -4, 20, 4, 0, 4, 0, -4}, 2);
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::value, "edge_1", edge.dict())));
}

TEST_F(ScenarioNet, TheSummaryOfAllHoldsTheMetadataOfEach) {
  const auto writer = makeScenarioNetWriter(planIn(folder_));
  CrashRecord other = sampleRecord();
  other.name = "scene-0001_8";
  other.contact.reset();
  const std::string first = writer->write(sampleRecord()).at(0);
  const std::string second = writer->write(other).at(0);
  writer->finish(
      {{"scene-0001_7", "scene-0001", "a-town", 4}, {"scene-0001_8", "scene-0001", "a-town", 4}});
  PickleWriter summary;
  for (const std::string& file : {first, second}) {
    const std::string bytes = read(file);
    const std::string key = pickledText("metadata");
    const std::size_t begin = bytes.rfind(key) + key.size();
    summary.value(file, bytes.substr(begin, bytes.size() - 2 - begin));
  }
  EXPECT_EQ(read("dataset_summary.pkl"), summary.pickle());
  PickleWriter mapping;
  mapping.text(first, "");
  mapping.text(second, "");
  EXPECT_EQ(read("dataset_mapping.pkl"), mapping.pickle());
}

TEST_F(ScenarioNet, AFileThatIsGoneIsNamed) {
  try {
    makeScenarioNetWriter(planIn(folder_))->finish({{"gone_1", "gone", "a-town", 4}});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("sd_collision_forge_v1_gone_1.pkl: is no scenario"));
  }
}

TEST_F(ScenarioNet, RefusesAFreeEgo) {
  ExportPlan plan = planIn(folder_);
  plan.ego_free = true;
  EXPECT_THROW(makeScenarioNetWriter(plan), std::invalid_argument);
}

}  // namespace
}  // namespace forge
