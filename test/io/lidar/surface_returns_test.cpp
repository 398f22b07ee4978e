#include "collision_forge/io/lidar/surface_returns.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "collision_forge/io/lidar/cloud_injection.h"
#include "io/lidar/made_up_cloud.h"

namespace forge {
namespace {

PosedBody boxAhead(double fit) {
  PosedBody body;
  body.body = lidarBodyOf(AgentClass::kStaticObject, {2.0, 2.0, 2.0});
  body.end = Eigen::Isometry3d(Eigen::Translation3d(10.0, 0.0, -1.0));
  body.begin = body.end;
  body.fit = fit;
  return body;
}

LidarRay rayTo(double y, double z) {
  LidarRay ray;
  ray.direction = Eigen::Vector3d(9.0, y, z).normalized().cast<float>();
  return ray;
}

TEST(PosedBody, TheFitShrinksTheOutlineAroundItsGroundPoint) {
  EXPECT_TRUE(boxAhead(1.0).hitOf(rayTo(0.95, 0.0)));
  EXPECT_FALSE(boxAhead(0.8).hitOf(rayTo(0.95, 0.0)));
  EXPECT_NEAR(boxAhead(0.8).hitOf(rayTo(0.0, 0.0))->distance, 9.2, 1e-6);
  EXPECT_TRUE(boxAhead(0.8).hitOf(rayTo(0.0, 0.75)));
  EXPECT_FALSE(boxAhead(0.8).hitOf(rayTo(0.0, 0.9)));
}

TEST(PosedBody, TheWindowHoldsAllHits) {
  PosedBody body = boxAhead(1.0);
  body.begin = Eigen::Isometry3d(Eigen::Translation3d(9.0, 1.0, -1.0));
  body.begin_time = -0.1;
  for (double y = -3.0; y < 4.0; y += 0.05) {
    for (double z = -2.0; z < 2.0; z += 0.05) {
      LidarRay ray = rayTo(y, z);
      for (const float time : {-0.1F, -0.05F, 0.0F}) {
        ray.time = time;
        EXPECT_TRUE(!body.hitOf(ray) || body.window().contains(ray.direction));
      }
    }
  }
  EXPECT_FALSE(body.window().contains(-Eigen::Vector3f::UnitX()));
}

TEST(SurfaceReturns, TheModelMaterialsFallsWithRangeAndGrazingIncidence) {
  const LidarBody body = boxAhead(1.0).body;
  const SurfaceReturns model;
  const auto share = [&](double distance, double incidence, SurfaceKind surface) {
    return model.shareOf(body, {distance, incidence, surface}, 0.5);
  };
  EXPECT_GT(share(10.0, 1.0, SurfaceKind::kPaint), 0.9);
  EXPECT_LT(share(10.0, 1.0, SurfaceKind::kGlass), 0.5);
  EXPECT_LT(share(60.0, 1.0, SurfaceKind::kPaint), share(10.0, 1.0, SurfaceKind::kPaint));
  EXPECT_LT(share(10.0, 0.02, SurfaceKind::kPaint), 0.3);
  EXPECT_GT(model.intensityOf(body, {10.0, 1.0, SurfaceKind::kLamp}, 0.5, 0.5),
            model.intensityOf(body, {10.0, 1.0, SurfaceKind::kTyre}, 0.5, 1.0));
}

PosedBody bodyAt(AgentClass agent_class, const Eigen::Vector3d& size, double y) {
  PosedBody posed;
  posed.body = lidarBodyOf(agent_class, size);
  posed.end = Eigen::Isometry3d(Eigen::Translation3d(9.0, y, -1.8));
  posed.begin = posed.end;
  return posed;
}

/// Returns the intensity of a return at `y` of the point with this index.
using IntensityAt = std::function<double(double y, std::size_t index)>;

/// Learns from bodies on flat ground.
SurfaceReturns learntFrom(const std::vector<PosedBody>& bodies, const IntensityAt& intensity) {
  MadeUpLidar lidar;
  lidar.columns = 2160;
  PointCloud cloud = madeUpCloud(lidar, groundRangeOf);
  const CloudLayout empty(cloud);
  editCloud(cloud, empty, raysOf(cloud, empty, {0.0, 0.1}), {bodies, {}, nullptr, 0.0, 1}, {});
  const CloudLayout layout(cloud);
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    std::uint8_t* point = cloud.pointAt(i);
    layout.intensity->set(point, intensity(layout.position(point).y(), i));
  }
  SurfaceReturns surfaces;
  surfaces.learn(cloud, layout, raysOf(cloud, layout, {0.0, 0.1}), bodies);
  return surfaces;
}

constexpr double kCarY[] = {-6.0, 0.0, 6.0};

/// Three cars whose intensities have the logarithms `means` + `step` times 0 or 1.
double spreadOfCars(const std::array<double, 3>& means, double step) {
  std::vector<PosedBody> cars;
  for (const double y : kCarY) cars.push_back(bodyAt(AgentClass::kCar, {4.5, 1.9, 1.5}, y));
  const SurfaceReturns surfaces = learntFrom(cars, [&](double y, std::size_t index) {
    const std::size_t car = y < -3.0 ? 0 : y < 3.0 ? 1 : 2;
    return std::expm1(means[car] + step * static_cast<double>(index % 2));
  });
  return surfaces.spreadWithin(cars[0].body);
}

TEST(SurfaceReturns, AClassLearnsFromItsOwnKindFirst) {
  const PosedBody car = bodyAt(AgentClass::kCar, {4.5, 1.9, 1.5}, -5.0);
  const PosedBody truck = bodyAt(AgentClass::kTruck, {6.0, 2.3, 2.8}, 5.0);
  const SurfaceReturns surfaces =
      learntFrom({car, truck}, [](double y, std::size_t) { return y < 0.0 ? 10.0 : 100.0; });
  const BodyHit hit{8.0, 1.0, SurfaceKind::kPaint};
  const auto intensityOf = [&](AgentClass agent_class, const SurfaceReturns& model) {
    return model.intensityOf(lidarBodyOf(agent_class, {3.0, 1.9, 1.6}), hit, 0.5, 0.5);
  };
  EXPECT_EQ(intensityOf(AgentClass::kCar, surfaces), 10.0);
  EXPECT_EQ(intensityOf(AgentClass::kTruck, surfaces), 100.0);
  EXPECT_EQ(intensityOf(AgentClass::kTrailer, surfaces), 100.0) << "another large vehicle";
  EXPECT_EQ(intensityOf(AgentClass::kPedestrian, surfaces),
            intensityOf(AgentClass::kPedestrian, {}))
      << "nobody to learn from";
  const SurfaceReturns cars = learntFrom({car}, [](double, std::size_t) { return 10.0; });
  EXPECT_EQ(intensityOf(AgentClass::kTruck, cars), 10.0) << "cars and large vehicles together";
}

TEST(SurfaceReturns, RidersAndPeopleOnFootLearnFromTheirOwnKind) {
  std::vector<PosedBody> bodies;
  for (const double y : {1.5, 2.5, 3.5, 4.5}) {
    bodies.push_back(bodyAt(AgentClass::kBicycle, {1.8, 0.7, 1.85}, -y));
    bodies.push_back(bodyAt(AgentClass::kPedestrian, {0.7, 0.7, 1.77}, y));
  }
  const SurfaceReturns surfaces =
      learntFrom(bodies, [](double y, std::size_t) { return y < 0.0 ? 10.0 : 100.0; });
  const auto intensityOf = [&](AgentClass agent_class) {
    const LidarBody body = lidarBodyOf(agent_class, {0.9, 0.7, 1.7});
    return surfaces.intensityOf(body, {8.0, 1.0, SurfaceKind::kCloth}, 0.5, 0.5);
  };
  for (const AgentClass rider : {AgentClass::kMotorcycle, AgentClass::kScooter}) {
    EXPECT_EQ(intensityOf(rider), 10.0) << toString(rider);
  }
  for (const AgentClass on_foot : {AgentClass::kChild, AgentClass::kRunner}) {
    EXPECT_EQ(intensityOf(on_foot), 100.0) << toString(on_foot);
  }
}

TEST(SurfaceReturns, TheSpreadOfIntensitiesWithinAVehicleIsLearnt) {
  EXPECT_NEAR(spreadOfCars({2.0, 2.0, 2.0}, 1.0), 1.0, 0.05) << "all vehicles are alike";
  EXPECT_NEAR(spreadOfCars({1.0, 2.0, 3.0}, 0.0), 0.05, 1e-9) << "the least";
  const double mixed = spreadOfCars({1.0, 2.0, 3.0}, 1.0);
  EXPECT_GT(mixed, 0.15);
  EXPECT_LT(mixed, 0.6);
  EXPECT_EQ(SurfaceReturns().spreadWithin(lidarBodyOf(AgentClass::kCar, {4.5, 1.9, 1.5})), 0.35);
}

}  // namespace
}  // namespace forge
