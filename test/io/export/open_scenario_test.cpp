#include "collision_forge/io/export/open_scenario.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <set>

#include "collision_forge/io/export/open_drive.h"
#include "collision_forge/planner_test/settings/config.h"
#include "io/export/crash_fixture.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using pugi::xml_node;

class OpenScenario : public testing::Test {
 protected:
  /// Returns the file of that ending, parsed.
  pugi::xml_document written(const CrashRecord& record, const std::string& ending,
                             bool ego_free = false, bool for_carla = false) {
    ExportPlan plan = planFor(folder_.path(), ego_free);
    plan.for_carla = for_carla;
    makeOpenScenarioWriter(plan)->write(record);
    pugi::xml_document document;
    EXPECT_TRUE(document.load_file((folder_.path() + "/scene-0001_17" + ending).c_str()));
    return document;
  }

  static xml_node at(const pugi::xml_document& document, const std::string& path) {
    const xml_node found = document.select_node(path.c_str()).node();
    EXPECT_TRUE(found) << path;
    return found;
  }

  static std::string driveOf(const std::string& name) {
    return "//Trajectory[@name='trajectory of " + name + "']";
  }

  TemporaryFolder folder_;
};

TEST_F(OpenScenario, AddsLateEntitiesAndDeletesThoseThatLeave) {
  const auto document = written(slowCarRecord(), ".xosc");
  std::set<std::string> there;
  for (const auto& one : document.select_nodes("//Init//Private")) {
    there.insert(one.node().attribute("entityRef").value());
  }
  EXPECT_EQ(there, (std::set<std::string>{"ego", "other_1", "other_2"}));
  std::set<std::string> added, deleted;
  for (const auto& one : document.select_nodes("//EntityAction[AddEntityAction]")) {
    added.insert(one.node().attribute("entityRef").value());
  }
  for (const auto& one : document.select_nodes("//EntityAction[DeleteEntityAction]")) {
    deleted.insert(one.node().attribute("entityRef").value());
  }
  EXPECT_EQ(added, (std::set<std::string>{"attacker", "other_1_2"}));
  EXPECT_EQ(deleted, (std::set<std::string>{"other_1", "other_1_2"}));
}

TEST_F(OpenScenario, EntitiesThatAreThereFromTheStartDriveFromInitOn) {
  const auto document = written(slowCarRecord(), ".xosc");
  EXPECT_EQ(document.select_nodes("//Init//FollowTrajectoryAction").size(), 3u);
  EXPECT_FALSE(document.select_node("//Init//SpeedAction"));
  EXPECT_EQ(document.select_nodes("//Story//FollowTrajectoryAction").size(), 2u);
}

TEST_F(OpenScenario, TheAttackerOfAFreeEgoStartsByTheTimeGapOfTheEgo) {
  const CrashRecord record = slowCarRecord(0.0);
  const auto document = written(record, ".xosc", true);
  EXPECT_EQ(document.select_nodes("//Init//Private[@entityRef='ego']//SpeedAction").size(), 1u);
  EXPECT_FALSE(document.select_node(driveOf("ego").c_str()));
  const xml_node event = at(document, "//Event[@name='start of drive of attacker']");
  // The ego drives at 10 m/s, so the time gap at the start is the time to the contact.
  EXPECT_NEAR(
      event.select_node(".//TimeToCollisionCondition").node().attribute("value").as_double(),
      *record.contact, 1e-6);
  EXPECT_EQ(std::string(
                event.select_node(".//Timing").node().attribute("domainAbsoluteRelative").value()),
            "relative");
  EXPECT_TRUE(document.select_node(
      "//StopTrigger//StoryboardElementStateCondition[@storyboardElementRef='start of drive of "
      "attacker']"));
}

TEST_F(OpenScenario, PeopleOnFootArePedestriansWithTheirHeightAndScootersBicycles) {
  CrashRecord record = slowCarRecord();
  record.other_agents.resize(1);
  Track& agent = record.other_agents[0];
  const std::string dimensions = "//Pedestrian/BoundingBox/Dimensions";
  const auto bodies =
      loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").attack.verification.severity.bodies;
  for (const AgentClass on_foot :
       {AgentClass::kPedestrian, AgentClass::kChild, AgentClass::kRunner}) {
    agent.agent_class = on_foot;
    agent.height.reset();
    auto document = written(record, ".xosc");
    EXPECT_STREQ(at(document, "//Pedestrian").attribute("pedestrianCategory").value(),
                 "pedestrian");
    EXPECT_EQ(at(document, dimensions).attribute("height").as_double(),
              typicalHeight(on_foot, agent.size));
    EXPECT_EQ(at(document, "//Pedestrian").attribute("mass").as_double(),
              bodies[static_cast<std::size_t>(on_foot)].mass);
    agent.height = 1.03;
    document = written(record, ".xosc");
    EXPECT_EQ(at(document, dimensions).attribute("height").as_double(), 1.03);
  }
  agent.agent_class = AgentClass::kScooter;
  at(written(record, ".xosc"), "//Vehicle[@vehicleCategory='bicycle']");
}

TEST_F(OpenScenario, TheFlavourOfCarlaHasOnlyWhatScenarioRunnerReads) {
  const auto document = written(slowCarRecord(), ".xosc", false, true);
  EXPECT_EQ(at(document, "//FileHeader").attribute("revMinor").as_int(), 0);
  EXPECT_FALSE(document.select_node("//GlobalAction"));
  EXPECT_FALSE(document.select_node("//TrajectoryRef"));
  // ScenarioRunner takes the last position of an entity in Init for its start.
  EXPECT_EQ(document.select_nodes("//Init//Private").size(), 5u);
  EXPECT_EQ(document.select_nodes("//Init//WorldPosition").size(), 5u);
  EXPECT_EQ(document.select_nodes("//Story//FollowTrajectoryAction/Trajectory").size(), 5u);
  EXPECT_EQ(
      std::string(at(document, "//ScenarioObject[@name='ego']/Vehicle").attribute("name").value()),
      "vehicle.tesla.model3");
  EXPECT_EQ(document.select_nodes("//Property[@value='ego_vehicle']").size(), 1u);
  EXPECT_EQ(document.select_nodes("//Center[@x='0']").size(), 5u);
}

TEST_F(OpenScenario, ParametersDescribeTheCrashAndTheStoryboardEndsWithTheRecord) {
  const CrashRecord record = slowCarRecord();
  const auto document = written(record, ".xosc");
  const auto value = [&](const std::string& name) {
    return std::string(
        at(document, "//ParameterDeclaration[@name='" + name + "']").attribute("value").value());
  };
  EXPECT_EQ(value("collision_type"), "rear_end");
  EXPECT_EQ(value("tta"), "3.5");
  EXPECT_EQ(value("seed"), "7");
  EXPECT_EQ(value("attacker_id"), "a");
  EXPECT_NEAR(std::stod(value("contact_time")), *record.contact, 1e-12);
  const xml_node stop = at(document, "/OpenSCENARIO/Storyboard/StopTrigger");
  EXPECT_EQ(stop.select_node(".//SimulationTimeCondition").node().attribute("value").as_double(),
            record.end());
}

TEST_F(OpenScenario, HeadingsAreUnwrapped) {
  CrashRecord record = slowCarRecord();
  for (std::size_t i = 0; i < record.ego.states.size(); ++i) {
    record.ego.states[i].pose.yaw = wrapAngle(3.0 + 0.01 * static_cast<double>(i));
  }
  const auto document = written(record, ".xosc");
  double last = 3.0;
  for (const auto& one : document.select_nodes((driveOf("ego") + "//WorldPosition").c_str())) {
    const double heading = one.node().attribute("h").as_double();
    EXPECT_NEAR(heading, last, 0.0101);
    last = heading;
  }
  EXPECT_GT(last, 3.5);
}

TEST_F(OpenScenario, EscapesIdsThatReadersInterpret) {
  Scenario scenario = slowCar();
  scenario.answer.trajectory.attacker_id = "$tta<&\"";
  scenario.answer.trajectory.past = {{kNow, {32.0, 0.0, 0.0}, {2.0, 0.0}}};
  const auto document = written(slowCarRecord(2.0, scenario), ".xosc");
  EXPECT_EQ(
      std::string(
          at(document, "//ParameterDeclaration[@name='attacker_id']").attribute("value").value()),
      "_$tta<&\"");
}

TEST_F(OpenScenario, RoadsFollowTheCentrelines) {
  const auto document = written(slowCarRecord(), ".xodr");
  const auto roads = document.select_nodes("//road");
  ASSERT_EQ(roads.size(), 2u);
  const xml_node first = roads[0].node();
  EXPECT_EQ(std::string(first.attribute("rule").value()), "RHT");
  EXPECT_EQ(first.select_node("planView/geometry").node().attribute("x").as_double(), -30.0);
  EXPECT_DOUBLE_EQ(first.select_node("lanes/laneOffset").node().attribute("a").as_double(), 1.75);
  EXPECT_EQ(first.select_node("lanes/laneSection/right/lane").node().attribute("id").as_int(), -1);
  EXPECT_EQ(std::string(first.select_node("link/successor").node().attribute("elementId").value()),
            roads[1].node().attribute("id").value());
  EXPECT_EQ(roads[1].node().select_node("type/speed").node().attribute("max").as_double(), 13.9);
  EXPECT_EQ(at(document, "//offset").attribute("x").as_double(), -20.0);
}

TEST_F(OpenScenario, LeftHandRoadsHaveTheirLaneOnTheLeft) {
  CrashRecord record = slowCarRecord();
  record.lanes.driving_side = DrivingSide::kLeft;
  const auto document = written(record, ".xodr");
  const xml_node road = at(document, "//road");
  EXPECT_EQ(std::string(road.attribute("rule").value()), "LHT");
  EXPECT_DOUBLE_EQ(road.select_node("lanes/laneOffset").node().attribute("a").as_double(), -1.75);
  EXPECT_EQ(road.select_node("lanes/laneSection/left/lane").node().attribute("id").as_int(), 1);
  EXPECT_FALSE(road.select_node("lanes/laneSection/right"));
}

TEST_F(OpenScenario, ACrosswalkIsAnObjectOfTheRoadThatItCrosses) {
  CrashRecord record = slowCarRecord();
  record.lanes.features = {{FeatureKind::kCrosswalk, {{0, -4}, {3, -4}, {3, 4}, {0, 4}}}};
  const auto document = written(record, ".xodr");
  const xml_node object = at(document, "//road[1]/objects/object[@type='crosswalk']");
  EXPECT_NEAR(object.attribute("s").as_double(), 51.5, 1e-6);  // the road begins at x = -50 m
  EXPECT_NEAR(object.attribute("t").as_double(), 0.0, 1e-6);
  const xml_node corner = object.select_node("outlines/outline/cornerLocal").node();
  EXPECT_NEAR(corner.attribute("u").as_double(), -1.5, 1e-6);
  EXPECT_NEAR(corner.attribute("v").as_double(), -4.0, 1e-6);
}

TEST_F(OpenScenario, ForksAreJunctionsWithTheirLaneLinks) {
  CrashRecord record = slowCarRecord();
  record.lanes.lanes[0].outgoing = {"second", "other"};
  record.lanes.lanes.push_back(
      {"other", false, false, {{20, 0, 0}, {60, -20, -0.9}}, {}, {"first"}, {}, {}});
  const auto document = written(record, ".xodr");
  EXPECT_EQ(document.select_nodes("//junction/connection/laneLink[@from='-1'][@to='-1']").size(),
            2u);
  EXPECT_EQ(document.select_nodes("//road[@junction!='-1']").size(), 2u);
  EXPECT_FALSE(document.select_node("//road[@junction='-1']//lane/link/successor"));
}

}  // namespace
}  // namespace forge
