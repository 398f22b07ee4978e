#include "collision_forge/planner_test/planners/lane_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

std::shared_ptr<LaneMap> withLanes(std::vector<Lane> lanes) {
  auto map = std::make_shared<LaneMap>();
  map->lanes = std::move(lanes);
  return map;
}

std::size_t nodeAt(const LaneGraph& graph, const Vector2& point) {
  for (std::size_t i = 0; i < graph.nodes().size(); ++i) {
    if ((graph.nodes()[i] - point).norm() < 1e-6) return i;
  }
  return graph.nodes().size();
}

TEST(LaneGraph, LongStretchesAreDivided) {
  const LaneIndex lanes(withLanes({straightLane("a", {0.0, 0.0}, {10.0, 0.0})}));
  const LaneGraph graph = laneGraphOf(lanes, 1.0);
  ASSERT_EQ(graph.edges().size(), 10U);
  for (const LaneGraph::Edge& edge : graph.edges()) {
    EXPECT_NEAR((graph.nodes()[edge.second] - graph.nodes()[edge.first]).x(), 1.0, 1e-12);
  }
}

TEST(LaneGraph, EndsThatCoincideAreOneNodeWhateverTheOrderOfTheLanes) {
  const Lane in = straightLane("in", {0.0, 0.0}, {5.0, 0.0}, {"left", "on"});
  const Lane on = straightLane("on", {5.0, 0.0}, {10.0, 0.0});
  const Lane left = straightLane("left", {5.0, 0.0}, {5.0, 5.0});
  for (const auto& lanes : {std::vector<Lane>{in, on, left}, std::vector<Lane>{on, left, in}}) {
    const LaneGraph graph = laneGraphOf(LaneIndex(withLanes(lanes)), 1.0);
    EXPECT_EQ(graph.nodes().size(), 16U);
    EXPECT_EQ(graph.edges().size(), 15U);
    const std::size_t fork = nodeAt(graph, {5.0, 0.0});
    EXPECT_EQ(graph.successors(fork).size(), 2U);
    EXPECT_EQ(graph.predecessors(fork), std::vector<std::size_t>{nodeAt(graph, {4.0, 0.0})});
  }
}

TEST(LaneGraph, AnEdgeJoinsEndsThatAreApart) {
  const LaneGraph graph =
      laneGraphOf(LaneIndex(withLanes({straightLane("a", {0.0, 0.0}, {5.0, 0.0}, {"b"}),
                                       straightLane("b", {6.0, 0.0}, {9.0, 0.0})})),
                  1.0);
  EXPECT_EQ(graph.successors(nodeAt(graph, {5.0, 0.0})),
            std::vector<std::size_t>{nodeAt(graph, {6.0, 0.0})});
}

TEST(LaneGraph, FindsTheEdgesAroundAPlace) {
  const LaneGraph graph = laneGraphOf(*threeLaneRoad(), 1.0);
  const Vector2 place(33.3, 1.0);
  const std::vector<std::size_t> found = graph.edgesAround(place, 3.0);
  EXPECT_LT(found.size(), 200U);
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    const Vector2& from = graph.nodes()[graph.edges()[i].first];
    const Vector2& to = graph.nodes()[graph.edges()[i].second];
    if (std::min((from - place).norm(), (to - place).norm()) > 3.0) continue;
    EXPECT_EQ(std::count(found.begin(), found.end(), i), 1);
  }
}

TEST(LaneGraph, RefusesEdgesWithoutLengthOrNodes) {
  EXPECT_THROW(LaneGraph({{0.0, 0.0}, {0.0, 0.0}}, {{0, 1}}), std::invalid_argument);
  EXPECT_THROW(LaneGraph({{0.0, 0.0}}, {{0, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace forge
