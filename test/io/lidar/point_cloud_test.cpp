#include "collision_forge/io/lidar/point_cloud.h"

#include <gtest/gtest.h>

#include <functional>

#include "io/lidar/made_up_cloud.h"

namespace forge {
namespace {

PointCloud cloudOf(bool is_bigendian) {
  MadeUpLidar lidar;
  lidar.is_bigendian = is_bigendian;
  lidar.has_unknown = true;
  return madeUpCloud(lidar, groundRangeOf);
}

TEST(CloudLayout, ReadsBothByteOrders) {
  const PointCloud little = cloudOf(false);
  const PointCloud big = cloudOf(true);
  EXPECT_NE(little.data, big.data);
  ASSERT_EQ(little.pointCount(), big.pointCount());
  for (std::size_t i = 0; i < little.pointCount(); ++i) {
    EXPECT_EQ(CloudLayout(little).position(little.pointAt(i)),
              CloudLayout(big).position(big.pointAt(i)));
    EXPECT_EQ(CloudLayout(big).ring->get(big.pointAt(i)),
              CloudLayout(little).ring->get(little.pointAt(i)));
  }
}

TEST(CloudLayout, IntegerFieldsAreRoundedAndClamped) {
  PointCloud cloud = cloudOf(false);
  const FieldAccess narrow({"i", 0, 2, 1}, false);
  for (const auto& [value, stored] : {std::pair{-3.0, 0.0}, {7.6, 8.0}, {300.0, 255.0}}) {
    narrow.set(cloud.pointAt(0), value);
    EXPECT_EQ(narrow.get(cloud.pointAt(0)), stored);
  }
}

TEST(CloudLayout, TimesAreSecondsAfterTheStamp) {
  const double stamp = 1.6e9;
  for (const auto& [type, value, time] : {std::tuple{std::uint8_t{6}, 5e7, 0.05},
                                          {std::uint8_t{7}, -0.03, -0.03},
                                          {std::uint8_t{8}, stamp + 0.02, 0.02}}) {
    PointCloud cloud = cloudOf(false);
    cloud.fields.push_back({"t", cloud.point_step, type, 1});
    cloud.point_step += 8;
    cloud.width = 1;
    cloud.row_step = cloud.point_step;
    cloud.data.assign(cloud.point_step, 0);
    const CloudLayout layout(cloud);
    layout.time->set(cloud.pointAt(0), value);
    EXPECT_NEAR(layout.timeOf(cloud.pointAt(0), stamp), time, 1e-6);
  }
}

TEST(CloudLayout, RefusesWhatCannotBeReadByName) {
  const std::pair<std::function<void(PointCloud&)>, const char*> cases[] = {
      {[](PointCloud& cloud) { cloud.fields[3].name = "height"; }, "field z is missing"},
      {[](PointCloud& cloud) { cloud.fields[1].datatype = 4; }, "field x: datatype 4"},
      {[](PointCloud& cloud) { cloud.fields[5].datatype = 9; }, "field ring: datatype 9"},
      {[](PointCloud& cloud) { cloud.fields[5].offset = 4000000000U; }, "offset 4000000000"},
      {[](PointCloud& cloud) { cloud.width += 1; }, "data have"},
      {[](PointCloud& cloud) {
         cloud.height = 7;
         cloud.row_step = 3;
       },
       "row_step 3"}};
  for (const auto& [spoil, words] : cases) {
    PointCloud cloud = cloudOf(false);
    spoil(cloud);
    try {
      const CloudLayout layout(cloud);
      ADD_FAILURE() << words;
    } catch (const CloudError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace forge
