#include "collision_forge/io/export/road_network.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>

namespace forge {
namespace {

constexpr double kPi = 3.141592653589793;

/// A lane or connector along one arc.
Lane newLane(const std::string& id, bool is_connector, const std::vector<std::string>& outgoing) {
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
    lanes.lanes.push_back(newLane(id, is_connector, outgoing));
    arcs[id] = {path};
  }
  RoadNetwork network() const { return roadNetwork(lanes, arcs, 3.5); }
};

/// Returns the first road of each name.
std::map<std::string, Road> byLane(const RoadNetwork& network) {
  std::map<std::string, Road> roads;
  for (const Road& road : network.roads) roads.emplace(road.name(), road);
  return roads;
}

const RoadLane& laneOf(const Road& road, int id) {
  return id < 0 ? road.right.at(static_cast<std::size_t>(-id - 1))
                : road.left.at(static_cast<std::size_t>(id - 1));
}

/// Returns the middle of a lane at one end of its road.
Vector2 middleOf(const Road& road, int id, bool at_end) {
  const std::size_t knot = at_end ? road.knots.size() - 1 : 0;
  double offset = road.offset[knot];
  const int side = id < 0 ? -1 : 1;
  for (int inner = side; inner != id; inner += side) {
    offset += side * laneOf(road, inner).width[knot];
  }
  offset += 0.5 * side * laneOf(road, id).width[knot];
  const Pose2 pose = road.course.poseAt(at_end ? road.course.length() : 0.0);
  return compose(pose, {0.0, offset, 0.0}).position();
}

/// Checks the rules of OpenDRIVE for every network: links are mutual, connecting roads connect
/// plain roads, linked lanes meet, and every connection is listed once.
void expectSound(const RoadNetwork& network) {
  std::map<int, const Road*> roads;
  std::set<int> ids;
  for (const Road& road : network.roads) {
    roads[road.id] = &road;
    EXPECT_TRUE(ids.insert(road.id).second);
    EXPECT_GT(road.course.length(), 0.0);
  }
  std::set<int> listed;
  for (const Junction& junction : network.junctions) {
    EXPECT_TRUE(ids.insert(junction.id).second);
    for (const Junction::Connection& one : junction.connections) {
      EXPECT_TRUE(listed.insert(one.connecting).second);
      const Road& connecting = *roads.at(one.connecting);
      const Road& incoming = *roads.at(one.incoming);
      EXPECT_EQ(connecting.junction, junction.id);
      EXPECT_EQ(incoming.junction, 0);
      EXPECT_EQ(connecting.before.id, one.incoming);
      EXPECT_EQ(laneOf(connecting, one.to).before, one.from);
      const RoadJoint& back = connecting.before.at_end ? incoming.after : incoming.before;
      EXPECT_EQ(back.to, RoadJoint::To::kJunction);
      EXPECT_EQ(back.id, junction.id);
    }
  }
  for (const Road& road : network.roads) {
    EXPECT_EQ(road.junction != 0, listed.count(road.id) > 0) << road.name();
    for (const bool at_end : {false, true}) {
      const RoadJoint& joint = at_end ? road.after : road.before;
      if (joint.to != RoadJoint::To::kRoad) continue;
      const Road& next = *roads.at(joint.id);
      const RoadJoint& back = joint.at_end ? next.after : next.before;
      EXPECT_EQ(back.id, road.junction != 0 ? road.junction : road.id);
      for (const auto* lanes : {&road.left, &road.right}) {
        for (const RoadLane& lane : *lanes) {
          const std::optional<int>& to = at_end ? lane.after : lane.before;
          if (!to) continue;
          EXPECT_LT((middleOf(road, lane.id, at_end) - middleOf(next, *to, joint.at_end)).norm(),
                    0.01)
              << road.name() << " to " << next.name();
        }
      }
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
  ASSERT_EQ(roads.at("c").course.pieces().size(), 1u);
  EXPECT_DOUBLE_EQ(roads.at("c").course.pieces()[0].curvature, 0.2);
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
  EXPECT_NEAR(roads.at("b").course.length(), 20.0 - kForkPiece, 1e-12);
  EXPECT_NEAR(roads.at("c").course.length(), 0.4, 1e-12);  // a third of a short lane at most
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

/// Two lanes of 3.5 m side by side, and one beside them in the other direction.
Map threeLanes(double start_of_second = 0.0) {
  Map map;
  map.add("left", false, straight({0, 0, 0}, 40.0), {});
  map.add("right", false, straight({start_of_second, -3.5, 0}, 40.0 - start_of_second), {});
  map.add("back", false, straight({40, 3.5, kPi}, 40.0), {});
  return map;
}

TEST(RoadNetwork, LanesSideBySideShareARoad) {
  const RoadNetwork network = threeLanes().network();
  ASSERT_EQ(network.roads.size(), 1u);
  const Road& road = network.roads[0];
  ASSERT_EQ(road.right.size(), 2u);
  ASSERT_EQ(road.left.size(), 1u);
  EXPECT_EQ(road.right[0].lane, "left");
  EXPECT_EQ(road.right[1].lane, "right");
  EXPECT_EQ(road.left[0].lane, "back");
  EXPECT_NEAR(middleOf(road, -2, false).y(), -3.5, 1e-9);
  EXPECT_NEAR(middleOf(road, 1, true).y(), 3.5, 1e-9);
  EXPECT_EQ(network.unbundled, 0u);
}

TEST(RoadNetwork, InLeftHandTrafficOncomingLanesAreOnTheRight) {
  Map map = threeLanes();
  map.lanes.driving_side = DrivingSide::kLeft;
  EXPECT_EQ(map.network().roads.size(), 2u);
  map.arcs["back"] = {straight({40, -7.0, kPi}, 40.0)};
  const RoadNetwork network = map.network();
  ASSERT_EQ(network.roads.size(), 1u);
  EXPECT_EQ(network.roads[0].left.at(0).lane, "right");
  EXPECT_EQ(network.roads[0].left.at(1).lane, "left");
  EXPECT_EQ(network.roads[0].right.at(0).lane, "back");
}

TEST(RoadNetwork, ALaneThatLeadsNowhereMayEndWithinItsRoad) {
  const RoadNetwork network = threeLanes(4.0).network();
  ASSERT_EQ(network.roads.size(), 1u);
  EXPECT_NEAR(network.roads[0].right.at(1).from, 4.0, 1e-6);
  EXPECT_NEAR(network.roads[0].course.length(), 40.0, 1e-6);
}

TEST(RoadNetwork, StaggeredEndsBelongToTheConnectingRoads) {
  Map map = threeLanes();
  map.lanes.lanes[0].outgoing = {"on"};
  map.lanes.lanes[1].outgoing = {"off"};
  map.arcs["right"] = {straight({0, -3.5, 0}, 42.0)};
  map.add("on", true, straight({40, 0, 0}, 10.0), {"ahead"});
  map.add("off", true, {{42, -3.5, 0}, {'R', 'S', 'S'}, 8.0, {8.0 * kPi / 2, 0, 0}}, {"aside"});
  map.add("ahead", false, straight({50, 0, 0}, 30.0), {});
  map.add("aside", false, straight({50, -11.5, -kPi / 2}, 30.0), {});
  const RoadNetwork network = map.network();
  expectSound(network);
  const auto roads = byLane(network);
  EXPECT_NEAR(roads.at("back left right").course.length(), 40.0, 1e-6);
  EXPECT_NEAR(roads.at("off").course.length(), 2.0 + 8.0 * kPi / 2, 1e-6);
  ASSERT_EQ(network.junctions.size(), 1u);
  EXPECT_EQ(network.junctions[0].connections.size(), 2u);
}

TEST(RoadNetwork, RoadsWithTheSameLanesAreLinkedDirectly) {
  Map map = threeLanes();
  map.lanes.lanes[0].outgoing = {"left 2"};
  map.lanes.lanes[1].outgoing = {"right 2"};
  map.add("left 2", false, straight({40, 0, 0}, 40.0), {});
  map.add("right 2", false, straight({40, -3.5, 0}, 40.0), {});
  map.add("back 2", false, straight({80, 3.5, kPi}, 40.0), {"back"});
  const RoadNetwork network = map.network();
  expectSound(network);
  EXPECT_TRUE(network.junctions.empty());
  ASSERT_EQ(network.roads.size(), 2u);
  EXPECT_EQ(network.roads[0].right[1].after, -2);
  EXPECT_EQ(network.roads[1].left[0].before, 1);
}

TEST(RoadNetwork, LanesThatCannotShareARoadAreCounted) {
  Map map = threeLanes();
  map.lanes.lanes[0].outgoing = {"on"};
  map.add("on", false, straight({40, 0, 0}, 30.0), {});
  map.arcs["right"] = {straight({0, -3.5, 0}, 46.0)};  // its end would be cut off
  const RoadNetwork network = map.network();
  expectSound(network);
  EXPECT_EQ(network.unbundled, 1u);
  EXPECT_EQ(network.roads.size(), 3u);
  EXPECT_EQ(byLane(network).count("back left"), 1u);
}

TEST(RoadNetwork, WithoutArcsARoadFollowsTheCentrelinePoses) {
  const ArcPath path{{3, -2, 0.4}, {'L', 'S', 'R'}, 12.0, {9.0, 6.0, 5.0}};
  Lane lane = newLane("a", false, {});
  lane.centerline = discretize({path}, 1.0);
  const RoadCourse course = courseOf(lane, {});
  double begin = 0.0;
  for (const RoadPiece& piece : course.pieces()) {
    const Pose2 expected = poseAt(path, begin);
    EXPECT_NEAR(piece.start.x, expected.x, 2e-3);
    EXPECT_NEAR(piece.start.y, expected.y, 2e-3);
    begin += piece.length;
  }
  EXPECT_NEAR(begin, path.length(), 1e-2);
}

TEST(RoadNetwork, WidthFollowsTheOutlineWithinBounds) {
  Lane lane = newLane("a", false, {});
  EXPECT_EQ(widthOf(lane, 10.0, 3.5), 3.5);
  lane.polygon = {{0, -1.5}, {10, -1.5}, {10, 1.5}, {0, 1.5}};
  EXPECT_DOUBLE_EQ(widthOf(lane, 10.0, 3.5), 3.0);
  EXPECT_DOUBLE_EQ(widthOf(lane, 1.0, 3.5), 8.0);
  EXPECT_DOUBLE_EQ(widthOf(lane, 1000.0, 3.5), 2.0);
}

}  // namespace
}  // namespace forge
