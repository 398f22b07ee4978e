#include "collision_forge/io/lidar/lidar_body.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

using Eigen::Vector3d;

const std::pair<AgentClass, Vector3d> kBodies[] = {
    {AgentClass::kCar, {4.6, 1.9, 1.5}},         {AgentClass::kCar, {3.9, 1.7, 1.5}},
    {AgentClass::kCar, {4.7, 2.0, 1.75}},        {AgentClass::kCar, {5.3, 2.0, 2.2}},
    {AgentClass::kTruck, {7.0, 2.6, 3.2}},       {AgentClass::kTruck, {14.0, 2.6, 3.8}},
    {AgentClass::kBus, {11.5, 2.9, 3.4}},        {AgentClass::kTrailer, {10.0, 2.6, 3.8}},
    {AgentClass::kMotorcycle, {2.1, 0.8, 1.5}},  {AgentClass::kBicycle, {1.8, 0.6, 1.7}},
    {AgentClass::kPedestrian, {0.7, 0.7, 1.75}}, {AgentClass::kStaticObject, {0.5, 2.0, 1.1}},
    {AgentClass::kChild, {0.5, 0.45, 1.15}},     {AgentClass::kRunner, {0.8, 0.6, 1.8}},
    {AgentClass::kScooter, {1.28, 0.7, 1.87}}};

/// The highest value of a point of any piece along an axis, by rays against it from far outside.
double reachAlong(const LidarBody& body, const Vector3d& direction) {
  double reach = -INFINITY;
  const Vector3d u = direction.unitOrthogonal();
  const Vector3d v = direction.cross(u);
  for (double a = -8.0; a <= 8.0; a += 0.04) {
    for (double b = -8.0; b <= 8.0; b += 0.04) {
      const Vector3d origin = 20.0 * direction + a * u + b * v;
      if (const auto hit = firstHit(body, origin, -direction)) {
        reach = std::max(reach, 20.0 - hit->distance);
      }
    }
  }
  return reach;
}

TEST(LidarBody, FillsItsBox) {
  for (const auto& [agent_class, size] : kBodies) {
    const LidarBody body = lidarBodyOf(agent_class, size);
    EXPECT_LE(body.pieces.size(), 16u) << toString(agent_class);
    EXPECT_NEAR(reachAlong(body, Vector3d::UnitZ()), size.z(), 0.02) << toString(agent_class);
    const bool is_on_foot = isOnFoot(agent_class);
    EXPECT_NEAR(reachAlong(body, Vector3d::UnitX()), size.x() / 2.0, is_on_foot ? 0.3 : 0.06)
        << toString(agent_class);
    EXPECT_LT(reachAlong(body, Vector3d::UnitY()), size.y() / 2.0 + 0.02) << toString(agent_class);
  }
}

TEST(LidarBody, StandsOnTheGround) {
  for (const auto& [agent_class, size] : kBodies) {
    EXPECT_NEAR(reachAlong(lidarBodyOf(agent_class, size), -Vector3d::UnitZ()), 0.0, 0.02)
        << toString(agent_class);
  }
}

TEST(LidarBody, CarsHaveABonnetAndAWindscreen) {
  const LidarBody car = lidarBodyOf(AgentClass::kCar, {4.6, 1.9, 1.5});
  const auto ahead = [&](double z) { return firstHit(car, {10.0, 0.3, z}, -Vector3d::UnitX()); };
  EXPECT_NEAR(ahead(0.5)->distance, 10.0 - 2.3, 0.1);
  EXPECT_EQ(ahead(1.1)->surface, SurfaceKind::kGlass);
  EXPECT_GT(ahead(1.1)->distance, ahead(0.5)->distance + 1.0);
  EXPECT_EQ(ahead(1.49)->surface, SurfaceKind::kPaint);
  EXPECT_FALSE(ahead(1.6));
  const auto beside = firstHit(car, {2.3 - 0.19 * 4.6, 5.0, 0.1}, -Vector3d::UnitY());
  EXPECT_EQ(beside->surface, SurfaceKind::kTyre);
}

TEST(LidarBody, IncidenceIsTheCosineAtTheSurface) {
  const LidarBody box = lidarBodyOf(AgentClass::kStaticObject, {2.0, 2.0, 2.0});
  const Vector3d slanted = Vector3d(-1.0, 0.5, 0.0).normalized();
  const auto hit = firstHit(box, {5.0, -1.5, 1.0}, slanted);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->incidence, std::cos(std::atan(0.5)), 1e-12);
  EXPECT_NEAR(hit->distance, 4.0 / std::cos(std::atan(0.5)), 1e-12);
}

TEST(LidarBody, RaysFromInsideMiss) {
  EXPECT_FALSE(firstHit(lidarBodyOf(AgentClass::kStaticObject, {2.0, 2.0, 2.0}), {0.0, 0.0, 1.0},
                        Vector3d::UnitX()));
}

TEST(LidarBody, TheRiderOfAScooterStandsOnItsBoard) {
  const LidarBody scooter = lidarBodyOf(AgentClass::kScooter, {1.28, 0.7, 1.87});
  const auto behind = [&](double z) {
    return firstHit(scooter, {-5.0, 0.0, z}, Vector3d::UnitX());
  };
  ASSERT_TRUE(behind(1.75));
  EXPECT_EQ(behind(1.75)->surface, SurfaceKind::kCloth) << "the head";
  EXPECT_NEAR(behind(1.75)->distance, 5.0, 0.2) << "in the middle of the board";
  ASSERT_TRUE(behind(0.12));
  EXPECT_NE(behind(0.12)->surface, SurfaceKind::kCloth) << "the board";
}

TEST(LidarBody, PedestriansSwingTheirLegs) {
  const auto reach = [](double walked) {
    return reachAlong(lidarBodyOf(AgentClass::kPedestrian, {0.8, 0.6, 1.8}, walked),
                      Vector3d::UnitX());
  };
  EXPECT_GT(reach(0.35), reach(0.0) + 0.05);
}

}  // namespace
}  // namespace forge
