#include "collision_forge/attack/search/added_drives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "attack/search/added_scene.h"

namespace forge {
namespace {

constexpr double kContact = 4.0;  // s from now
constexpr double kEgoThen = AddedScene::kEgoX + kContact * AddedScene::kEgoSpeed;
constexpr double kTouching = 0.5 * (kEgoSize.length + kCarSize.length);

class AddedDrivesTest : public testing::Test {
 protected:
  void SetUp() override { make(); }

  /// Again, for a scene that has changed.
  void make() {
    input_ = std::make_unique<AddedVehicleInput>(scene_.input());
    ways_ = std::make_unique<AddedPaths>(*input_, options_.added);
    drives_ = std::make_unique<AddedDrives>(*input_, options_);
  }

  /// With the ego in its lane, from a lane.
  AddedMeeting meetingAt(Side side, std::size_t lane = 0) const {
    AddedMeeting meeting;
    meeting.way = ways_->to({lane, 200.0, {}}).front().get();
    meeting.ego = {{kEgoThen, 0.0, 0.0}, kEgoSize};
    meeting.contact = kContact;
    meeting.side = side;
    meeting.across = meeting.frenetOf(kCarSize).across;
    return meeting;
  }

  bool plan(const AddedMeeting& meeting, const ApproachManner& manner) {
    return drives_->plan(meeting, manner, kCarSize, drive_);
  }

  /// Kinds of the manners that are tried for a meeting.
  std::vector<ApproachManner::Kind> kindsOf(const AddedMeeting& meeting) const {
    std::vector<ApproachManner::Kind> kinds;
    for (const ApproachManner& manner : drives_->mannersFor(meeting)) kinds.push_back(manner.kind);
    return kinds;
  }

  static bool has(const std::vector<ApproachManner::Kind>& kinds, ApproachManner::Kind kind) {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  }

  AddedScene scene_;
  AttackOptions options_ = shippedOptions();
  std::unique_ptr<AddedVehicleInput> input_;
  std::unique_ptr<AddedPaths> ways_;
  std::unique_ptr<AddedDrives> drives_;
  AddedDrive drive_;
};

TEST_F(AddedDrivesTest, ACruiseReachesTheMeetingAtTheContact) {
  const AddedMeeting meeting = meetingAt(Side::kRear);
  ASSERT_TRUE(plan(meeting, {ApproachManner::kCruise, 11.0}));
  const Pose2 then = drive_.poseAt(meeting.way->path, 40);
  EXPECT_NEAR(then.x, kEgoThen - kTouching, 1e-6);
  EXPECT_NEAR(then.y, 0.0, 1e-6);
  ASSERT_EQ(drive_.on.size(), 40u);
  ASSERT_EQ(drive_.back.size(), 121u) << "at the first frame, too";
  for (int step = -119; step <= 40; ++step) {
    EXPECT_NEAR(drive_.at(step) - drive_.at(step - 1), 1.1, 1e-6) << step;
  }
}

TEST_F(AddedDrivesTest, InterpolatesPlacesForAnyContactTime) {
  AddedMeeting meeting = meetingAt(Side::kRear);
  meeting.contact = 1.33;
  ASSERT_TRUE(plan(meeting, {ApproachManner::kCruise, 10.0}));
  const double now = drive_.back.front();
  for (int i = 1; i <= 13; ++i) {
    EXPECT_NEAR(drive_.at(i), now + 10.0 * AddedDrive::kStep * i, 1e-6) << i;
  }
  EXPECT_NEAR(drive_.step() * static_cast<double>(drive_.on.size()), 1.33, 1e-9);
}

TEST_F(AddedDrivesTest, ATrainKeepsTheEgosDistanceUntilNow) {
  const AddedMeeting meeting = meetingAt(Side::kRear);
  ASSERT_TRUE(plan(meeting, {ApproachManner::kTrain, 1.2}));
  const std::vector<double>& ego = meeting.way->ego;
  const double gap = -kTouching - 0.5 * 1.2 * kContact * kContact;
  ASSERT_EQ(drive_.back.size(), ego.size());
  for (std::size_t i = 0; i < ego.size(); ++i) EXPECT_NEAR(drive_.back[i] - ego[i], gap, 1e-6);
  EXPECT_NEAR(drive_.on.back(), meeting.frenetOf(kCarSize).along, 1e-6);
}

TEST_F(AddedDrivesTest, AFollowerRepeatsAFlowEarlierOrLater) {
  // It is there 1.7 s after the contact.
  scene_.add("behind", {kEgoThen - kTouching - 57.0, 0.0, 0.0}, 10.0);
  make();
  const AddedMeeting meeting = meetingAt(Side::kRear);
  ASSERT_EQ(meeting.way->flows.size(), 1u);
  ASSERT_TRUE(plan(meeting, {ApproachManner::kFollow, 0.0}));
  EXPECT_NEAR(drive_.on.back(), meeting.frenetOf(kCarSize).along, 1e-6);
  EXPECT_NEAR(drive_.at(0) - meeting.way->flows.front().at(0.0), 17.0, 1e-6) << "1.7 s ahead of it";
  scene_ = {};
  scene_.add("at the same time", {kEgoThen - kTouching - 45.0, 0.0, 0.0}, 10.0);
  make();
  EXPECT_FALSE(plan(meetingAt(Side::kRear), {ApproachManner::kFollow, 0.0}));
}

TEST_F(AddedDrivesTest, AStartingVehicleStandsNow) {
  const AddedMeeting meeting = meetingAt(Side::kRear);
  ASSERT_TRUE(plan(meeting, {ApproachManner::kStart, 1.2, false}));
  EXPECT_NEAR(drive_.on.back(), meeting.frenetOf(kCarSize).along, 1e-6);
  ASSERT_EQ(drive_.back.size(), 121u);
  EXPECT_EQ(drive_.back.front(), drive_.back.back()) << "stood all along";
  EXPECT_GT(drive_.at(1), drive_.at(0));
  ASSERT_TRUE(plan(meeting, {ApproachManner::kStart, 1.2, true}));
  const int waited = static_cast<int>(std::lround(AddedDrive::kWait / AddedDrive::kStep));
  EXPECT_EQ(drive_.at(-waited), drive_.at(0));
  EXPECT_LT(drive_.at(-waited - 1), drive_.at(0)) << "came there";
}

TEST_F(AddedDrivesTest, AVehicleDepartsAtTheRequestedTime) {
  const AddedMeeting meeting = meetingAt(Side::kRear);
  ASSERT_TRUE(plan(meeting, {ApproachManner::kStart, 1.2, false, 0.0, false, 2.0}));
  EXPECT_EQ(drive_.at(20), drive_.at(-120));
  EXPECT_GT(drive_.at(21), drive_.at(20));
  EXPECT_NEAR(drive_.on.back(), meeting.frenetOf(kCarSize).along, 1e-6);
}

TEST_F(AddedDrivesTest, AStandingVehicleStandsAtTheMeeting) {
  const AddedMeeting meeting = meetingAt(Side::kFront);
  ASSERT_TRUE(plan(meeting, {ApproachManner::kStand}));
  for (const int step : {-120, -1, 0, 1, 40}) {
    EXPECT_NEAR(drive_.poseAt(meeting.way->path, step).x, kEgoThen + kTouching, 1e-6) << step;
  }
}

TEST_F(AddedDrivesTest, AParkedCarStandsBeforeTheMeetingAndFartherOut) {
  const AddedMeeting meeting = meetingAt(Side::kRight);
  const double beside = -0.5 * (kEgoSize.width + kCarSize.width);
  ASSERT_NEAR(meeting.across, beside, 1e-6);
  ASSERT_TRUE(plan(meeting, {ApproachManner::kPark, 3.0}));
  ASSERT_EQ(drive_.back.size(), 121u);
  for (const int step : {-120, 0, 40}) {
    const Pose2 place = drive_.poseAt(meeting.way->path, step);
    EXPECT_NEAR(place.x, kEgoThen - 3.0, 1e-6) << step;
    EXPECT_LT(place.y, beside - 0.1) << step;
    EXPECT_GT(place.y, beside - 1.0) << step;
  }
  EXPECT_FALSE(plan(meeting, {ApproachManner::kPark, 30.0})) << "too far off the lane";
}

TEST_F(AddedDrivesTest, RearEndsStandOnlyAheadOfTheEgo) {
  const AddedMeeting ahead = meetingAt(Side::kFront);
  EXPECT_FALSE(has(kindsOf(meetingAt(Side::kRear)), ApproachManner::kStand));
  EXPECT_EQ(kindsOf(ahead).front(), ApproachManner::kTrain);
  EXPECT_EQ(kindsOf(ahead).back(), ApproachManner::kStand);
  scene_.request.manoeuvre = Manoeuvre::kLeadStopped;
  EXPECT_EQ(kindsOf(ahead).front(), ApproachManner::kStand);
  scene_.request.manoeuvre.reset();
  scene_.future.ego_samples = {scene_.future.ego};
  EXPECT_EQ(kindsOf(ahead).front(), ApproachManner::kStand) << "where the future is predicted";
}

TEST_F(AddedDrivesTest, LaneChangesParkOnRequestOrWhereTheEgoHasTheLane) {
  scene_.request.type = CollisionType::kLaneChange;
  const AddedMeeting own = meetingAt(Side::kRight);
  const AddedMeeting beside = meetingAt(Side::kLeft, 1);
  ASSERT_TRUE(own.isEgosPath());
  ASSERT_FALSE(beside.isEgosPath());
  EXPECT_EQ(kindsOf(own).front(), ApproachManner::kPark);
  EXPECT_EQ(kindsOf(beside).back(), ApproachManner::kPark);
  scene_.request.manoeuvre = Manoeuvre::kPullOut;
  EXPECT_EQ(kindsOf(own), std::vector<ApproachManner::Kind>(2, ApproachManner::kPark));
  scene_.request.manoeuvre = Manoeuvre::kCutIn;
  EXPECT_FALSE(has(kindsOf(own), ApproachManner::kPark));
}

TEST_F(AddedDrivesTest, ACruiseWithSpeedVariationStillReachesTheMeeting) {
  const AddedMeeting meeting = meetingAt(Side::kRear);
  ASSERT_TRUE(plan(meeting, {ApproachManner::kCruise, 8.0}));
  const AddedDrive even = drive_;
  const SpeedVariation variation{0.6, 5.0, 1.0};
  ASSERT_TRUE(drives_->plan(meeting, {ApproachManner::kCruise, 8.0}, kCarSize, drive_, variation));
  EXPECT_NEAR(drive_.on.back(), even.on.back(), 1e-9);
  ASSERT_EQ(drive_.back.size(), even.back.size());
  const auto speedAgo = [](const AddedDrive& drive, std::size_t i) {
    return (drive.back[i] - drive.back[i + 1]) / AddedDrive::kStep;
  };
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < even.back.size(); ++i) {
    most = std::max(most, std::abs(speedAgo(drive_, i) - speedAgo(even, i)));
  }
  EXPECT_GT(most, 0.3);
  EXPECT_LT(most, 2.0 * variation.amplitude / variation.frequency());
}

}  // namespace
}  // namespace forge
