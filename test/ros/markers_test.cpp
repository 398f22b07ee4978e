#include "collision_forge/ros/markers/markers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "collision_forge/ros/markers/marker_colors.h"
#include "collision_forge/ros/markers/marker_fill.h"
#include "collision_forge/ros/markers/marker_parts.h"

namespace forge {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std_msgs::Header header(double stamp) {
  std_msgs::Header header;
  header.frame_id = "map";
  header.stamp = ros::Time(stamp);
  return header;
}

geometry_msgs::Vector3 carSize() {
  geometry_msgs::Vector3 size;
  size.x = 4.6;
  size.y = 1.9;
  return size;
}

geometry_msgs::Pose2D pose2d(double x, double y, double yaw) {
  geometry_msgs::Pose2D pose;
  pose.x = x;
  pose.y = y;
  pose.theta = yaw;
  return pose;
}

geometry_msgs::Polygon square(double half_side) {
  geometry_msgs::Polygon polygon;
  for (const auto& [x, y] :
       {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
    geometry_msgs::Point32 point;
    point.x = static_cast<float>(x * half_side);
    point.y = static_cast<float>(y * half_side);
    polygon.points.push_back(point);
  }
  return polygon;
}

collision_forge::Lane lane(bool is_connector, double length) {
  collision_forge::Lane lane;
  lane.is_connector = is_connector;
  lane.centerline = {pose2d(0, 0, 0), pose2d(length / 2, 0, 0), pose2d(length, 0, 0)};
  return lane;
}

collision_forge::LaneMap junctionMap() {
  collision_forge::LaneMap map;
  map.header = header(1.0);
  map.drivable_area.resize(1);
  map.drivable_area[0].exterior = square(10);
  map.drivable_area[0].holes = {square(2)};
  map.walkways.resize(1);
  map.walkways[0].exterior = square(20);
  map.lanes = {lane(false, 20), lane(false, 10), lane(true, 5)};
  return map;
}

/// An attack from the right: contact 3 s from now at the origin.
collision_forge::Attack attack() {
  collision_forge::Attack attack;
  attack.header = attack.pattern.header = attack.trajectory.header = attack.report.header =
      header(10.0);
  attack.pattern.collision_type = "junction_crossing";
  attack.pattern.ego_size = attack.trajectory.size = carSize();
  attack.pattern.attacker_offset = pose2d(3.2, 0.0, M_PI / 2);
  for (int i = 0; i <= 40; ++i) {
    collision_forge::TrajectoryPoint point;
    point.stamp = ros::Time(10.0 + 0.1 * i);
    point.pose.position.x = 3.2;
    point.pose.position.y = i - 30.0;
    point.pose.orientation.z = point.pose.orientation.w = std::sqrt(0.5);
    attack.trajectory.points.push_back(point);
  }
  attack.report.verified = attack.report.contact = true;
  attack.report.contact_time = ros::Time(13.0);
  attack.report.relative_heading = M_PI / 2;
  attack.report.attacker_at_contact = pose2d(3.2, 0.0, M_PI / 2);
  attack.report.ego_side = "left";
  attack.report.attacker_side = "front";
  attack.report.impact_speed = 12.34;
  attack.report.overlap = 0.375;
  attack.report.manoeuvre = "straight_crossing";
  attack.report.manoeuvre_begin = ros::Time(11.5);
  attack.report.believable = true;
  return attack;
}

std::vector<Marker> inNamespace(const MarkerArray& array, const std::string& name) {
  std::vector<Marker> found;
  std::copy_if(array.markers.begin(), array.markers.end(), std::back_inserter(found),
               [&name](const Marker& marker) { return marker.ns == name; });
  return found;
}

void expectFinite(const geometry_msgs::Point& point) {
  EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z));
}

void expectScale(const Marker& marker) {
  EXPECT_TRUE(marker.scale.x > 0 || marker.type == Marker::TEXT_VIEW_FACING) << marker.ns;
  EXPECT_TRUE(marker.scale.y > 0 || marker.type == Marker::TEXT_VIEW_FACING ||
              marker.type == Marker::LINE_LIST)
      << marker.ns;
  EXPECT_TRUE(marker.scale.z > 0 || marker.type == Marker::LINE_LIST) << marker.ns;
}

/// What RViz asks of every marker, and what ours promise.
void expectValid(const MarkerArray& array, double stamp) {
  ASSERT_FALSE(array.markers.empty());
  EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
  std::set<std::pair<std::string, int>> keys;
  for (std::size_t i = 1; i < array.markers.size(); ++i) {
    const Marker& marker = array.markers[i];
    EXPECT_EQ(marker.action, Marker::ADD);
    EXPECT_EQ(marker.header.frame_id, "map");
    EXPECT_EQ(marker.header.stamp, ros::Time(stamp));
    EXPECT_TRUE(marker.lifetime.isZero());
    EXPECT_TRUE(keys.insert({marker.ns, marker.id}).second) << marker.ns << " " << marker.id;
    const auto& q = marker.pose.orientation;
    EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1.0, 1e-9) << marker.ns;
    EXPECT_GT(marker.color.a, 0.0F) << marker.ns;
    expectFinite(marker.pose.position);
    expectScale(marker);
    for (const auto& point : marker.points) expectFinite(point);
    const bool has_points =
        marker.type == Marker::LINE_LIST || marker.type == Marker::TRIANGLE_LIST;
    EXPECT_EQ(has_points, !marker.points.empty()) << marker.ns;
    EXPECT_EQ(marker.points.size() % (marker.type == Marker::LINE_LIST ? 2 : 3), 0U) << marker.ns;
  }
}

double area(const std::vector<Vector2>& triangles) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const Vector2 a = triangles[i + 1] - triangles[i];
    const Vector2 b = triangles[i + 2] - triangles[i];
    const double part = (a.x() * b.y() - a.y() * b.x()) / 2;
    EXPECT_GT(part, 0.0) << "clockwise or empty triangle " << i / 3;
    sum += part;
  }
  return sum;
}

TEST(FillTriangles, CoverAConcavePolygonWithoutItsHole) {
  const Polygon u_shape{{{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}},
                        {{{0.5, 0.5}, {0.5, 1.5}, {1.5, 1.5}, {1.5, 0.5}}}};
  EXPECT_NEAR(area(fillTriangles(u_shape)), 24.0 - 4.0 - 1.0, 1e-12);
}

TEST(FillTriangles, AreEmptyForEmptyAndNonFinitePolygons) {
  EXPECT_TRUE(fillTriangles({}).empty());
  EXPECT_TRUE(fillTriangles({{{0, 0}, {1, 1}}, {}}).empty());
  EXPECT_TRUE(fillTriangles({{{0, 0}, {1, 0}, {kNan, 1}}, {}}).empty());
}

TEST(MapMarkers, HaveAreaLanesAndConnectorsOnceEach) {
  const MarkerArray array = mapMarkers(junctionMap());
  expectValid(array, 1.0);
  EXPECT_EQ(array.markers.size(), 5U);
  EXPECT_EQ(inNamespace(array, "drivable_area").size(), 1U);
  EXPECT_EQ(inNamespace(array, "walkways").size(), 1U);
  // 2 straight lanes of a line, arrow heads of 2 lines at 7.5 m on both; 2 points a line.
  ASSERT_EQ(inNamespace(array, "lanes").size(), 1U);
  EXPECT_EQ(inNamespace(array, "lanes")[0].points.size(), 2U * (2 * 1 + 2 * 2));
  ASSERT_EQ(inNamespace(array, "connectors").size(), 1U);
  EXPECT_EQ(inNamespace(array, "connectors")[0].points.size(), 2U * 1);
}

TEST(MapMarkers, AreasAreMovedByTheOriginOfTheMap) {
  collision_forge::LaneMap map = junctionMap();
  map.origin.x = 8192.0;
  map.origin.y = -8192.0;
  for (const char* const name : {"drivable_area", "walkways"}) {
    const auto areas = inNamespace(mapMarkers(map), name);
    ASSERT_FALSE(areas.empty());
    for (const auto& point : areas[0].points) {
      EXPECT_NEAR(point.x, 8192.0, 20.0);
      EXPECT_NEAR(point.y, -8192.0, 20.0);
    }
  }
}

TEST(MapMarkers, ShowRoadEdgesAndPaintedSurfaces) {
  collision_forge::LaneMap map = junctionMap();
  for (const std::uint8_t kind :
       {collision_forge::MapFeature::MEDIAN, collision_forge::MapFeature::CROSSWALK,
        collision_forge::MapFeature::DRIVEWAY}) {
    map.features.emplace_back();
    map.features.back().kind = kind;
    map.features.back().points = square(2.0);
  }
  const MarkerArray array = mapMarkers(map);
  ASSERT_EQ(inNamespace(array, "road_edges").size(), 1U);
  EXPECT_EQ(inNamespace(array, "road_edges")[0].points.size(), 2U * 3);
  ASSERT_EQ(inNamespace(array, "painted").size(), 1U);
  EXPECT_EQ(inNamespace(array, "painted")[0].points.size(), 3U * 2);
}

TEST(LightMarkers, HaveTheirColourAtTheStopPoint) {
  collision_forge::TrafficLightArray lights;
  lights.header = header(3.0);
  lights.lights.resize(1);
  lights.lights[0].color = collision_forge::TrafficLight::RED;
  lights.lights[0].stop_point.x = 7.0;
  const auto discs = inNamespace(lightMarkers(lights), "traffic_lights");
  ASSERT_EQ(discs.size(), 1U);
  EXPECT_EQ(discs[0].pose.position.x, 7.0);
  EXPECT_GT(discs[0].color.r, 4.0F * discs[0].color.g);
}

TEST(MapMarkers, KeepEveryCentrelineWithinThreeCentimetresWithFewPoints) {
  constexpr double kRadius = 20.0;  // m
  collision_forge::LaneMap map = junctionMap();
  map.lanes = {lane(true, 5)};
  map.lanes[0].centerline.clear();
  for (int i = 0; i <= 100; ++i) {
    map.lanes[0].centerline.push_back(
        pose2d(kRadius * std::cos(0.01 * i), kRadius * std::sin(0.01 * i), 0.0));
  }
  const auto connectors = inNamespace(mapMarkers(map), "connectors");
  ASSERT_EQ(connectors.size(), 1U);
  const auto& points = connectors[0].points;
  EXPECT_LT(points.size(), 2U * 30);
  for (std::size_t i = 0; i + 2 * 2 < points.size(); i += 2) {  // the last two are an arrow head's
    const double x = 0.5 * (points[i].x + points[i + 1].x);
    const double y = 0.5 * (points[i].y + points[i + 1].y);
    EXPECT_GT(std::hypot(x, y), kRadius - 0.031) << i;
  }
}

TEST(AttackMarkers, HaveAGhostEveryHalfSecondUpToContact) {
  const MarkerArray array = attackMarkers(attack());
  expectValid(array, 10.0);
  const auto ghosts = inNamespace(array, "attacker_ghosts");
  ASSERT_EQ(ghosts.size(), 7U);
  EXPECT_DOUBLE_EQ(ghosts[1].pose.position.y - ghosts[0].pose.position.y, 5.0);
  ASSERT_EQ(inNamespace(array, "attacker_path").size(), 1U);
  EXPECT_EQ(inNamespace(array, "attacker_path")[0].points.size(), 2U * 30);
}

TEST(AttackMarkers, MarkTheContactWhereTheBoxesTouch) {
  const auto contact = inNamespace(attackMarkers(attack()), "contact");
  ASSERT_EQ(contact.size(), 1U);
  EXPECT_NEAR(contact[0].pose.position.x, 2.3, 0.06);
  EXPECT_LE(std::abs(contact[0].pose.position.y), 0.96);
}

TEST(AttackMarkers, ShowThePastOfAnAddedAttacker) {
  EXPECT_TRUE(inNamespace(attackMarkers(attack()), "added_past").empty());
  collision_forge::Attack added = attack();
  added.trajectory.added = true;
  for (int i = 0; i <= 3; ++i) {
    added.trajectory.past.emplace_back();
    added.trajectory.past.back().pose = pose2d(3.2, -45.0 + 5.0 * i, M_PI / 2);
  }
  const MarkerArray array = attackMarkers(added);
  expectValid(array, 10.0);
  ASSERT_EQ(inNamespace(array, "added_past").size(), 1U);
  EXPECT_EQ(inNamespace(array, "added_past")[0].points.size(), 2U * 3);
}

/// `count` patterns of agents "a0", "a1" ..., five metres left of each other, all in the scene.
std::pair<collision_forge::PredictedPatterns, collision_forge::SceneSnapshot> predicted(int count) {
  collision_forge::PredictedPatterns patterns;
  collision_forge::SceneSnapshot scene;
  patterns.header = scene.header = header(1.0);
  for (int i = 0; i < count; ++i) {
    collision_forge::CollisionPattern pattern;
    pattern.attacker_id = "a" + std::to_string(i);
    pattern.ego = pose2d(10.0, 0.0, M_PI / 2);
    pattern.ego_size = carSize();
    pattern.attacker_offset = pose2d(0.0, 5.0 * (i + 1), 0.0);
    patterns.patterns.push_back(pattern);
    collision_forge::AgentTrack agent;
    agent.id = pattern.attacker_id;
    agent.size = carSize();
    scene.agents.push_back(agent);
  }
  return {patterns, scene};
}

TEST(PatternMarkers, ShowTheFirstPatternsIncreasinglyFaint) {
  const auto [patterns, scene] = predicted(7);
  const MarkerArray array = patternMarkers(patterns, scene);
  expectValid(array, 1.0);
  const auto attackers = inNamespace(array, "predicted_attacker");
  ASSERT_EQ(attackers.size(), 5U);
  EXPECT_EQ(inNamespace(array, "predicted_ego").size(), 5U);
  for (std::size_t i = 0; i < attackers.size(); ++i) {
    // Left of an ego that heads along y is towards -x.
    double middle = 0.0;
    for (const auto& point : attackers[i].points) {
      middle += point.x / static_cast<double>(attackers[i].points.size());
      EXPECT_LT(point.z, kVehicleHeight) << "it would cover vehicles";
    }
    EXPECT_NEAR(middle, 10.0 - 5.0 * (static_cast<double>(i) + 1.0), 1e-9);
    EXPECT_EQ(attackers[i].type, Marker::LINE_LIST) << "an outline";
    if (i > 0) {
      EXPECT_LT(attackers[i].color.a, attackers[i - 1].color.a);
    }
  }
}

TEST(CrashMarkers, CountDownThenShowTheVerdict) {
  const collision_forge::Attack shown = attack();
  CrashView view;
  view.attack = &shown;
  view.header = header(11.0);
  EXPECT_EQ(inNamespace(crashMarkers(view), "words")[0].text, "contact in 2.0 s");
  view.header = header(13.0);
  EXPECT_EQ(inNamespace(crashMarkers(view), "words")[0].text.find("contact as requested\n"), 0U);
}

TEST(CrashMarkers, KeepTheTextInPlaceWhileTheVehiclesApproach) {
  const collision_forge::Attack shown = attack();
  CrashView view;
  view.attack = &shown;
  std::vector<geometry_msgs::Point> places;
  for (double time : {10.5, 11.5, 12.5}) {
    view.header = header(time);
    view.ego = OrientedBox{{time - 13.0, 3.0, 0.0}, {4.6, 1.9}};
    places.push_back(inNamespace(crashMarkers(view), "words")[0].pose.position);
  }
  EXPECT_EQ(places[1], places[0]);
  EXPECT_EQ(places[2], places[0]);
}

TEST(CrashMarkers, PlaceTheTextBesideTheObstacles) {
  const collision_forge::Attack shown = attack();
  CrashView view;
  view.attack = &shown;
  view.header = header(11.0);
  const auto place = [&view] {
    const auto plate = inNamespace(crashMarkers(view), "words_plate")[0];
    return OrientedBox{{plate.pose.position.x, plate.pose.position.y, 0.0},
                       {plate.scale.x, plate.scale.y}};
  };
  view.words_obstacles = {place()};
  EXPECT_FALSE(overlaps(place(), view.words_obstacles[0]));
}

TEST(AnnotationMarkers, HaveABoxPerAgentAndTheIdOfPossibleAttackers) {
  collision_forge::AgentArray agents;
  agents.header = header(5.0);
  agents.agents.resize(3);
  for (auto& agent : agents.agents) {
    agent.id = "c0ffee00c0ffee";
    agent.size = carSize();
    agent.size.z = 1.7;
    agent.pose.orientation.w = 1.0;
    agent.pose.position.x = 20.0 * static_cast<double>(&agent - agents.agents.data());
  }
  agents.agents[1].agent_class = collision_forge::Agent::PEDESTRIAN;
  agents.agents[2].agent_class = 255;
  const MarkerArray array = annotationMarkers(agents);
  expectValid(array, 5.0);
  const auto boxes = inNamespace(array, "agents");
  ASSERT_EQ(boxes.size(), 3U);
  EXPECT_DOUBLE_EQ(boxes[0].scale.z, 1.7);
  ASSERT_EQ(inNamespace(array, "ids").size(), 1U);
  EXPECT_EQ(inNamespace(array, "ids")[0].text, "c0ffee");
}

TEST(AnnotationMarkers, ShowSupportVehiclesInAColourOfTheirOwn) {
  collision_forge::AgentArray agents;
  agents.header = header(5.0);
  agents.agents.resize(2);
  for (auto& agent : agents.agents) {
    agent.size = carSize();
    agent.pose.orientation.w = 1.0;
  }
  agents.agents[0].id = "car";
  agents.agents[1].id = "parked-1";
  const auto boxes = inNamespace(annotationMarkers(agents, "", {"parked-1"}), "agents");
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_EQ(boxes[0].color, colors::toMessage(colors::agentColor(0)));
  EXPECT_EQ(boxes[1].color, colors::toMessage(colors::kSupport));
  for (std::uint8_t i = 0; i < colors::kAgentClasses.size(); ++i) {
    EXPECT_FALSE(boxes[1].color == colors::toMessage(colors::agentColor(i)));
  }
}

TEST(NoMarkers, DeleteAllEarlierMarkers) {
  const MarkerArray array = noMarkers(header(7.0));
  expectValid(array, 7.0);
  EXPECT_EQ(array.markers.size(), 1U);
}

TEST(AttackMarkers, ShowTheDrivenPartApartFromThePlan) {
  auto message = attack();
  message.adaptive = true;
  EXPECT_EQ(inNamespace(attackMarkers(attack(), ros::Time(11.0)), "driven").size(), 0u);
  const MarkerArray markers = attackMarkers(message, ros::Time(11.0));
  const auto driven = inNamespace(markers, "driven");
  const auto planned = inNamespace(markers, "attacker_path");
  ASSERT_EQ(driven.size(), 1u);
  ASSERT_EQ(planned.size(), 1u);
  EXPECT_EQ(driven[0].points.front().y, -30.0);
  EXPECT_EQ(driven[0].points.back().y, -20.0);
  EXPECT_EQ(planned[0].points.front().y, -20.0);
  EXPECT_EQ(planned[0].points.back().y, 0.0);
  EXPECT_GT(driven[0].scale.x, planned[0].scale.x);
  EXPECT_EQ(inNamespace(attackMarkers(message, ros::Time(14.0)), "attacker_path").size(), 0u)
      << "all is driven";
}

}  // namespace
}  // namespace forge
