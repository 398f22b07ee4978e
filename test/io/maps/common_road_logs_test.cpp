#include "collision_forge/io/maps/common_road_logs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/io/maps/map_error.h"
#include "io/logs/nuscenes_fixture.h"
#include "io/maps/map_options.h"
#include "io/maps/small_common_road.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct ReadScene {
  Scene scene;
  std::vector<std::string> warnings;

  const Track* agent(const std::string& id) const {
    for (const Track& agent : scene.agents) {
      if (agent.id == id) return &agent;
    }
    return nullptr;
  }
};

ReadScene readSmall(const std::string& text, const std::string& ego = "") {
  const TemporaryFolder folder;
  const DataOptions options = mapOptions();
  ReadScene read;
  const LoggedScene logged =
      readCommonRoadScenario(folder.write("DEU_Town-1_1.xml", text), ego, options, &read.warnings);
  read.scene = flattened(logged, {{}, options, {}, {}}).scene;
  return read;
}

/// A lanelet; cars "11" and "12", a truck "13" in sight for longer, a pedestrian.
SmallCommonRoad town() {
  SmallCommonRoad file("DEU_Town-1");
  file.lanelet("1", 0.0, 0.0);
  file.moving("11", "car", {0.0, 0.0}, 10.0, 0, 20).moving("12", "car", {30.0, 0.0}, 5.0, 0, 20);
  file.moving("13", "truck", {60.0, 0.0}, 5.0, 5, 30).moving("14", "pedestrian", {9, 9}, 1, 0, 40);
  return file;
}

TEST(CommonRoadScenario, TheEgoIsTheVehicleAtTheStartOfThePlanningProblem) {
  const ReadScene read = readSmall(town().problem({30.5 + 0.1 * 5.0 * 4, 0.0, 0.0}, 4).text());
  EXPECT_THAT(read.warnings, IsEmpty());
  EXPECT_EQ(read.scene.name, "DEU_Town-1_1");
  EXPECT_EQ(read.agent("12"), nullptr);
  const Track& ego = read.scene.ego;
  EXPECT_EQ(ego.size.length, 4.5);
  EXPECT_EQ(ego.size.width, 1.9);
  ASSERT_EQ(ego.states.size(), 21U);
  EXPECT_NEAR(ego.states[0].time, 1.0, 1e-9);
  EXPECT_NEAR(ego.states[20].time, 3.0, 1e-9);
  EXPECT_NEAR(ego.states[0].pose.x, 30.0, 1e-9);
  EXPECT_NEAR(ego.states[20].pose.x, 40.0, 1e-9);
}

TEST(CommonRoadScenario, TheHeightsOfAgentsAreUnknown) {
  const ReadScene read = readSmall(town().text());
  ASSERT_FALSE(read.scene.agents.empty());
  for (const Track& agent : read.scene.agents) EXPECT_EQ(agent.height, std::nullopt) << agent.id;
}

TEST(CommonRoadScenario, WithoutSuchAVehicleTheEgoIsTheOneInSightForLongest) {
  const ReadScene read = readSmall(town().problem({500.0, 0.0, 0.0}, 0).text());
  EXPECT_EQ(read.agent("13"), nullptr);
  EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("the ego is 13")));
}

TEST(CommonRoadScenario, OfVehiclesInSightForAsLongTheNearestToTheStartIsTheEgo) {
  SmallCommonRoad file("DEU_Town-1");
  file.moving("11", "car", {0.0, 0.0}, 10.0, 0, 20).moving("12", "car", {30.0, 0.0}, 5.0, 0, 20);
  EXPECT_EQ(readSmall(file.problem({45.0, 0.0, 0.0}, 0).text()).agent("12"), nullptr);
}

TEST(CommonRoadScenario, AnObstacleThatIsNamedIsTheEgo) {
  EXPECT_EQ(readSmall(town().problem({30.0, 0.0, 0.0}, 0).text(), "11").agent("11"), nullptr);
  EXPECT_THAT(errorOf<MapError>([] { readSmall(town().text(), "99"); }),
              HasSubstr("has no dynamic obstacle 99"));
}

TEST(CommonRoadScenario, AScenarioWithoutVehiclesIsRefused) {
  SmallCommonRoad file;
  file.lanelet("1", 0.0, 0.0).moving("14", "pedestrian", {9, 9}, 1, 0, 40);
  EXPECT_THAT(errorOf<MapError>([&] { readSmall(file.text()); }),
              HasSubstr("has no dynamic obstacle that can be the ego"));
}

TEST(CommonRoadScenario, AgentsAreWhereTheyAreAtEachStep) {
  const ReadScene read = readSmall(town().text(), "11");
  const Track* const truck = read.agent("13");
  ASSERT_NE(truck, nullptr);
  EXPECT_EQ(truck->agent_class, AgentClass::kTruck);
  ASSERT_EQ(truck->states.size(), 16U) << "steps 5 to 20";
  EXPECT_NEAR(truck->states.front().time, 1.5, 1e-9);
  EXPECT_NEAR(truck->states.front().pose.x, 60.0, 1e-9);
  EXPECT_NEAR(truck->states.front().velocity.x(), 5.0, 1e-9);
  EXPECT_EQ(read.agent("14")->agent_class, AgentClass::kPedestrian);
  EXPECT_EQ(read.agent("14")->states.size(), 21U);
}

TEST(CommonRoadScenario, StaticObstaclesAreInAllFrames) {
  SmallCommonRoad file = town();
  file.add("<staticObstacle id='20'><type>parkedVehicle</type>" +
           std::string(SmallCommonRoad::kBox) +
           SmallCommonRoad::state("initialState", {5.0, 4.0, 0.1}, 0, 0.0) + "</staticObstacle>");
  const ReadScene read = readSmall(file.text(), "11");
  const Track* const parked = read.agent("20");
  ASSERT_NE(parked, nullptr);
  EXPECT_EQ(parked->agent_class, AgentClass::kCar);
  EXPECT_EQ(parked->states.size(), 21U);
  EXPECT_NEAR(parked->states.back().pose.yaw, 0.1, 1e-9);
}

TEST(CommonRoadScenario, ObstaclesOf2018bHaveTheirRoleInAnElement) {
  SmallCommonRoad file("DEU_Town-1");
  file.add("<obstacle id='3'><role>dynamic</role><type>car</type>" +
           std::string(SmallCommonRoad::kBox) + SmallCommonRoad::drive({0, 0}, 10.0, 0, 20) +
           "</obstacle>");
  file.add("<obstacle id='4'><role>static</role><type>parkedVehicle</type>" +
           std::string(SmallCommonRoad::kBox) +
           SmallCommonRoad::state("initialState", {5.0, 4.0, 0.1}, 0, 0.0) + "</obstacle>");
  const ReadScene read = readSmall(file.text("2018b"));
  EXPECT_EQ(read.scene.ego.states.size(), 21U);
  EXPECT_EQ(read.agent("4")->states.size(), 21U);
}

TEST(CommonRoadScenario, IntervalsRegionsAndOtherShapesAreUnderstood) {
  SmallCommonRoad file = town();
  file.add(
      "<staticObstacle id='20'><type>unknown</type><shape><circle><radius>0.5</radius></circle>"
      "</shape><initialState><position><circle><radius>1</radius><center><x>3</x><y>4</y></center>"
      "</circle></position><orientation><intervalStart>0.1</intervalStart><intervalEnd>0.3"
      "</intervalEnd></orientation><time><exact>0</exact></time></initialState></staticObstacle>");
  const ReadScene read = readSmall(file.text(), "11");
  const Track* const thing = read.agent("20");
  ASSERT_NE(thing, nullptr);
  EXPECT_EQ(thing->size.length, 1.0);
  EXPECT_EQ(thing->agent_class, AgentClass::kStaticObject);
  EXPECT_NEAR(thing->states.front().pose.yaw, 0.2, 1e-9);
  EXPECT_NEAR(thing->states.front().pose.x, 3.0, 1e-9);
}

TEST(CommonRoadScenario, ABadStateCostsThatStateAndABadShapeTheObstacle) {
  std::string text = town().text();
  replaceIn(text, "<x>31</x>", "<x>nowhere</x>");
  replaceIn(text, "<velocity><exact>5</exact></velocity>", "");
  const std::size_t at = text.find("<width>", text.find("id='13'"));
  text.replace(at, 7, "<depth>");
  text.replace(text.find("</width>", at), 8, "</depth>");
  const ReadScene read = readSmall(text, "11");
  const Track* const car = read.agent("12");
  ASSERT_NE(car, nullptr);
  EXPECT_EQ(car->states.size(), 21U) << "interpolated at the step of the bad state";
  EXPECT_NEAR(car->states.front().velocity.x(), 5.0, 1e-6) << "derived";
  EXPECT_EQ(read.agent("13"), nullptr);
  EXPECT_THAT(
      read.warnings,
      testing::UnorderedElementsAre(
          HasSubstr("1 obstacles without a usable shape (first: 13)"),
          HasSubstr("1 states without a usable position, orientation or time (first: 12)")));
}

TEST(CommonRoadLogs, EveryScenarioOfAFolderIsAScene) {
  const TemporaryFolder folder;
  folder.write("b.xml", town().text());
  folder.write("a.xml", town().text());
  folder.write("other.xml", "<OpenDRIVE/>");
  folder.write("notes.txt", "<commonRoad/>");
  const LogFormat& format = commonRoadFormat();
  ASSERT_TRUE(format.accepts(folder.path()));
  LogSource source{folder.path(), "", &format};
  source.ego = "12";
  EXPECT_THAT(readSceneNames(source), ElementsAre("a", "b"));
  const auto logs = format.open(source, {{"b"}, mapOptions(), {}, {}});
  EXPECT_THAT(logs->names(), ElementsAre("b"));
  const IndexedScene read = logs->read("b");
  EXPECT_NEAR(read.scene.ego.states[0].pose.x, 30.0, 1e-9);
  EXPECT_EQ(read.lanes->map().lanes.size(), 1U);
  EXPECT_TRUE(format.accepts(folder.path() + "/a.xml"));
  EXPECT_FALSE(format.accepts(folder.path() + "/other.xml"));
}

}  // namespace
}  // namespace forge
