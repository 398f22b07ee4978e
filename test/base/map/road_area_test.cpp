#include "collision_forge/base/map/road_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

constexpr double kAccuracy = 0.1;  // m, of straight borders

/// A road of 80 m along x, 12 m wide, with lanes at y = 2.5 (backwards) and y = -2.5.
struct TestRoad {
  TestRoad() {
    addEdge(FeatureKind::kRoadEdge, {{0.0, -6.0}, {80.0, -6.0}});
    addEdge(FeatureKind::kRoadEdge, {{80.0, 6.0}, {0.0, 6.0}});
    addLane({{80.0, 2.5}, {0.0, 2.5}});
    addLane({{0.0, -2.5}, {80.0, -2.5}});
  }

  void addEdge(FeatureKind kind, std::vector<Vector2> points) {
    features.push_back({kind, std::move(points)});
  }

  void addLane(const std::vector<Vector2>& points) {
    Lane lane;
    for (const Vector2& point : points) lane.centerline.push_back({point.x(), point.y(), 0.0});
    lanes.push_back(std::move(lane));
  }

  bool isRoad(double x, double y) const {
    const std::vector<Polygon> area = roadArea(features, lanes);
    return std::any_of(area.begin(), area.end(), [&](const Polygon& polygon) {
      return contains(polygon, {x, y});
    });
  }

  std::vector<MapFeature> features;
  std::vector<Lane> lanes;
};

TEST(RoadArea, IsEmptyWithoutRoadEdges) {
  EXPECT_TRUE(
      roadArea({{FeatureKind::kCrosswalk, {{0, 0}, {4, 0}, {4, 4}}}}, TestRoad().lanes).empty());
}

TEST(RoadArea, ReachesFromEdgeToEdge) {
  const TestRoad road;
  for (const double y : {-6.0 + kAccuracy, 0.0, 5.0, 6.0 - kAccuracy}) {
    EXPECT_TRUE(road.isRoad(40.0, y)) << y;
  }
  for (const double y : {-6.0 - kAccuracy, 6.0 + kAccuracy, 20.0, 40.0}) {
    EXPECT_FALSE(road.isRoad(40.0, y)) << y;
  }
}

TEST(RoadArea, TheDirectionOfAnEdgeDoesNotMatter) {
  TestRoad road;
  std::reverse(road.features[0].points.begin(), road.features[0].points.end());
  EXPECT_TRUE(road.isRoad(40.0, -5.5));
  EXPECT_FALSE(road.isRoad(40.0, -6.5));
}

TEST(RoadArea, AMedianIsAnIsland) {
  TestRoad road;
  road.addEdge(FeatureKind::kMedian,
               {{20.0, -1.0}, {20.0, 1.0}, {60.0, 1.0}, {60.0, -1.0}, {20.0, -1.0}});
  EXPECT_FALSE(road.isRoad(40.0, 0.0));
  EXPECT_TRUE(road.isRoad(40.0, 1.0 + kAccuracy));
  EXPECT_TRUE(road.isRoad(40.0, -1.0 - kAccuracy));
  EXPECT_TRUE(road.isRoad(18.0, 0.0));
}

TEST(RoadArea, AnEdgeBetweenTwoCarriagewaysHasRoadOnBothSides) {
  TestRoad road;
  road.addEdge(FeatureKind::kMedian, {{0.0, 0.0}, {80.0, 0.0}});
  EXPECT_TRUE(road.isRoad(40.0, 1.0));
  EXPECT_TRUE(road.isRoad(40.0, -1.0));
}

TEST(RoadArea, ContinuesOverTheJointOfTwoEdges) {
  TestRoad road;
  road.features[0].points = {{0.0, -6.0}, {40.0, -6.0}};
  road.addEdge(FeatureKind::kRoadEdge, {{80.0, -6.0}, {40.2, -6.0}});
  EXPECT_TRUE(road.isRoad(40.1, -5.5));
  EXPECT_FALSE(road.isRoad(40.1, -6.5));
}

TEST(RoadArea, HasTheStripsOfLanesBeyondTheEndsOfEdges) {
  TestRoad road;
  road.addLane({{80.0, -3.0}, {120.0, -3.0}});
  EXPECT_TRUE(road.isRoad(100.0, -3.0));
  EXPECT_TRUE(road.isRoad(100.0, -3.0 + 0.5 * kLaneWidth - kAccuracy));
  EXPECT_FALSE(road.isRoad(100.0, -3.0 + 0.5 * kLaneWidth + kAccuracy));
  EXPECT_FALSE(road.isRoad(100.0, -5.5)) << "beyond the end of the edge";
}

TEST(RoadArea, HasDriveways) {
  TestRoad road;
  road.features.push_back({FeatureKind::kDriveway, {{30, 6}, {34, 6}, {34, 12}, {30, 12}}});
  EXPECT_TRUE(road.isRoad(32.0, 10.0));
  EXPECT_FALSE(road.isRoad(36.0, 10.0));
}

TEST(RoadArea, FollowsARoundEdgeToAFewCentimetres) {
  TestRoad road;
  std::vector<Vector2> circle;
  for (int i = 0; i <= 72; ++i) {
    const double angle = -2.0 * M_PI * i / 72.0;
    circle.emplace_back(40.0 + 1.5 * std::cos(angle), 1.5 * std::sin(angle));
  }
  road.addEdge(FeatureKind::kMedian, circle);
  for (double angle = 0.1; angle < 6.0; angle += 0.37) {
    const Vector2 out(std::cos(angle), std::sin(angle));
    EXPECT_FALSE(road.isRoad(40.0 + 1.4 * out.x(), 1.4 * out.y())) << angle;
    EXPECT_TRUE(road.isRoad(40.0 + 1.6 * out.x(), 1.6 * out.y())) << angle;
  }
}

}  // namespace
}  // namespace forge
