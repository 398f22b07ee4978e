#include "collision_forge/io/export/drivable_edge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

using Line = std::vector<Vector2>;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr double kFar = 1000.0;  // m
const Line kOrigin = {{0.0, 0.0}};

Polygon rectangle(double left, double bottom, double right, double top) {
  return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, {}};
}

TEST(DrivableEdge, AHoleIsAnEdge) {
  Polygon square = rectangle(0, 0, 30, 30);
  square.holes = {rectangle(10, 10, 20, 20).exterior};
  const auto lines = drivableEdges({square}, kOrigin, kFar);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_THAT(lines[1], ElementsAre(Vector2(10, 10), Vector2(20, 10), Vector2(20, 20),
                                    Vector2(10, 20), Vector2(10, 10)));
}

TEST(DrivableEdge, SharedBordersAreNoEdge) {
  const auto lines =
      drivableEdges({rectangle(0, 0, 10, 4), rectangle(10, 0, 20, 4)}, kOrigin, kFar);
  EXPECT_THAT(lines, UnorderedElementsAre(
                         Line{{0.0, 0.0}, {10.0, 0.0}}, Line{{10.0, 4.0}, {0.0, 4.0}, {0.0, 0.0}},
                         Line{{10.0, 0.0}, {20.0, 0.0}, {20.0, 4.0}, {10.0, 4.0}}));
}

TEST(DrivableEdge, ALineIsCutWhereItLeadsIntoAnotherPolygon) {
  // A street from the left joins one that runs from bottom to top.
  const auto lines =
      drivableEdges({rectangle(-30, -2, 0.2, 2), rectangle(-3, -30, 3, 30)}, kOrigin, kFar);
  const auto ends = [&](const Line& line) { return line.front().x() == -30.0; };
  const auto street = std::find_if(lines.begin(), lines.end(), ends);
  ASSERT_NE(street, lines.end());
  EXPECT_EQ(street->front(), Vector2(-30, -2));
  EXPECT_NEAR(street->back().x(), -3.0, kEdgePiece);
  EXPECT_EQ(street->size(), 2u);
}

TEST(DrivableEdge, ReturnsOnlyNearbyEdges) {
  const std::vector<Polygon> street = {rectangle(-100, -2, 100, 2)};
  const auto lines = drivableEdges(street, {{20.0, 0.0}, {30.0, 0.0}}, 10.0);
  ASSERT_EQ(lines.size(), 2u);
  for (const Line& line : lines) {
    ASSERT_EQ(line.size(), 2u);
    const auto [left, right] = std::minmax(line[0].x(), line[1].x());
    EXPECT_NEAR(left, 20.0 - std::sqrt(96.0), kEdgePiece);
    EXPECT_NEAR(right, 30.0 + std::sqrt(96.0), kEdgePiece);
  }
  EXPECT_THAT(drivableEdges(street, {{0.0, 50.0}}, 10.0), IsEmpty());
}

}  // namespace
}  // namespace forge
