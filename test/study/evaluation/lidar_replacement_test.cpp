#include "collision_forge/study/evaluation/lidar_replacement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>

#include "collision_forge/io/lidar/simulated_sweep.h"

namespace forge {
namespace {

TEST(LidarReplacement, ABodyReplacesItself) {
  const Eigen::Isometry3d ground(Eigen::Translation3d(0.0, 0.0, -1.84));
  std::vector<PosedBody> bodies;
  std::vector<VehicleInCloud> vehicles;
  for (const double y : {-15.0, -8.0, 8.0, 15.0}) {
    PosedBody body;
    body.body = lidarBodyOf(AgentClass::kCar, {4.5, 1.9, 1.5});
    body.end = ground * Eigen::Translation3d(5.0, y, 0.0);
    body.begin = body.end;
    bodies.push_back(body);
    vehicles.push_back({"car " + std::to_string(y), AgentClass::kCar, body.end, body.body.size});
  }
  SimulatedLidar lidar;
  lidar.columns = 1080;
  const PointCloud cloud = simulateSweep(bodies, ground, lidar, 1);
  const auto replaced = replaceVehicles(cloud, {0.0, 0.05}, vehicles, {20, 0.02, 5});
  ASSERT_EQ(replaced.size(), 4u);
  for (const ReplacedVehicle& vehicle : replaced) {
    EXPECT_NEAR(static_cast<double>(vehicle.injected), static_cast<double>(vehicle.recorded),
                0.25 * static_cast<double>(vehicle.recorded));
    EXPECT_GT(vehicle.ring_overlap, 0.8);
    EXPECT_LT(vehicle.distance, 2.0 * vehicle.floor);
  }
}

TEST(LidarReplacement, FeaturesDescribeThePoints) {
  VehiclePoints points;
  points.positions = {{2.0, 1.0, 0.5}, {2.0, -1.0, 0.5}, {2.0, 0.0, 1.5}};
  points.ranges = {10.0, 10.0, 13.0};
  points.azimuths = {3.1, 3.1 - 0.2, -2.0 * M_PI + 3.15};  // over the seam at pi
  points.rings = {{7, 2}, {10, 1}};
  points.intensities = {10.0, 20.0, 30.0};
  const Eigen::VectorXd features = featuresOf(points);
  const double expected[] = {std::log(4.0),  2.0,  0.5,
                             11.0 * 0.25,    1.0,  2.5 / 3.0,
                             std::sqrt(2.0), 20.0, std::sqrt(200.0 / 3.0)};
  ASSERT_EQ(features.size(), static_cast<Eigen::Index>(std::size(expected)));
  for (Eigen::Index i = 0; i < features.size(); ++i) {
    EXPECT_NEAR(features[i], expected[i], 1e-9) << kPointFeatures[i];
  }
  EXPECT_TRUE(featuresOf({}).isZero());
}

TEST(LidarReplacement, VehiclesWithFewPointsAreLeftOut) {
  const Eigen::Isometry3d ground(Eigen::Translation3d(0.0, 0.0, -1.84));
  const PointCloud cloud = simulateSweep({}, ground, {}, 1);
  const VehicleInCloud nothing{
      "none", AgentClass::kCar, ground * Eigen::Translation3d(10.0, 0.0, 0.0), {4.5, 1.9, 1.5}};
  EXPECT_TRUE(replaceVehicles(cloud, {0.0, 0.05}, {nothing}, {}).empty());
}

}  // namespace
}  // namespace forge
