#include "properties/plane_change.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <utility>

namespace forge {
namespace {

constexpr std::uint64_t kChanges = 10;  // changes tried per attack

Side mirrored(Side side) {
  switch (side) {
    case Side::kLeft:
      return Side::kRight;
    case Side::kRight:
      return Side::kLeft;
    default:
      return side;
  }
}

std::vector<AgentState> changed(std::vector<AgentState> states, const PlaneChange& change) {
  for (AgentState& state : states) {
    state.time += change.later;
    state.pose = change.pose(state.pose);
    state.velocity = change.direction(state.velocity);
  }
  return states;
}

std::vector<TrajectoryPoint> changed(std::vector<TrajectoryPoint> points,
                                     const PlaneChange& change) {
  for (TrajectoryPoint& point : points) {
    point.time += change.later;
    point.pose = change.pose(point.pose);
    if (change.is_mirrored) point.curvature = -point.curvature;
  }
  return points;
}

void changePoints(std::vector<Vector2>& points, const PlaneChange& change) {
  for (Vector2& point : points) point = change.point(point);
}

LaneMap changed(LaneMap map, const PlaneChange& change) {
  if (change.is_mirrored) {
    map.driving_side =
        map.driving_side == DrivingSide::kRight ? DrivingSide::kLeft : DrivingSide::kRight;
  }
  for (Lane& lane : map.lanes) {
    for (Pose2& pose : lane.centerline) pose = change.pose(pose);
    changePoints(lane.polygon, change);
  }
  for (auto* area : {&map.drivable_area, &map.walkways}) {
    for (Polygon& polygon : *area) {
      changePoints(polygon.exterior, change);
      for (std::vector<Vector2>& hole : polygon.holes) changePoints(hole, change);
    }
  }
  return map;
}

Scene changed(Scene scene, const PlaneChange& change) {
  scene.ego.states = changed(std::move(scene.ego.states), change);
  for (Track& agent : scene.agents) agent.states = changed(std::move(agent.states), change);
  for (double& time : scene.frame_times) time += change.later;
  scene.map = std::make_shared<const LaneMap>(changed(*scene.map, change));
  return scene;
}

}  // namespace

Vector2 PlaneChange::direction(const Vector2& vector) const {
  const Vector2 seen(vector.x(), is_mirrored ? -vector.y() : vector.y());
  return Eigen::Rotation2Dd(turn) * seen;
}

Pose2 PlaneChange::pose(const Pose2& of) const {
  const Vector2 place = point(of.position());
  return {place.x(), place.y(), yaw(of.yaw)};
}

AttackerTrajectory PlaneChange::trajectory(AttackerTrajectory of) const {
  of.points = changed(std::move(of.points), *this);
  of.past = changed(std::move(of.past), *this);
  return of;
}

CollisionReport PlaneChange::report(CollisionReport of) const {
  of.contact_time += later;
  of.manoeuvre_begin += later;
  of.ego_at_contact = pose(of.ego_at_contact);
  of.attacker_at_contact = pose(of.attacker_at_contact);
  for (CarefulDrive& drive : of.careful_drivers) {
    if (drive.brakes_at) *drive.brakes_at += later;
  }
  if (is_mirrored) {
    for (CrashEffect* effect : {&of.severity.ego, &of.severity.other}) {
      effect->force_from = wrapAngle(-effect->force_from);
      effect->yaw_rate_change = -effect->yaw_rate_change;
    }
    of.relative_heading = wrapAngle(-of.relative_heading);
    of.ego_side = mirrored(of.ego_side);
    of.attacker_side = mirrored(of.attacker_side);
  }
  return of;
}

AskedMoment PlaneChange::asked(AskedMoment of) const {
  IndexedScene indexed{changed(of.recording->scene, *this), nullptr};
  indexed.lanes = std::make_shared<const LaneIndex>(indexed.scene.map);
  of.recording = std::make_shared<const IndexedScene>(std::move(indexed));
  of.now += later;
  if (is_mirrored && of.request.ego_side) of.request.ego_side = mirrored(*of.request.ego_side);
  return of;
}

Scenario PlaneChange::scenario(Scenario of) const {
  of.asked.now += later;
  std::optional<Side>& side = of.asked.request.ego_side;
  if (is_mirrored && side) side = mirrored(*side);
  of.answer.trajectory = trajectory(std::move(of.answer.trajectory));
  of.answer.report = report(std::move(of.answer.report));
  CollisionPattern& aim = of.answer.pattern;
  aim.time += later;
  aim.ego.center = pose(aim.ego.center);
  if (is_mirrored) {
    Pose2& offset = aim.attacker_offset;
    offset = {offset.x, -offset.y, wrapAngle(-offset.yaw)};
  }
  for (AttackerPlan& plan : of.plans) {
    plan.seen += later;
    plan.from += later;
    plan.points = changed(std::move(plan.points), *this);
  }
  return of;
}

PlaneChange elsewhere(Random& random) {
  PlaneChange change;
  const auto cells = [&] { return 0.5 * std::round(random.uniform(-4e4, 4e4)); };
  change.shift = {cells(), cells()};
  change.later = std::round(random.uniform(-1.5e9, 5e8) * 64.0) / 64.0;
  return change;
}

PlaneChange turned(Random& random) {
  PlaneChange change;
  change.turn = random.uniform(-M_PI, M_PI);
  return change;
}

PlaneChange mirrored(Random& /*random*/) {
  PlaneChange change;
  change.is_mirrored = true;
  return change;
}

PlaneChange anyChange(Random& random) {
  PlaneChange change = elsewhere(random);
  change.turn = turned(random).turn;
  change.is_mirrored = isLikely(random, 0.5);
  return change;
}

void forChangedAnswers(
    const std::vector<Mode>& modes, MakeChange make,
    const std::function<void(const AskedMoment&, const Scenario&, const PlaneChange&)>& check) {
  std::uint64_t seed = caseRange().first_seed;
  std::optional<std::uint64_t> known;
  AskedMoment asked;
  Scenario scenario;
  forAllCases([&](Random& random) {
    const std::uint64_t wanted = seed++ / kChanges;
    if (known != wanted) {
      Random of_answer(wanted);
      asked = randomRequest(of_answer, modes);
      scenario = answered(asked);
      known = wanted;
    }
    check(asked, scenario, make(random));
  });
}

}  // namespace forge
