#include "collision_forge/io/export/road_network.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace forge {
namespace {

constexpr double kPi = 3.141592653589793;

/// A lane or connector along one arc.
Lane laneOf(const std::string& id, bool is_connector, const std::vector<std::string>& outgoing) {
  Lane lane;
  lane.id = id;
  lane.is_connector = is_connector;
  lane.outgoing = outgoing;
  return lane;
}

ArcPath straight(const Pose2& start, double length) {
  return {start, {'S', 'S', 'S'}, 1.0, {length, 0.0, 0.0}};
}

struct Map {
  LaneMap lanes;
  LaneArcs arcs;

  void add(const std::string& id, bool is_connector, const ArcPath& path,
           const std::vector<std::string>& outgoing) {
    lanes.lanes.push_back(laneOf(id, is_connector, outgoing));
    arcs[id] = {path};
  }
  RoadNetwork network() const { return roadNetwork(lanes, arcs, 3.5); }
};

std::map<std::string, Road> byLane(const RoadNetwork& network) {
  std::map<std::string, Road> roads;
  for (const Road& road : network.roads) roads.emplace(road.lane, road);
  return roads;
}

Pose2 endOf(const Road& road) {
  const RoadPiece& last = road.course.back();
  return alongArc(last.start, last.curvature, last.length);
}

/// Checks the rules of OpenDRIVE for every network: links are mutual, connecting roads connect
/// plain roads, linked roads meet, and every connection is listed once.
void expectSound(const RoadNetwork& network) {
  std::map<int, const Road*> roads;
  std::set<int> ids;
  for (const Road& road : network.roads) {
    roads[road.id] = &road;
    EXPECT_TRUE(ids.insert(road.id).second);
    EXPECT_GT(road.length(), 0.0);
  }
  std::set<int> listed;
  for (const Junction& junction : network.junctions) {
    EXPECT_TRUE(ids.insert(junction.id).second);
    for (const Junction::Connection& one : junction.connections) {
      EXPECT_TRUE(listed.insert(one.connecting).second);
      EXPECT_EQ(roads.at(one.connecting)->junction, junction.id);
      EXPECT_EQ(roads.at(one.incoming)->junction, 0);
      EXPECT_EQ(roads.at(one.incoming)->after.to, RoadJoint::To::kJunction);
      EXPECT_EQ(roads.at(one.incoming)->after.id, junction.id);
    }
  }
  for (const Road& road : network.roads) {
    EXPECT_EQ(road.junction != 0, listed.count(road.id) > 0) << road.lane;
    if (road.after.to != RoadJoint::To::kRoad) continue;
    const Road& next = *roads.at(road.after.id);
    EXPECT_LT((endOf(road).position() - next.course.front().start.position()).norm(), 1e-9)
        << road.lane << " to " << next.lane;
    if (road.junction != 0) {
      EXPECT_EQ(next.before.id, road.junction);
      EXPECT_EQ(next.junction, 0);
    } else {
      EXPECT_EQ(next.before.id, road.id);
    }
  }
}

TEST(RoadNetwork, LanesWithoutAlternativeAreLinkedDirectly) {
  Map map;
  map.add("a", false, straight({0, 0, 0}, 10.0), {"c"});
  map.add("c", true, {{10, 0, 0}, {'L', 'S', 'S'}, 5.0, {5.0 * kPi / 2, 0, 0}}, {"b"});
  map.add("b", false, straight({15, 5, kPi / 2}, 20.0), {});
  const RoadNetwork network = map.network();
  expectSound(network);
  EXPECT_TRUE(network.junctions.empty());
  const auto roads = byLane(network);
  EXPECT_EQ(roads.at("a").after.id, roads.at("c").id);
  EXPECT_EQ(roads.at("c").after.id, roads.at("b").id);
  EXPECT_EQ(roads.at("b").after.to, RoadJoint::To::kNothing);
  ASSERT_EQ(roads.at("c").course.size(), 1u);
  EXPECT_DOUBLE_EQ(roads.at("c").course[0].curvature, 0.2);
}

TEST(RoadNetwork, ConnectorsOfAForkAreConnectingRoadsOfOneJunction) {
  Map map;
  map.add("a", false, straight({0, 0, 0}, 10.0), {"left", "on"});
  map.add("left", true, {{10, 0, 0}, {'L', 'S', 'S'}, 5.0, {5.0 * kPi / 2, 0, 0}}, {"b"});
  map.add("on", true, straight({10, 0, 0}, 8.0), {"c"});
  map.add("b", false, straight({15, 5, kPi / 2}, 20.0), {});
  map.add("c", false, straight({18, 0, 0}, 20.0), {});
  const RoadNetwork network = map.network();
  expectSound(network);
  ASSERT_EQ(network.junctions.size(), 1u);
  EXPECT_EQ(network.junctions[0].connections.size(), 2u);
  const auto roads = byLane(network);
  EXPECT_NE(roads.at("left").junction, 0);
  EXPECT_NE(roads.at("on").junction, 0);
  EXPECT_EQ(roads.at("c").before.to, RoadJoint::To::kJunction);
}

TEST(RoadNetwork, ForksWithoutConnectorsGetShortConnectingRoads) {
  Map map;
  map.add("a", false, straight({0, 0, 0}, 10.0), {"b", "c"});
  map.add("b", false, straight({10, 0, 0}, 20.0), {});
  map.add("c", false, straight({10, 0, 0.1}, 0.6), {});
  const RoadNetwork network = map.network();
  expectSound(network);
  ASSERT_EQ(network.junctions.size(), 1u);
  ASSERT_EQ(network.roads.size(), 5u);
  const auto roads = byLane(network);
  EXPECT_NEAR(roads.at("b").length(), 20.0 - kForkPiece, 1e-12);
  EXPECT_NEAR(roads.at("c").length(), 0.4, 1e-12);  // a third of a short lane at most
}

TEST(RoadNetwork, DropsLinksAcrossGapsAndLanesWithoutCentreline) {
  Map map;
  map.add("a", false, straight({0, 0, 0}, 10.0), {"b", "none", "a", "short"});
  map.add("b", false, straight({10.5, 0, 0}, 10.0), {});
  map.add("short", false, straight({10, 0, 0}, 0.01), {});
  const RoadNetwork network = map.network();
  expectSound(network);
  EXPECT_EQ(network.roads.size(), 2u);
  EXPECT_EQ(byLane(network).at("a").after.to, RoadJoint::To::kNothing);
}

TEST(RoadNetwork, WithoutArcsARoadFollowsTheCentrelinePoses) {
  const ArcPath path{{3, -2, 0.4}, {'L', 'S', 'R'}, 12.0, {9.0, 6.0, 5.0}};
  Lane lane = laneOf("a", false, {});
  lane.centerline = discretize({path}, 1.0);
  const auto course = courseOf(lane, {});
  double begin = 0.0;
  for (const RoadPiece& piece : course) {
    const Pose2 expected = poseAt(path, begin);
    EXPECT_NEAR(piece.start.x, expected.x, 2e-3);
    EXPECT_NEAR(piece.start.y, expected.y, 2e-3);
    begin += piece.length;
  }
  EXPECT_NEAR(begin, path.length(), 1e-2);
}

TEST(RoadNetwork, WidthFollowsTheOutlineWithinBounds) {
  Lane lane = laneOf("a", false, {});
  EXPECT_EQ(widthOf(lane, 10.0, 3.5), 3.5);
  lane.polygon = {{0, -1.5}, {10, -1.5}, {10, 1.5}, {0, 1.5}};
  EXPECT_DOUBLE_EQ(widthOf(lane, 10.0, 3.5), 3.0);
  EXPECT_DOUBLE_EQ(widthOf(lane, 1.0, 3.5), 8.0);
  EXPECT_DOUBLE_EQ(widthOf(lane, 1000.0, 3.5), 2.0);
}

}  // namespace
}  // namespace forge
