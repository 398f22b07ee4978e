#include "collision_forge/attack/search/parked_vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "attack/search/added_scene.h"
#include "collision_forge/attack/search/catalogue.h"
#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/scene/support_vehicles.h"

namespace forge {
namespace {

/// The two lanes of AddedScene, a strip of 2.5 m for parking and a walkway on either side.
AddedScene street() {
  AddedScene scene;
  scene.map->drivable_area = {rectangle(-200.0, -4.5, 200.0, 8.0)};
  scene.map->walkways = {rectangle(-200.0, -7.0, 200.0, -4.5), rectangle(-200.0, 8.0, 200.0, 10.5)};
  scene.request = believableRequestFor(CollisionType::kJunctionCrossing);
  scene.request.attacker_class = AgentClass::kChild;
  scene.request.ego_side = Side::kFront;
  scene.request.from_side = Side::kRight;
  scene.request.hidden_by = Hider::kParkedVehicle;
  scene.request.mode = Mode::kReplay;
  return scene;
}

Attack answerIn(AddedScene& scene) {
  const AddedVehicleInput input = scene.input();
  const Moment moment{*input.past, input.future, std::make_shared<LaneIndex>(scene.map),
                      std::make_shared<Snapshot>(*input.past)};
  const AttackOptions options = shippedOptions();
  return generateCollision(searchMethod(options), moment, scene.request, options.prediction);
}

TEST(ParkedVehicle, HidesAChildUntilItStepsOut) {
  AddedScene scene = street();
  const Attack attack = answerIn(scene);
  ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
  ASSERT_FALSE(attack.supports.empty());
  const ContactConditions& measured = attack.report.conditions;
  EXPECT_EQ(measured.hidden_by, Hider::kParkedVehicle);
  EXPECT_EQ(measured.hidden_by_id.substr(0, 7), "parked-");
  EXPECT_GE(measured.visible_for, usualSight(Hider::kParkedVehicle).min);
  EXPECT_LE(measured.visible_for, usualSight(Hider::kParkedVehicle).max);
}

TEST(ParkedVehicle, IsAVanIfItHidesAnAdult) {
  AddedScene scene = street();
  scene.request.attacker_class = AgentClass::kPedestrian;
  const Attack attack = answerIn(scene);
  ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
  ASSERT_FALSE(attack.supports.empty());
  EXPECT_EQ(attack.supports.front().motion.agent_class, AgentClass::kTruck);
  EXPECT_EQ(attack.report.conditions.hidden_by, Hider::kParkedVehicle);
}

TEST(ParkedVehicle, StandsParallelToTheLaneOnTheRoadAndTouchesNobody) {
  AddedScene scene = street();
  const Attack attack = answerIn(scene);
  ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
  const AddedVehicleInput input = scene.input();
  for (const SupportVehicle& support : attack.supports) {
    const AttackerTrajectory& parked = support.motion;
    const Pose2& pose = parked.points.front().pose;
    EXPECT_NEAR(pose.yaw, 0.0, 1e-6) << "as the lane of its side";
    EXPECT_LT(pose.y + 0.5 * parked.size.width, -1.3) << "beside the ego";
    EXPECT_GT(pose.y - 0.5 * parked.size.width, -4.5) << "on the road";
    EXPECT_EQ(parked.past.size(), input.past->ego.states.size());
    for (const TrajectoryPoint& point : parked.points) EXPECT_EQ(point.speed, 0.0);
    Track track = trackOf(support, nullptr, kNow + 10.0);
    EXPECT_FALSE(firstContactTime(attack.trajectory, track, kNow + 10.0, 0.0));
  }
}

TEST(ParkedVehicle, ComesIntoViewAsLateAsRequested) {
  for (const Range& range : {Range{0.5, 0.9}, Range{0.9, 1.4}}) {
    AddedScene scene = street();
    scene.request.visible_for = range;
    const Attack attack = answerIn(scene);
    if (attack.status.code != StatusCode::kOk) continue;
    EXPECT_GE(attack.report.conditions.visible_for, range.min);
    EXPECT_LE(attack.report.conditions.visible_for, range.max);
  }
}

TEST(ParkedVehicle, NeedsRoomAtTheKerb) {
  AddedScene scene = street();
  scene.map->drivable_area = {rectangle(-200.0, -2.0, 200.0, 5.5)};
  scene.map->walkways = {rectangle(-200.0, -4.0, 200.0, -2.0), rectangle(-200.0, 5.5, 200.0, 7.5)};
  const Attack attack = answerIn(scene);
  EXPECT_EQ(attack.status.code, StatusCode::kRoadDoesNotAllow);
  EXPECT_NE(attack.status.message.find("no parked_vehicle can be added"), std::string::npos)
      << attack.status.message;
}

TEST(ParkedVehicle, IsNotAddedWhereARecordedOneHides) {
  AddedScene scene = street();
  const Attack first = answerIn(scene);
  ASSERT_EQ(first.status.code, StatusCode::kOk) << first.status.message;
  for (const SupportVehicle& support : first.supports) {
    Track recorded = trackOf(support, nullptr, kNow + 10.0);
    Track past = recorded;
    past.states = support.motion.past;
    scene.others.push_back(past);
    scene.future.agents.push_back(recorded);
  }
  const Attack second = answerIn(scene);
  ASSERT_EQ(second.status.code, StatusCode::kOk) << second.status.message;
  EXPECT_TRUE(second.supports.empty());
}

/// The street with two lanes of the ego's direction and a request for a standing vehicle.
AddedScene twoLanesAhead() {
  AddedScene scene = street();
  scene.map->lanes.push_back(straightLane("east_left", {-200.0, 3.5}, {200.0, 3.5}));
  scene.map->lanes.erase(std::find_if(scene.map->lanes.begin(), scene.map->lanes.end(),
                                      [](const Lane& lane) { return lane.id == "west"; }));
  scene.request = believableRequestFor(CollisionType::kRearEnd);
  scene.request.mode = Mode::kReplay;
  scene.request.ego_side = Side::kFront;
  return scene;
}

TEST(CutOutLeader, LeavesTheLaneBeforeAStandingVehicle) {
  AddedScene scene = twoLanesAhead();
  scene.request.hidden_by = Hider::kLeader;
  const Attack attack = answerIn(scene);
  ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
  ASSERT_EQ(attack.supports.size(), 1U);
  EXPECT_EQ(attack.report.manoeuvre, Manoeuvre::kLeadStopped);
  EXPECT_EQ(attack.report.conditions.hidden_by, Hider::kLeader);
  const AttackerTrajectory& leader = attack.supports.front().motion;
  EXPECT_NEAR(leader.points.front().pose.y, 0.0, 0.3) << "in the ego's lane at t0";
  EXPECT_NEAR(leader.points.back().pose.y, 3.5, 0.5) << "in the other lane at the end";
  EXPECT_NEAR(leader.points.back().pose.yaw, 0.0, 0.1);
}

TEST(Queue, StandsAheadOfTheStandingAttacker) {
  for (const std::optional<Hider> hidden_by :
       {std::optional<Hider>(), std::optional(Hider::kLeader)}) {
    AddedScene scene = twoLanesAhead();
    scene.request.hidden_by = hidden_by;
    scene.request.queue = true;
    const Attack attack = answerIn(scene);
    ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
    EXPECT_EQ(attack.report.manoeuvre, Manoeuvre::kLeadStopped);
    ASSERT_EQ(attack.supports.size(), hidden_by ? 2U : 1U);
    const SupportVehicle& second = attack.supports.back();
    EXPECT_EQ(second.role, SupportRole::kQueue);
    const Pose2 there =
        relativeTo(attack.report.attacker_at_contact, second.motion.points.front().pose);
    const double gap = there.x - 0.5 * (attack.trajectory.size.length + second.motion.size.length);
    EXPECT_GT(gap, 1.0);
    EXPECT_LT(gap, 6.5);
    EXPECT_NEAR(there.y, 0.0, 0.1);
    for (const TrajectoryPoint& point : second.motion.points) EXPECT_EQ(point.speed, 0.0);
    EXPECT_EQ(attack.report.first_other_id, "");
  }
}

TEST(Queue, IsNotAddedBeforeARecordedOne) {
  AddedScene scene = twoLanesAhead();
  scene.request.queue = true;
  const Attack first = answerIn(scene);
  ASSERT_EQ(first.status.code, StatusCode::kOk) << first.status.message;
  scene.add("standing", first.supports.back().motion.points.front().pose, 0.0);
  scene.request.choice = AttackerChoice::kNew;
  const Attack second = answerIn(scene);
  ASSERT_EQ(second.status.code, StatusCode::kOk) << second.status.message;
  EXPECT_TRUE(second.supports.empty());
  EXPECT_TRUE(isInstance(scene.request, scene.request, second, second.report.conditions));
  CollisionRequest without_queue = scene.request;
  without_queue.queue = false;
  EXPECT_FALSE(isInstance(scene.request, without_queue, second, second.report.conditions));
}

TEST(Queue, DoesNotExcuseAnAttackerThatComesIntoViewTooEarly) {
  for (const bool is_recorded : {false, true}) {
    AddedScene scene = twoLanesAhead();
    scene.request.queue = true;
    const Attack first = answerIn(scene);
    ASSERT_EQ(first.status.code, StatusCode::kOk) << first.status.message;
    ASSERT_GT(first.report.conditions.visible_for, 1.0) << "nothing hides it";
    if (is_recorded) {
      scene.add("standing", first.supports.back().motion.points.front().pose, 0.0);
      scene.request.choice = AttackerChoice::kNew;
    }
    scene.request.visible_for = Range{0.1, 0.5};
    const Status status = answerIn(scene).status;
    scene.request.queue = false;
    scene.request.manoeuvre = Manoeuvre::kLeadStopped;
    const Status expected = answerIn(scene).status;
    EXPECT_NE(expected.code, StatusCode::kOk);
    EXPECT_EQ(status.code, expected.code) << is_recorded;
    EXPECT_EQ(status.message, expected.message) << is_recorded;
  }
}

TEST(Queue, NeedsRoadAheadOfTheAttacker) {
  AddedScene scene = twoLanesAhead();
  scene.request.queue = true;
  const Attack first = answerIn(scene);
  ASSERT_EQ(first.status.code, StatusCode::kOk) << first.status.message;
  const double front = first.report.attacker_at_contact.x + 0.5 * first.trajectory.size.length;
  scene.map->drivable_area = {rectangle(-200.0, -4.5, front + 1.0, 8.0)};
  const Attack second = answerIn(scene);
  EXPECT_EQ(second.status.code, StatusCode::kRoadDoesNotAllow);
  EXPECT_NE(
      second.status.message.find("no queue can be added: every place ahead of the attacker is "
                                 "off the road"),
      std::string::npos)
      << second.status.message;
}

}  // namespace
}  // namespace forge
