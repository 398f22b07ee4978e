#include "collision_forge/io/export/common_road.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <pugixml.hpp>
#include <regex>
#include <set>

#include "io/export/crash_fixture.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using pugi::xml_node;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using Words = std::set<std::string>;

double number(const xml_node& parent, const char* path) {
  const xml_node found = parent.select_node(path).node();
  EXPECT_TRUE(found) << path;
  return found.text().as_double();
}

int stepAt(const xml_node& state) { return state.child("time").child("exact").text().as_int(-1); }

Vector2 pointAt(const xml_node& point) { return {number(point, "x"), number(point, "y")}; }

std::vector<Vector2> pointsOf(const xml_node& bound) {
  std::vector<Vector2> points;
  for (const xml_node& point : bound.children("point")) points.push_back(pointAt(point));
  return points;
}

/// Returns the states of a dynamic obstacle, the initial one first.
std::vector<xml_node> statesOf(const xml_node& obstacle) {
  std::vector<xml_node> states = {obstacle.child("initialState")};
  for (const xml_node& state : obstacle.child("trajectory").children("state")) {
    states.push_back(state);
  }
  return states;
}

/// Returns poses 1 m apart along x, over `length` metres from (x, y).
std::vector<Pose2> straight(double x, double y, double length) {
  std::vector<Pose2> poses;
  for (double way = 0.0; way <= length; way += 1.0) poses.push_back({x + way, y, 0.0});
  return poses;
}

/// Returns a left arc of `radius` metres around the origin over `angle` radians.
std::vector<Pose2> leftBend(double radius, double angle) {
  std::vector<Pose2> poses;
  for (int i = 0; i <= 20; ++i) {
    const double turned = angle * i / 20.0;
    poses.push_back({radius * std::sin(turned), -radius * std::cos(turned), turned});
  }
  return poses;
}

Lane laneAlong(const std::string& id, std::vector<Pose2> centerline) {
  Lane lane;
  lane.id = id;
  lane.centerline = std::move(centerline);
  return lane;
}

/// Returns a track at (x, y) with `speed` along x at these steps.
Track trackAt(const std::string& id, AgentClass agent_class, const std::vector<int>& steps,
              double speed, double step = 0.1) {
  Track track{id, agent_class, {3.0, 1.5}, {}};
  for (const int i : steps) {
    track.states.push_back({i * step, {8.0 + speed * step * i, 9.0, 0.5}, {speed, 0.0}});
  }
  return track;
}

std::vector<int> allSteps(const CrashRecord& record) {
  std::vector<int> steps(record.ego.states.size());
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = static_cast<int>(i);
  return steps;
}

class CommonRoad : public testing::Test {
 protected:
  std::string textOf(const CrashRecord& record, bool ego_free = false) {
    const auto files = makeCommonRoadWriter(planFor(folder_.path(), ego_free))->write(record);
    EXPECT_THAT(files, ElementsAre(record.name + ".xml"));
    std::ifstream file(folder_.path() + "/" + files.at(0), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// Returns the element "commonRoad"; valid until the next call.
  xml_node written(const CrashRecord& record, bool ego_free = false) {
    EXPECT_TRUE(document_.load_string(textOf(record, ego_free).c_str()));
    return document_.child("commonRoad");
  }

  /// Returns it for a record with these lanes.
  std::vector<xml_node> laneletsOf(const std::vector<Lane>& lanes) {
    CrashRecord record = slowCarRecord();
    record.lanes.lanes = lanes;
    const auto range = written(record).children("lanelet");
    return {range.begin(), range.end()};
  }

  /// Returns the width of the only lanelet at its start, m.
  double widthOf(const Lane& lane) {
    const auto lanelets = laneletsOf({lane});
    EXPECT_EQ(lanelets.size(), 1U);
    const auto left = pointsOf(lanelets.at(0).child("leftBound"));
    const auto right = pointsOf(lanelets.at(0).child("rightBound"));
    return (left.at(0) - right.at(0)).norm();
  }

  Words tagsOf(CollisionType type, Manoeuvre manoeuvre) {
    CrashRecord record = slowCarRecord();
    record.scenario.asked.request.type = type;
    record.scenario.answer.report.manoeuvre = manoeuvre;
    Words tags;
    for (const xml_node& tag : written(record).child("scenarioTags")) tags.insert(tag.name());
    for (const char* always : {"urban", "critical", "simulated"}) EXPECT_EQ(tags.erase(always), 1U);
    return tags;
  }

  static std::string refOf(const xml_node& lanelet, const char* name) {
    return lanelet.child(name).attribute("ref").value();
  }

  TemporaryFolder folder_;
  pugi::xml_document document_;
};

TEST_F(CommonRoad, TheHeaderDescribesTheFile) {
  const xml_node root = written(slowCarRecord());
  const auto attribute = [&](const char* name) {
    return std::string(root.attribute(name).value());
  };
  EXPECT_EQ(attribute("commonRoadVersion"), "2020a");
  EXPECT_EQ(attribute("timeStepSize"), "0.1");
  EXPECT_EQ(attribute("date"), "2018-08-01");  // kNow
  EXPECT_EQ(attribute("benchmarkID"), "ZAM_EmbeddedRightScene0001-1_17_T-1");
  const std::regex pattern("(C-)?[A-Z]{3}_[A-Za-z0-9]+-[1-9][0-9]*_[1-9][0-9]*_T-[1-9][0-9]*");
  EXPECT_TRUE(std::regex_match(attribute("benchmarkID"), pattern));
}

TEST_F(CommonRoad, TheSourceDescribesTheCrash) {
  CrashRecord record = slowCarRecord();
  record.scenario.answer.report.manoeuvre = Manoeuvre::kLeadSlow;
  const std::string source = written(record).attribute("source").value();
  EXPECT_THAT(source,
              AllOf(HasSubstr("type=rear_end;"), HasSubstr("tta=3.5;"),
                    HasSubstr("manoeuvre=lead_slow;"), HasSubstr("attacker=a;"),
                    HasSubstr("seed=7;"), HasSubstr("now=2;"), HasSubstr("driving_side=right;")));
  const std::size_t at = source.find("contact=");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(source.substr(at + 8)), *record.contact, 1e-6);
  record.contact.reset();
  EXPECT_THAT(written(record).attribute("source").value(), Not(HasSubstr("contact")));
}

TEST_F(CommonRoad, TheLocationIsTheMapsOriginOrUnknown) {
  CrashRecord record = slowCarRecord();
  EXPECT_EQ(number(written(record), "location/gpsLatitude"), 999.0);
  record.lanes.location = "singapore-onenorth";
  record.origin = {1.25, 103.75};
  const xml_node root = written(record);
  EXPECT_EQ(number(root, "location/gpsLatitude"), 1.25);
  EXPECT_EQ(number(root, "location/gpsLongitude"), 103.75);
  EXPECT_THAT(root.attribute("benchmarkID").value(), testing::StartsWith("SGP_SingaporeOnenorth"));
  record.lanes.location = "boston-seaport";
  EXPECT_THAT(written(record).attribute("benchmarkID").value(), testing::StartsWith("USA_Boston"));
}

TEST_F(CommonRoad, TagsFollowTypeAndManoeuvre) {
  EXPECT_EQ(tagsOf(CollisionType::kRearEnd, Manoeuvre::kLeadSlow), Words{"lane_following"});
  EXPECT_EQ(tagsOf(CollisionType::kLaneChange, Manoeuvre::kDrift), Words{"lane_change"});
  EXPECT_EQ(tagsOf(CollisionType::kLaneChange, Manoeuvre::kCutIn),
            (Words{"cut_in", "lane_change"}));
  EXPECT_EQ(tagsOf(CollisionType::kLaneChange, Manoeuvre::kMerge),
            (Words{"lane_change", "merging_lanes"}));
  EXPECT_EQ(tagsOf(CollisionType::kOppositeDirection, Manoeuvre::kWrongWay),
            Words{"oncoming_traffic"});
  EXPECT_EQ(tagsOf(CollisionType::kJunctionCrossing, Manoeuvre::kTurnIntoPath),
            Words{"intersection"});
  EXPECT_EQ(tagsOf(CollisionType::kLtap, Manoeuvre::kTurnAcrossPath),
            (Words{"intersection", "oncoming_traffic"}));
}

TEST_F(CommonRoad, ElementsStandInTheOrderOfTheSchema) {
  CrashRecord record = slowCarRecord();
  record.other_agents.push_back(trackAt("parked", AgentClass::kCar, allSteps(record), 0.0));
  std::vector<std::string> order;
  for (const xml_node& child : written(record)) {
    if (order.empty() || order.back() != child.name()) order.emplace_back(child.name());
  }
  EXPECT_THAT(order, ElementsAre("location", "scenarioTags", "lanelet", "staticObstacle",
                                 "dynamicObstacle", "planningProblem"));
}

TEST_F(CommonRoad, IdsAreUniqueAndReferencesResolve) {
  const xml_node root = written(slowCarRecord());
  Words ids;
  for (const auto& found : root.select_nodes("*[@id]")) {
    EXPECT_TRUE(ids.insert(found.node().attribute("id").value()).second);
  }
  EXPECT_EQ(ids.count("0"), 0U);
  const auto references = root.select_nodes("lanelet/*[@ref]");
  EXPECT_EQ(references.size(), 2U);  // "first" to "second" and back
  for (const auto& found : references) {
    EXPECT_EQ(ids.count(found.node().attribute("ref").value()), 1U);
  }
  const auto lanelets = root.children("lanelet");
  const xml_node first = *lanelets.begin(), second = *std::next(lanelets.begin());
  EXPECT_EQ(refOf(first, "successor"), second.attribute("id").value());
  EXPECT_EQ(refOf(second, "predecessor"), first.attribute("id").value());
}

TEST_F(CommonRoad, ALightStandsAtTheEndOfTheLaneBeforeItsStopLine) {
  CrashRecord record = slowCarRecord();
  record.lights = {{"second", {20.0, 0.0}, {{0.0, LightColor::kGreen}, {1.0, LightColor::kRed}}}};
  const xml_node root = written(record);
  const xml_node light = root.child("trafficLight");
  EXPECT_EQ(refOf(root.child("lanelet"), "trafficLightRef"), light.attribute("id").value());
  EXPECT_EQ(root.select_nodes("lanelet/trafficLightRef").size(), 1U);
  std::vector<std::string> colors;
  int steps = 0;
  for (const xml_node& part : light.child("cycle")) {
    colors.emplace_back(part.child("color").text().get());
    steps += part.child("duration").text().as_int();
  }
  EXPECT_EQ(light.child("cycle").first_child().child("duration").text().as_int(), 10);
  EXPECT_THAT(colors, ElementsAre("green", "red"));
  EXPECT_EQ(steps, static_cast<int>(record.ego.states.size()));
  EXPECT_EQ(std::string(light.child("direction").text().get()), "straight");
}

TEST_F(CommonRoad, BoundsAreHalfAWidthOffTheCentreline) {
  const Lane lane = laneAlong("bend", leftBend(20.0, 1.5));
  const xml_node lanelet = laneletsOf({lane}).at(0);
  const auto left = pointsOf(lanelet.child("leftBound"));
  const auto right = pointsOf(lanelet.child("rightBound"));
  ASSERT_EQ(left.size(), lane.centerline.size());
  ASSERT_EQ(right.size(), left.size());
  const double half = 0.5 * shippedConfig().exports.lane_width;
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_NEAR((0.5 * (left[i] + right[i]) - lane.centerline[i].position()).norm(), 0.0, 1e-6);
    EXPECT_NEAR(left[i].norm(), 20.0 - half, 1e-6);
    EXPECT_NEAR(right[i].norm(), 20.0 + half, 1e-6);
  }
}

TEST_F(CommonRoad, NoBoundRunsBackwardsInATightBendAndTheMiddleIsTheCentreline) {
  std::vector<Pose2> poses = leftBend(1.0, 3.0);
  for (const bool is_mirrored : {false, true}) {
    const xml_node lanelet = laneletsOf({laneAlong("tight", poses)}).at(0);
    const auto left = pointsOf(lanelet.child("leftBound"));
    const auto right = pointsOf(lanelet.child("rightBound"));
    for (std::size_t i = 0; i < poses.size(); ++i) {
      EXPECT_NEAR((0.5 * (left[i] + right[i]) - poses[i].position()).norm(), 0.0, 1e-6);
    }
    for (const char* side : {"leftBound", "rightBound"}) {
      const auto bound = pointsOf(lanelet.child(side));
      ASSERT_EQ(bound.size(), poses.size());
      for (std::size_t i = 1; i < bound.size(); ++i) {
        const Vector2 along = poses[i].position() - poses[i - 1].position();
        EXPECT_GT(along.dot(bound[i] - bound[i - 1]), 0.0) << side << " " << i << is_mirrored;
      }
    }
    for (Pose2& pose : poses) pose = {pose.x, -pose.y, -pose.yaw};
  }
}

TEST_F(CommonRoad, TheWidthFollowsTheOutline) {
  Lane lane = laneAlong("lane", straight(0.0, 0.0, 20.0));
  EXPECT_NEAR(widthOf(lane), shippedConfig().exports.lane_width, 1e-6);
  const auto outlined = [&](double width) {
    lane.polygon = {{0, -width / 2}, {20, -width / 2}, {20, width / 2}, {0, width / 2}};
    return widthOf(lane);
  };
  EXPECT_NEAR(outlined(3.1), 3.1, 1e-6);
  EXPECT_NEAR(outlined(0.5), 2.0, 1e-6);
  EXPECT_NEAR(outlined(15.0), 8.0, 1e-6);
}

TEST_F(CommonRoad, DropsLanesWithoutCentrelineAndTheirLinks) {
  Lane whole = laneAlong("whole", straight(0.0, 0.0, 20.0));
  whole.incoming = {"empty"};
  whole.outgoing = {"point", "beyond"};
  const Lane empty = laneAlong("empty", {});
  const Lane point = laneAlong("point", {{20.0, 0.0, 0.0}, {20.0, 0.0, 0.0}});
  const Lane beyond = laneAlong("beyond", straight(20.0, 0.0, 9.0));
  const auto lanelets = laneletsOf({empty, whole, point, beyond});
  ASSERT_EQ(lanelets.size(), 2U);
  EXPECT_FALSE(lanelets[0].child("predecessor"));
  EXPECT_EQ(refOf(lanelets[0], "successor"), lanelets[1].attribute("id").value());
  EXPECT_FALSE(lanelets[0].child("successor").next_sibling("successor"));
}

TEST_F(CommonRoad, DropsRepeatedCentrelinePoints) {
  std::vector<Pose2> poses = straight(0.0, 0.0, 5.0);
  poses.insert(poses.begin() + 2, poses[2]);
  const auto bound = pointsOf(laneletsOf({laneAlong("lane", poses)}).at(0).child("leftBound"));
  EXPECT_EQ(bound.size(), poses.size() - 1);
}

TEST_F(CommonRoad, ParallelLanesAreAdjacent) {
  const auto lanelets = laneletsOf(
      {laneAlong("right", straight(0.0, 0.0, 20.0)), laneAlong("left", straight(0.4, 3.6, 20.0))});
  EXPECT_EQ(refOf(lanelets[0], "adjacentLeft"), lanelets[1].attribute("id").value());
  EXPECT_EQ(refOf(lanelets[1], "adjacentRight"), lanelets[0].attribute("id").value());
  EXPECT_STREQ(lanelets[0].child("adjacentLeft").attribute("drivingDir").value(), "same");
  EXPECT_FALSE(lanelets[0].child("adjacentRight"));
  EXPECT_FALSE(lanelets[1].child("adjacentLeft"));
}

TEST_F(CommonRoad, PartlyParallelLanesAreNotAdjacent) {
  const Lane lane = laneAlong("lane", straight(0.0, 0.0, 20.0));
  std::vector<Pose2> opposite = straight(0.0, 3.5, 20.0);
  std::reverse(opposite.begin(), opposite.end());
  for (Pose2& pose : opposite) pose.yaw = M_PI;
  std::vector<Pose2> bulging = straight(0.0, 3.5, 20.0);
  for (std::size_t i = 5; i < 16; ++i) bulging[i].y = 6.0;
  std::vector<Pose2> leaving = straight(0.0, 3.5, 20.0);
  for (Pose2& pose : leaving) pose.y += 0.5 * std::max(0.0, pose.x - 15.0);
  std::vector<Pose2> coming = straight(0.0, 3.5, 20.0);
  for (Pose2& pose : coming) pose.y += 0.5 * std::max(0.0, 5.0 - pose.x);
  const std::vector<std::vector<Pose2>> others = {opposite,
                                                  bulging,
                                                  leaving,
                                                  coming,
                                                  straight(0.0, 7.0, 20.0),
                                                  straight(4.0, 3.5, 20.0),
                                                  straight(0.0, 3.5, 14.0)};
  for (const std::vector<Pose2>& other : others) {
    for (const xml_node& lanelet : laneletsOf({lane, laneAlong("other", other)})) {
      EXPECT_FALSE(lanelet.child("adjacentLeft")) << &other - others.data();
      EXPECT_FALSE(lanelet.child("adjacentRight")) << &other - others.data();
    }
  }
}

TEST_F(CommonRoad, AmbiguousNeighboursAreNotAdjacent) {
  for (const double side : {1.0, -1.0}) {
    const auto lanelets = laneletsOf({laneAlong("lane", straight(0.0, 0.0, 20.0)),
                                      laneAlong("beside", straight(0.0, 3.5 * side, 20.0)),
                                      laneAlong("also", straight(0.0, 3.7 * side, 20.0))});
    for (const xml_node& lanelet : lanelets) {
      EXPECT_FALSE(lanelet.child("adjacentLeft")) << side;
      EXPECT_FALSE(lanelet.child("adjacentRight")) << side;
    }
  }
}

TEST_F(CommonRoad, LanesOfBicyclesAreLaneletsOfTheirOwnType) {
  CrashRecord record = slowCarRecord();
  record.lanes.lanes = {laneAlong("a", straight(0.0, 0.0, 20.0))};
  record.lanes.features = {{FeatureKind::kBikeLane, {{0, -2.5}, {10, -2.5}, {20, -2.5}}}};
  const auto range = written(record).children("lanelet");
  const std::vector<xml_node> lanelets(range.begin(), range.end());
  ASSERT_EQ(lanelets.size(), 2U);
  EXPECT_STREQ(lanelets[0].child_value("laneletType"), "urban");
  EXPECT_STREQ(lanelets[1].child_value("laneletType"), "bicycleLane");
  EXPECT_THAT(pointsOf(lanelets[1].child("leftBound")),
              ElementsAre(Vector2(0, -1.75), Vector2(10, -1.75), Vector2(20, -1.75)));
  EXPECT_EQ(refOf(lanelets[0], "adjacentRight"), "");
}

TEST_F(CommonRoad, APedestrianAttacks) {
  CrashRecord record = slowCarRecord();
  record.attacker.agent_class = AgentClass::kPedestrian;
  const xml_node attacker = written(record).find_child_by_attribute("dynamicObstacle", "id", "2");
  EXPECT_STREQ(attacker.child_value("type"), "pedestrian");
}

TEST_F(CommonRoad, ConnectorsAndLaneletsInJunctionsAreMarked) {
  Lane crossing = laneAlong("crossing", straight(0.0, 0.0, 20.0));
  crossing.is_intersection = true;
  Lane connector = laneAlong("connector", straight(40.0, 0.0, 20.0));
  connector.is_connector = true;
  const auto lanelets =
      laneletsOf({crossing, laneAlong("road", straight(20.0, 0.0, 20.0)), connector});
  EXPECT_TRUE(lanelets[0].select_node("laneletType[text()='intersection']"));
  EXPECT_TRUE(lanelets[2].select_node("laneletType[text()='intersection']"));
  EXPECT_FALSE(lanelets[1].select_node("laneletType[text()='intersection']"));
  EXPECT_TRUE(lanelets[1].select_node("laneletType[text()='urban']"));
}

TEST_F(CommonRoad, ATrackWithGapsIsOneObstaclePerStretch) {
  CrashRecord record = slowCarRecord();
  record.other_agents = {trackAt("b", AgentClass::kBicycle, {0, 1, 2, 5, 8, 9}, 3.0)};
  std::vector<std::vector<int>> steps;
  for (const xml_node& obstacle : written(record).children("dynamicObstacle")) {
    if (std::string(obstacle.child_value("type")) != "bicycle") continue;
    steps.emplace_back();
    for (const xml_node& state : statesOf(obstacle)) steps.back().push_back(stepAt(state));
  }
  // At step 5 it has no trajectory.
  EXPECT_THAT(steps, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(8, 9)));
}

TEST_F(CommonRoad, VehiclesAtRestAreStaticObstacles) {
  CrashRecord record = slowCarRecord();
  const std::vector<int> steps = allSteps(record);
  const std::vector<int> later(steps.begin() + 3, steps.end());
  record.other_agents = {trackAt("parked", AgentClass::kTruck, steps, 0.0),
                         trackAt("cone", AgentClass::kStaticObject, later, 0.0),
                         trackAt("creeping", AgentClass::kCar, steps, 0.1),
                         trackAt("turning", AgentClass::kCar, steps, 0.0),
                         trackAt("later", AgentClass::kCar, later, 0.0),
                         trackAt("waiting", AgentClass::kPedestrian, steps, 0.0)};
  record.other_agents[3].states.back().pose.yaw += 0.2;
  const xml_node root = written(record);
  std::vector<std::string> types;
  for (const xml_node& obstacle : root.children("staticObstacle")) {
    types.emplace_back(obstacle.child_value("type"));
    EXPECT_EQ(pointAt(obstacle.select_node("initialState/position/point").node()),
              Vector2(8.0, 9.0));
    EXPECT_EQ(stepAt(obstacle.child("initialState")), 0);
    EXPECT_FALSE(obstacle.child("trajectory"));
  }
  EXPECT_THAT(types, ElementsAre("parkedVehicle", "unknown"));
  EXPECT_EQ(root.select_nodes("dynamicObstacle").size(), 2U + 4U);
}

TEST_F(CommonRoad, TypesAreValidInTheSchema) {
  const std::vector<std::pair<AgentClass, std::string>> types = {
      {AgentClass::kCar, "car"},
      {AgentClass::kTruck, "truck"},
      {AgentClass::kBus, "bus"},
      {AgentClass::kTrailer, "truck"},
      {AgentClass::kConstructionVehicle, "truck"},
      {AgentClass::kEmergencyVehicle, "priorityVehicle"},
      {AgentClass::kMotorcycle, "motorcycle"},
      {AgentClass::kBicycle, "bicycle"},
      {AgentClass::kPedestrian, "pedestrian"},
      {AgentClass::kAnimal, "unknown"},
      {AgentClass::kChild, "pedestrian"},
      {AgentClass::kRunner, "pedestrian"},
      {AgentClass::kScooter, "bicycle"}};
  CrashRecord record = slowCarRecord();
  record.other_agents.clear();
  for (const auto& type : types)
    record.other_agents.push_back(trackAt("b", type.first, {0, 1, 2}, 2.0));
  const auto obstacles = written(record).select_nodes("dynamicObstacle[@id>3]/type");
  ASSERT_EQ(obstacles.size(), types.size());
  for (std::size_t i = 0; i < types.size(); ++i) {
    EXPECT_EQ(obstacles[i].node().child_value(), types[i].second);
  }
}

TEST_F(CommonRoad, TheProblemBeginsAtNowAndEndsWhereTheEgoDoes) {
  CrashRecord record = slowCarRecord();
  const auto now = static_cast<std::size_t>(std::lround(record.now / record.step));
  ASSERT_GT(now, 0U);
  record.ego.states[now - 1].pose.yaw = -0.01;
  record.ego.states[now + 1].pose.yaw = 0.03;
  const xml_node problem = written(record).child("planningProblem");
  const xml_node initial = problem.child("initialState");
  EXPECT_EQ(stepAt(initial), static_cast<int>(now));
  EXPECT_NEAR(number(initial, "position/point/x"), record.ego.states[now].pose.x, 1e-6);
  EXPECT_NEAR(number(initial, "velocity/exact"), 10.0, 1e-6);
  EXPECT_NEAR(number(initial, "yawRate/exact"), 0.04 / 0.2, 1e-6);
  EXPECT_EQ(number(initial, "slipAngle/exact"), 0.0);
  const xml_node goal = problem.child("goalState");
  const double end = static_cast<double>(record.ego.states.size() - 1);
  EXPECT_EQ(number(goal, "time/intervalStart"), end);
  EXPECT_EQ(number(goal, "time/intervalEnd"), end);
  EXPECT_NEAR(number(goal, "position/rectangle/center/x"), record.ego.states.back().pose.x, 1e-6);
  EXPECT_EQ(number(goal, "position/rectangle/length"), record.ego.size.length);
}

TEST_F(CommonRoad, AFreeEgoIsOnlyAPlanningProblem) {
  const CrashRecord record = slowCarRecord(0.0);
  const xml_node root = written(record, true);
  EXPECT_FALSE(root.find_child_by_attribute("dynamicObstacle", "id", "1"));
  EXPECT_TRUE(root.find_child_by_attribute("dynamicObstacle", "id", "2"));
  const xml_node problem = root.child("planningProblem");
  EXPECT_EQ(stepAt(problem.child("initialState")), 0);
  EXPECT_NEAR(number(problem, "initialState/position/point/x"), 0.0, 1e-6);
  EXPECT_EQ(number(problem, "goalState/time/intervalEnd"),
            static_cast<double>(record.ego.states.size() - 1));
  EXPECT_FALSE(problem.child("goalState").child("position"));
}

TEST_F(CommonRoad, NumbersHaveNoExponent) {
  CrashRecord record = slowCarRecord();
  record.ego.states[0].pose = {1e-5, -1e-9, -2e-6};
  record.ego.states[1].pose.x = 1.25e20;
  const std::string text = textOf(record);
  EXPECT_THAT(text, AllOf(HasSubstr("<x>0.00001</x>"), Not(HasSubstr(">-0<")),
                          HasSubstr("<exact>-0.000002</exact>"),
                          HasSubstr("<x>125000000000000000000</x>")));
  EXPECT_FALSE(std::regex_search(text, std::regex(">[-0-9.]+[eE]")));
  record.ego.states[1].pose.x = std::numeric_limits<double>::infinity();
  EXPECT_THROW(textOf(record), std::invalid_argument);
}

}  // namespace
}  // namespace forge
