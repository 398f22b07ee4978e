#include "properties/plane_change.h"

#include <Eigen/Geometry>
#include <utility>

namespace forge {
namespace {

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
  for (TrajectoryPoint& point : of.points) {
    point.time += later;
    point.pose = pose(point.pose);
    if (is_mirrored) point.curvature = -point.curvature;
  }
  of.past = changed(std::move(of.past), *this);
  return of;
}

CollisionReport PlaneChange::report(CollisionReport of) const {
  of.contact_time += later;
  of.manoeuvre_begin += later;
  of.ego_at_contact = pose(of.ego_at_contact);
  of.attacker_at_contact = pose(of.attacker_at_contact);
  if (is_mirrored) {
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

}  // namespace forge
