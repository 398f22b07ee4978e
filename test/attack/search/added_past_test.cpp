#include "collision_forge/attack/search/added_past.h"

#include <gtest/gtest.h>

#include "attack/search/added_scene.h"

namespace forge {
namespace {

constexpr double kContact = 4.0;    // s from now
constexpr double kMeeting = 300.0;  // m along the eastbound lane, 100 m ahead of the origin

class AddedPastTest : public testing::Test {
 protected:
  /// The ways shall be long enough.
  AddedPastTest() { options_.added.speeds.push_back(17.0); }

  /// Result for a vehicle that drives east at constant speed, at a place along the lane at t0.
  /// Null: possible.
  const char* drive(double now, double speed, double aside = 0.0) {
    const AddedVehicleInput input = scene_.input();
    AddedPaths ways(input, options_.added);
    const AddedPath& way = *ways.to({0, kMeeting, {}}).front();
    AddedDrive drive;
    drive.aside = aside;
    const double begin = way.path.project({-200.0, 0.0});
    for (std::size_t i = 0; i <= stepsBack(scene_.past); ++i) {
      drive.back.push_back(begin + now - speed * AddedDrive::kStep * static_cast<double>(i));
      if (drive.back.back() < 0.0) break;
    }
    drive.contact = kContact;
    for (int i = 1; i <= 40; ++i) drive.on.push_back(begin + now + speed * AddedDrive::kStep * i);
    track_ = {"added", AgentClass::kCar, kCarSize, {}};
    return AddedPast(input, options_).drive(drive, way.path, track_);
  }

  AddedScene scene_;
  AttackOptions options_ = shippedOptions();
  Track track_;
};

TEST_F(AddedPastTest, DrivesAsPlannedAtAllFrames) {
  EXPECT_STREQ(drive(200.0, 8.0), nullptr);
  const std::vector<AgentState>& frames = scene_.past.ego.states;
  ASSERT_EQ(track_.states.size(), frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const AgentState& state = track_.states[i];
    EXPECT_EQ(state.time, frames[i].time);
    EXPECT_NEAR(state.pose.y, 0.0, 0.05);
    EXPECT_NEAR(state.pose.x, 8.0 * (state.time - kNow), 0.1);
    EXPECT_NEAR(state.velocity.x(), 8.0, 0.1);
  }
}

TEST_F(AddedPastTest, RequiresNoContactBeforeT0) {
  EXPECT_STREQ(drive(160.0, 8.0), "would have touched an agent before t0") << "is where the ego is";
  scene_.others = {AddedScene::longPast("stands", kCarSize, {-20.0, 0.0, 0.0}, 0.0)};
  EXPECT_STREQ(drive(200.0, 8.0), "would have touched an agent before t0");
}

TEST_F(AddedPastTest, RequiresNoContactBeforeTheRequestedOne) {
  scene_.add("stands", {20.0, 0.0, 0.0}, 0.0);
  EXPECT_STREQ(drive(200.0, 8.0), "would touch another agent first");
}

TEST_F(AddedPastTest, AppearsOutsideTheEgosView) {
  // Its lane begins 160 m behind the ego, and 20 m behind it.
  EXPECT_STREQ(drive(80.0, 14.0), nullptr);
  EXPECT_LT(track_.states.size(), scene_.past.ego.states.size());
  const AgentState& first = track_.states.front();
  EXPECT_GE(kNow - first.time, options_.added.least_past - 1e-6);
  EXPECT_GT((stateAt(scene_.past.ego, first.time)->pose.position() - first.pose.position()).norm(),
            options_.added.sensing_range);
  scene_.map->lanes[0] = straightLane("east", {-170.0, 0.0}, {200.0, 0.0});
  EXPECT_STREQ(drive(140.0, 16.0), "would appear in the ego's view");
}

TEST_F(AddedPastTest, IsNotParkedAgainstTheTraffic) {
  EXPECT_STREQ(drive(200.0, 0.0, 3.0), "would be parked against traffic");
  EXPECT_STREQ(drive(200.0, 0.0, 1.2), "would be parked against traffic") << "between the lanes";
}

TEST_F(AddedPastTest, IsNotParkedInAJunction) {
  scene_.map->drivable_area.push_back(rectangle(-200.0, -5.25, 200.0, -1.0));
  EXPECT_STREQ(drive(200.0, 0.0, -3.0), nullptr);
  EXPECT_NEAR(track_.states.front().pose.x, track_.states.back().pose.x, 1e-6);
  scene_.map->lanes[0].is_intersection = true;
  EXPECT_STREQ(drive(200.0, 0.0, -3.0), "would be parked in a junction");
}

}  // namespace
}  // namespace forge
