#include "collision_forge/ros/bags/foreign_logs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rosbag/view.h>

#include "base/scene/shipped_limits.h"
#include "collision_forge/io/maps/map_error.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/bag_writer.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kMaps = COLLISION_FORGE_SOURCE_DIR "/data/embedded/maps/expansion/";

class ForeignLogsTest : public testing::Test {
 protected:
  void SetUp() override {
    how_.mapping =
        readTopicMapping(COLLISION_FORGE_SOURCE_DIR "/config/topics_derived_object.yaml");
    how_.mapping.agents.fields.topic = "/agent_objects";
    reading_.options.ego_vehicle = {{4.0, 2.0}, 1.5};
    reading_.options.conversion.centerline_resolution = 1.0;
    reading_.options.locations["embedded"] = DrivingSide::kRight;
    reading_.options.input_limits = shippedLimits();
    writeScene("one");
    writeScene("two");
  }

  /// A bag of ours, which has objects and lanes. The car's frame is 0.1 s after the only pose.
  void writeScene(const std::string& name) const {
    NuScenesRecording recording;
    recording.name = name;
    recording.ego_poses.push_back({1000000, {1.0, 2.0, 3.0}, Eigen::Quaterniond::Identity()});
    NuScenesAnnotation car;
    car.instance = "5";
    car.category = "vehicle.car";
    car.size = {4.0, 2.0, 1.5};
    recording.frames.push_back({"", 1100000, {car}});
    LaneMap map;
    map.location = "somewhere";
    writeBag(folder_.path() + "/" + name + ".bag", recording, map);
  }

  std::unique_ptr<SceneReader> open() const {
    return openForeignBags(folder_.path(), how_, reading_);
  }

  const TemporaryFolder folder_;
  ForeignBags how_;
  SceneReading reading_;
};

TEST_F(ForeignLogsTest, EveryBagIsASceneWithItsOwnLanes) {
  const auto logs = open();
  EXPECT_THAT(logs->names(), ElementsAre("one", "two"));
  const LoggedScene logged = logs->recording("two");
  EXPECT_EQ(logged.recording.name, "two");
  EXPECT_EQ(logged.recording.location, "somewhere");
  EXPECT_EQ(logged.recording.ego_poses.at(0).timestamp_us, 1000000);
  EXPECT_EQ(logged.recording.frames.at(0).annotations.at(0).instance, "5");
  EXPECT_EQ(logged.lanes->map().location, "somewhere");
}

TEST_F(ForeignLogsTest, OnlySelectedScenesAreRead) {
  reading_.scenes = {"two"};
  EXPECT_THAT(open()->names(), ElementsAre("two"));
  reading_.scenes = {"three"};
  EXPECT_THROW(open(), std::runtime_error);
}

TEST_F(ForeignLogsTest, AGivenMapReplacesTheMapOfTheBag) {
  how_.map = kMaps + "embedded-right.json";
  const auto logs = open();
  const LoggedScene logged = logs->recording("one");
  EXPECT_EQ(logged.recording.location, "embedded-right");
  EXPECT_GT(logged.lanes->map().lanes.size(), 10U);
  EXPECT_EQ(logs->recording("two").lanes, logged.lanes) << "it is read once";
  how_.map = kMaps + "nowhere.json";
  EXPECT_THROW(open()->recording("one"), MapError);
}

TEST_F(ForeignLogsTest, WithoutLanesTheMapIsEmpty) {
  how_.without_lanes = true;
  EXPECT_TRUE(open()->recording("one").lanes->map().lanes.empty());
}

TEST_F(ForeignLogsTest, ABagWithoutLanesNeedsAMap) {
  const auto path = folder_.path() + "/two.bag";
  {
    const rosbag::Bag bag(path, rosbag::bagmode::Read);
    NewBag copy(folder_.path() + "/three.bag");
    rosbag::View view(bag);
    for (const rosbag::MessageInstance& instance : view) {
      if (instance.getTopic() != "/lane_map") {
        copy.write(instance.getTopic(), instance.getTime(), instance,
                   instance.getConnectionHeader());
      }
    }
    copy.commit();
  }
  try {
    open()->recording("three");
    FAIL();
  } catch (const BagError& error) {
    EXPECT_THAT(error.what(), HasSubstr("three.bag: no message on /lane_map; --map gives the map"));
  }
  how_.map = kMaps + "embedded-right.json";
  EXPECT_EQ(open()->recording("three").recording.frames.size(), 1U);
}

}  // namespace
}  // namespace forge
