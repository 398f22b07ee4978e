#include "collision_forge/io/logs/nuscenes_can_bus.h"

#include <gtest/gtest.h>

#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

TEST(NuScenesCanBus, ReadsInertiaAndPlaces) {
  const TemporaryFolder folder;
  folder.write("can_bus/scene-0001_ms_imu.json",
               R"([{"utime": 1531883549954657, "linear_accel": [0.5, -0.25, 9.75],
                    "q": [2, 0, 0, 0], "rotation_rate": [0.01, 0.02, -0.125]}])");
  folder.write("can_bus/scene-0001_pose.json",
               R"([{"utime": 7, "pos": [411.5, 1181.25, 0], "vel": [1, 0, 0]},
                   {"utime": 9, "pos": [412, 1181, 0], "vel": [1, 0, 0]}])");
  const auto inertia = readInertia(folder.path(), "scene-0001");
  ASSERT_TRUE(inertia);
  ASSERT_EQ(inertia->size(), 1u);
  EXPECT_EQ(inertia->front().timestamp_us, 1531883549954657);
  EXPECT_EQ(inertia->front().acceleration, Eigen::Vector3d(0.5, -0.25, 9.75));
  EXPECT_EQ(inertia->front().orientation.coeffs(), Eigen::Quaterniond::Identity().coeffs());
  EXPECT_EQ(inertia->front().rotation_rate, Eigen::Vector3d(0.01, 0.02, -0.125));
  const auto places = readPlaces(folder.path(), "scene-0001");
  ASSERT_TRUE(places);
  ASSERT_EQ(places->size(), 2u);
  EXPECT_EQ(places->back().timestamp_us, 9);
  EXPECT_EQ(places->back().position, Eigen::Vector3d(412.0, 1181.0, 0.0));
}

TEST(NuScenesCanBus, FilesMayBeMissingButNotMalformed) {
  const TemporaryFolder folder;
  EXPECT_FALSE(readInertia(folder.path(), "scene-0001"));
  EXPECT_FALSE(readPlaces(folder.path(), "scene-0001"));
  folder.write("can_bus/scene-0001_pose.json", R"([{"utime": 7, "pos": [1, 2]}])");
  EXPECT_NE(errorOf([&] {
              readPlaces(folder.path(), "scene-0001");
            }).find("field pos is not an array of 3 numbers"),
            std::string::npos);
  folder.write("can_bus/scene-0001_ms_imu.json",
               R"([{"utime": 7, "linear_accel": [0, 0, 0], "q": [0, 0, 0, 0],
                    "rotation_rate": [0, 0, 0]}])");
  EXPECT_NE(
      errorOf([&] { readInertia(folder.path(), "scene-0001"); }).find("field q is no rotation"),
      std::string::npos);
}

TEST(NuScenesCanBus, PositionsAreNorthAndEastOfTheOriginOfTheMap) {
  const GeoPoint origin = *geoPointOn("boston-seaport", {0.0, 0.0});
  const GeoPoint place = *geoPointOn("boston-seaport", {1500.0, 1000.0});
  // Length of a degree of a meridian, and of a parallel at the latitude of the place.
  const double degree = 6378137.0 * M_PI / 180.0;
  EXPECT_NEAR((place.latitude - origin.latitude) * degree, 1000.0, 0.5);
  EXPECT_NEAR(
      (place.longitude - origin.longitude) * degree * std::cos(origin.latitude * M_PI / 180.0),
      1500.0, 0.5);
  EXPECT_FALSE(geoPointOn("embedded-left", {0.0, 0.0}));
}

}  // namespace
}  // namespace forge
