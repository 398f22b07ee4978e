#include "collision_forge/io/export/open_label.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "collision_forge/io/json/json_line.h"
#include "io/export/crash_fixture.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The slow car ahead, verified as such.
Scenario leadSlow() {
  Scenario scenario = slowCar();
  scenario.asked.request.type = CollisionType::kRearEnd;
  scenario.answer.report.manoeuvre = Manoeuvre::kLeadSlow;
  scenario.answer.report.ego_side = Side::kFront;
  return scenario;
}

TEST(OpenLabel, TagsRoadUsersBehaviourAndPlace) {
  const std::set<std::string> tags = asamTags(slowCarRecord(2.0, leadSlow()));
  EXPECT_THAT(tags, IsSupersetOf({"VehicleCar", "HumanPedestrian", "VehicleCycle", "HumanCyclist",
                                  "MotionDrive", "TravelDirectionRight"}));
  EXPECT_THAT(tags, Not(Contains("VehicleBus")));  // too far away
  EXPECT_THAT(tags, Not(Contains("JunctionIntersection")));
}

TEST(OpenLabel, TheSideOfTheAttackerGivesTheDirectionOfItsLaneChange) {
  Scenario scenario = leadSlow();
  scenario.answer.report.manoeuvre = Manoeuvre::kCutIn;
  scenario.answer.report.ego_at_contact = {0.0, 0.0, 0.0};
  scenario.answer.report.attacker_at_contact = {3.0, 1.5, 0.0};
  EXPECT_THAT(asamTags(slowCarRecord(2.0, scenario)),
              IsSupersetOf({"MotionCutIn", "MotionLaneChangeRight"}));
  scenario.answer.report.attacker_at_contact = {3.0, -1.5, 0.0};
  EXPECT_THAT(asamTags(slowCarRecord(2.0, scenario)), Contains("MotionLaneChangeLeft"));
}

TEST(OpenLabel, AVehicleThatBacksOutReverses) {
  Scenario scenario = leadSlow();
  scenario.asked.request.type = CollisionType::kJunctionCrossing;
  scenario.answer.report.manoeuvre = Manoeuvre::kBackOut;
  EXPECT_THAT(asamTags(slowCarRecord(2.0, scenario)), Contains("MotionReverse"));
}

TEST(OpenLabel, PlacesAreTheAreasThatContainTheAttackerAtContact) {
  CrashRecord record = slowCarRecord(2.0, leadSlow());
  record.scenario.answer.report.attacker_at_contact = {5.0, 5.0, 0.0};
  const std::vector<Vector2> around = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  record.lanes.features = {{FeatureKind::kCrosswalk, around}};
  record.lanes.lanes.front().is_intersection = true;
  record.lanes.lanes.front().polygon = around;
  EXPECT_THAT(asamTags(record),
              IsSupersetOf({"SpecialStructurePedestrianCrossing", "JunctionIntersection"}));
  record.scenario.answer.report.attacker_at_contact = {15.0, 5.0, 0.0};
  EXPECT_THAT(asamTags(record), Not(Contains("JunctionIntersection")));
}

TEST(OpenLabel, AFastPedestrianRuns) {
  Scenario scenario = leadSlow();
  scenario.answer.trajectory.agent_class = AgentClass::kPedestrian;
  scenario.answer.trajectory.points.back().speed = 2.5;
  EXPECT_THAT(asamTags(slowCarRecord(2.0, scenario)), Contains("MotionRun"));
  for (TrajectoryPoint& point : scenario.answer.trajectory.points) point.speed = 1.4;
  EXPECT_THAT(asamTags(slowCarRecord(2.0, scenario)), Contains("MotionWalk"));
}

TEST(OpenLabel, FilesHaveTheStructureOfTheStandardAndNameTheScenario) {
  const TemporaryFolder folder;
  const auto writer = makeOpenLabelWriter(planFor(folder.path()));
  Scenario scenario = leadSlow();
  scenario.asked.name = "euro_ncap_2026/CCRm attacker_speed=5.56 impact_location=0.5";
  const CrashRecord record = slowCarRecord(2.0, scenario);
  const std::string file = writer->write(record).at(0);
  EXPECT_EQ(file, record.name + ".openlabel.json");
  std::string text = contentOf(folder.path() + "/" + file);
  text.pop_back();
  const JsonLine line("file", text);
  JsonObject root = line.root();
  JsonObject label = root.object("openlabel");
  EXPECT_EQ(label.object("metadata").text("schema_version"), "1.0.0");
  JsonObject ontologies = label.object("ontologies");
  JsonObject asam = ontologies.object("0");
  const std::vector<std::string> boundary = asam.texts("boundary_list");
  for (const std::string& tag : asamTags(record)) EXPECT_THAT(boundary, Contains(tag));
  EXPECT_EQ(asam.text("boundary_mode"), "include");
  JsonObject tags = label.object("tags");
  std::vector<std::string> names;
  for (std::size_t i = 0; tags.has(std::to_string(i).c_str()); ++i) {
    JsonObject tag = tags.object(std::to_string(i).c_str());
    if (tag.text("ontology_uid") == "1") names.push_back(tag.text("type"));
  }
  tags.finish();
  EXPECT_THAT(names,
              testing::ElementsAre("euro_ncap_2026/CCRm", "nhtsa/23_lead_vehicle_accelerating",
                                   "nhtsa/24_lead_vehicle_slower", scenario.asked.name));
  writer->finish({});
  EXPECT_THAT(contentOf(folder.path() + "/" + ontologies.object("1").text("uri")),
              HasSubstr("<#euro_ncap_2026/CCRm> a owl:Class"));
}

}  // namespace
}  // namespace forge
