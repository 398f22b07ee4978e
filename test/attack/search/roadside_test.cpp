#include "collision_forge/attack/search/roadside.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "attack/search/added_scene.h"
#include "collision_forge/attack/search/alternatives.h"
#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/verify/step_out.h"

namespace forge {
namespace {

/// The two lanes of AddedScene with a walkway of 2 m on either side. The ego drives on y = 0.
AddedScene street() {
  AddedScene scene;
  scene.map->drivable_area = {rectangle(-200.0, -2.0, 200.0, 5.5)};
  scene.map->walkways = {rectangle(-200.0, -4.0, 200.0, -2.0), rectangle(-200.0, 5.5, 200.0, 7.5)};
  scene.request = believableRequestFor(CollisionType::kJunctionCrossing);
  scene.request.attacker_class = AgentClass::kPedestrian;
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

TEST(AddedWalkers, WaitAtTheRoadsideSinceTheFirstFrame) {
  AddedScene scene = street();
  const AddedVehicleInput input = scene.input();
  const AddedVehicles walkers = addFromRoadside(input, shippedOptions());
  ASSERT_FALSE(walkers.found.empty()) << walkers.status.message;
  bool is_left = false;
  bool is_right = false;
  for (const AddedVehicle& walker : walkers.found) {
    EXPECT_EQ(walker.track.states.size(), input.past->ego.states.size());
    const Vector2 place = walker.track.states.front().pose.position();
    EXPECT_TRUE(isWherePeopleWalk(place, input.lanes));
    (place.y() > 0.0 ? is_left : is_right) = true;
  }
  EXPECT_TRUE(is_left && is_right) << "from both sides";
}

TEST(AddedWalkers, WaitOnTheSideThatIsRequested) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    AddedScene scene = street();
    scene.request.from_side = side;
    const AddedVehicleInput input = scene.input();
    const AddedVehicles walkers = addFromRoadside(input, shippedOptions());
    ASSERT_FALSE(walkers.found.empty()) << walkers.status.message;
    for (const AddedVehicle& walker : walkers.found) {
      EXPECT_EQ(walker.track.states.front().pose.y > 0.0, side == Side::kLeft) << toString(side);
    }
  }
}

TEST(AddedWalkers, StepOutInFrontOfTheEgo) {
  AddedScene scene = street();
  const Attack attack = answerIn(scene);
  ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
  EXPECT_EQ(attack.trajectory.agent_class, AgentClass::kPedestrian);
  EXPECT_TRUE(attack.trajectory.isAdded());
  EXPECT_TRUE(meetsRequest(attack.report, scene.request));
  EXPECT_NEAR(std::abs(attack.report.relative_heading), M_PI / 2, 0.2);
  for (const TrajectoryPoint& point : attack.trajectory.points) EXPECT_LT(point.speed, 4.0);
}

TEST(AddedWalkers, DepartAtTheRequestedTime) {
  for (const double departure : {0.5, 1.0, 1.5, 2.0}) {
    AddedScene scene = street();
    scene.request.departure_time = Range{departure - 0.25, departure + 0.25};
    const Attack attack = answerIn(scene);
    ASSERT_EQ(attack.status.code, StatusCode::kOk) << departure << ": " << attack.status.message;
    EXPECT_NEAR(attack.report.conditions.departure_time, departure, 0.25 + 1e-6);
  }
}

/// The limits of config/vehicle_limits.yaml; a child walks at 5 km/h and a runner runs at 8 km/h in
/// Euro NCAP's CPNCO and CPFA.
TEST(AddedWalkers, ChildrenAndRunnersKeepTheirOwnLimits) {
  const std::tuple<AgentClass, double, double> cases[] = {{AgentClass::kChild, 5.0 / 3.6, 3.5},
                                                          {AgentClass::kRunner, 8.0 / 3.6, 5.0}};
  for (const auto& [agent_class, speed, fastest] : cases) {
    AddedScene scene = street();
    scene.request.attacker_class = agent_class;
    scene.request.attacker_speed = Range{speed - 0.3, speed + 0.3};
    const Attack attack = answerIn(scene);
    ASSERT_EQ(attack.status.code, StatusCode::kOk)
        << toString(agent_class) << ": " << attack.status.message;
    EXPECT_EQ(attack.trajectory.agent_class, agent_class);
    EXPECT_TRUE(attack.report.verified());
    EXPECT_NEAR(attack.report.conditions.attacker_speed, speed, 0.3 + 1e-6);
    for (const TrajectoryPoint& point : attack.trajectory.points) {
      EXPECT_LE(point.speed, fastest) << toString(agent_class);
    }
  }
}

TEST(AddedWalkers, NeedARoadside) {
  AddedScene scene = street();
  scene.map->drivable_area = {rectangle(-200.0, -60.0, 200.0, 60.0)};
  scene.request.choice = AttackerChoice::kNew;
  const Attack attack = answerIn(scene);
  EXPECT_EQ(attack.status.code, StatusCode::kNoCandidate);
  EXPECT_NE(attack.status.message.find("no pedestrian can be added"), std::string::npos)
      << attack.status.message;
}

/// The ego turns left by 90 degrees within 4 s and then drives north on x = 0, y > 0.
void turnLeft(Future& future) {
  future.ego.states.clear();
  for (int i = 0; i <= 100; ++i) {
    const double time = 0.1 * i;
    const double yaw = std::min(M_PI / 2, time * M_PI / 8);
    const double radius = 5.0;
    const Pose2 pose{radius * (std::sin(yaw) - 1.0),
                     radius * (1.0 - std::cos(yaw)) + std::max(0.0, 2.0 * (time - 4.0)), yaw};
    future.ego.states.push_back({kNow + time, pose, 2.0 * pose.heading()});
  }
}

TEST(AddedWalkers, CrossTheArmIntoWhichTheEgoTurns) {
  for (const bool turns : {true, false}) {
    AddedScene scene = street();
    scene.map->drivable_area.push_back(rectangle(-4.0, 5.0, 4.0, 60.0));
    scene.map->walkways = {rectangle(4.0, 7.5, 6.0, 60.0), rectangle(-6.0, 7.5, -4.0, 60.0)};
    scene.request.turning = Turning::kEgo;
    scene.request.tta = 6.0;
    const AddedVehicleInput input = scene.input();
    Moment moment{*input.past, input.future, std::make_shared<LaneIndex>(scene.map),
                  std::make_shared<Snapshot>(*input.past)};
    moment.snapshot.ego = AddedScene::longPast(kEgoId, kEgoSize, {-5.0, 0.0, 0.0}, 2.0);
    moment.past = std::make_shared<Snapshot>(moment.snapshot);
    moment.recorded->ego = futureTrack(kEgoId, kEgoSize, {-5.0, 0.0, 0.0}, 2.0);
    if (turns) turnLeft(*moment.recorded);
    const AttackOptions options = shippedOptions();
    const Attack attack =
        generateCollision(searchMethod(options), moment, scene.request, options.prediction);
    if (!turns) {
      EXPECT_EQ(attack.status.code, StatusCode::kRoadDoesNotAllow);
      EXPECT_NE(attack.status.message.find("turn far enough"), std::string::npos)
          << attack.status.message;
      continue;
    }
    ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
    EXPECT_TRUE(meetsRequest(attack.report, scene.request));
    EXPECT_LT(std::abs(std::sin(attack.report.attacker_at_contact.yaw)), 0.5) << "along x";
  }
}

/// The street with a drive of 5 m on its right side, 4 s ahead of the ego, across the walkway.
AddedScene streetWithDrive() {
  AddedScene scene = street();
  const double x = AddedScene::kEgoX + 4.0 * AddedScene::kEgoSpeed;
  scene.map->drivable_area.push_back(rectangle(x - 2.0, -16.0, x + 5.0, -2.0));
  scene.request.attacker_class.reset();
  scene.request.manoeuvre = Manoeuvre::kBackOut;
  return scene;
}

TEST(BackingOut, ReversesOutOfADriveIntoTheEgo) {
  AddedScene scene = streetWithDrive();
  const Attack attack = answerIn(scene);
  ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
  EXPECT_TRUE(meetsRequest(attack.report, scene.request));
  EXPECT_EQ(attack.report.manoeuvre, Manoeuvre::kBackOut);
  EXPECT_TRUE(attack.trajectory.isAdded());
  const std::vector<TrajectoryPoint>& points = attack.trajectory.points;
  EXPECT_NEAR(points.front().pose.yaw, -M_PI / 2, 0.1) << "its front is away from the road";
  EXPECT_LT(points.front().pose.y, -4.0);
  EXPECT_EQ(attack.trajectory.past.front().pose.yaw, points.front().pose.yaw);
  const double fastest = shippedOptions().verification.drivable.max_reverse_speed;
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_LE(points[i].speed, 0.0);
    EXPECT_GE(points[i].speed, -fastest - 0.05);
    const Vector2 moved = points[i].pose.position() - points[i - 1].pose.position();
    EXPECT_LE(moved.dot(points[i].pose.heading()), 1e-6) << "backwards";
  }
  EXPECT_GT(attack.report.conditions.attacker_speed, 0.0);
}

TEST(BackingOut, NeedsABayOrADrive) {
  AddedScene scene = street();
  scene.request.attacker_class.reset();
  scene.request.manoeuvre = Manoeuvre::kBackOut;
  const Attack attack = answerIn(scene);
  EXPECT_EQ(attack.status.code, StatusCode::kRoadDoesNotAllow);
  EXPECT_NE(attack.status.message.find("no bay and no drive"), std::string::npos)
      << attack.status.message;
}

TEST(BackingOut, IsNoAlternativeUnlessItIsRequested) {
  AddedScene scene = streetWithDrive();
  scene.request.manoeuvre.reset();
  scene.request.attacker_class = AgentClass::kCar;
  scene.request.alternatives = 4;
  const AddedVehicleInput input = scene.input();
  const Moment moment{*input.past, input.future, std::make_shared<LaneIndex>(scene.map),
                      std::make_shared<Snapshot>(*input.past)};
  const AttackOptions options = shippedOptions();
  Attack first;
  first.report.manoeuvre = Manoeuvre::kTurnIntoPath;
  first.trajectory.points = {{kNow, {}, 0.0, 0.0, 0.0}};
  EXPECT_TRUE(
      findAlternatives(first, searchMethod(options), moment, scene.request, options.prediction)
          .empty());
}

TEST(BackingOut, IsAsFarAwayAsThePatternSays) {
  AddedScene scene = streetWithDrive();
  scene.request.attacker_class = AgentClass::kTruck;
  scene.request.ego_side = Side::kRight;
  const Attack attack = answerIn(scene);
  ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
  EXPECT_EQ(attack.trajectory.agent_class, AgentClass::kTruck);
  EXPECT_EQ(attack.report.attacker_side, Side::kRear);
  EXPECT_LT(attack.pattern.attacker_speed, 0.0);
  EXPECT_NEAR(angleBetween(attack.pattern.attacker_offset.yaw, attack.report.relative_heading), 0.0,
              0.2);
}

/// Adds a recorded adult on the walkway who moves along it.
void addAdult(AddedScene& scene, double speed) {
  scene.request.choice = AttackerChoice::kExisting;
  const Pose2 now{-9.0 - 2.5 * speed, -3.0, 0.0};
  scene.others.push_back(AddedScene::longPast("walker", {0.7, 0.65}, now, speed));
  scene.others.back().agent_class = AgentClass::kPedestrian;
  scene.future.agents.push_back(futureTrack("walker", {0.7, 0.65}, now, speed));
  scene.future.agents.back().agent_class = AgentClass::kPedestrian;
}

TEST(RecordedWalkers, AreRunnersIfTheyRunAtT0) {
  for (const double speed : {1.4, 2.5}) {
    AddedScene scene = street();
    scene.request.attacker_class = AgentClass::kRunner;
    addAdult(scene, speed);
    const Attack attack = answerIn(scene);
    if (speed < 2.0) {
      EXPECT_EQ(attack.status.code, StatusCode::kNoCandidate) << attack.status.message;
      continue;
    }
    ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
    EXPECT_EQ(attack.trajectory.attacker_id, "walker");
    EXPECT_EQ(attack.trajectory.agent_class, AgentClass::kRunner);
  }
}

/// Refuses with the classes of all agents.
class ClassTeller : public AttackMethod {
 public:
  Attack answer(const Moment& moment, const CollisionRequest& /*request*/) const override {
    std::string classes;
    for (const Track& agent : moment.snapshot.agents) {
      classes += agent.id + " " + toString(agent.agent_class) + "\n";
    }
    return rejection({StatusCode::kNoCandidate, classes});
  }
};

TEST(RecordedWalkers, WhoRanBeforeT0AndIsOutOfSightThenIsNoRunner) {
  AddedScene scene = street();
  scene.request.attacker_class = AgentClass::kRunner;
  addAdult(scene, 2.5);
  Track gone = scene.others.back();
  gone.id = "gone";
  gone.states.pop_back();
  scene.others.push_back(gone);
  const AddedVehicleInput input = scene.input();
  const Moment moment{*input.past, input.future, std::make_shared<LaneIndex>(scene.map),
                      std::make_shared<Snapshot>(*input.past)};
  const Status status =
      generateCollision(ClassTeller(), moment, scene.request, shippedOptions().prediction).status;
  EXPECT_EQ(status.message, "walker runner\ngone pedestrian\n");
}

TEST(RecordedWalkers, WalkAlongTheKerbAndThenStepOut) {
  AddedScene scene = street();
  addAdult(scene, 1.2);
  const Attack attack = answerIn(scene);
  ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
  EXPECT_EQ(attack.trajectory.attacker_id, "walker");
  EXPECT_FALSE(attack.trajectory.isAdded());
  EXPECT_TRUE(attack.report.believable()) << attack.report.unbelievable;
}

}  // namespace
}  // namespace forge
