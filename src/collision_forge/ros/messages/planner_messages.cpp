#include "collision_forge/ros/messages/planner_messages.h"

#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

void fillContact(const PlannerContact& contact, collision_forge::PlannerOutcome& message) {
  message.contact_time = stampOf(contact.time);
  message.other_id = contact.other_id;
  message.is_attacker = contact.is_attacker;
  if (contact.type) message.collision_type = toString(*contact.type);
  message.relative_heading = contact.relative_heading;
  message.ego_side = toString(contact.ego_side);
  message.other_side = toString(contact.other_side);
  message.impact_speed = contact.impact_speed;
  message.energy_lost = contact.severity.energy_lost;
  message.ego_effect = toMessage(contact.severity.ego);
  message.other_effect = toMessage(contact.severity.other);
  message.cause = toString(contact.cause);
  message.at_fault = contact.at_fault;
}

void fillNuplan(const NuplanScore& score, collision_forge::PlannerOutcome& message) {
  message.nuplan_score = score.total;
  message.nuplan_no_at_fault_collision = score.no_at_fault_collision;
  message.nuplan_drivable_area = score.drivable_area;
  message.nuplan_driving_direction = score.driving_direction;
  message.nuplan_making_progress = score.making_progress;
  message.nuplan_time_to_collision = score.time_to_collision;
  message.nuplan_comfort = score.comfort;
  message.nuplan_progress = score.progress;
}

}  // namespace

collision_forge::PlanningState toMessage(const Observation& observation, const DrivingTask& task,
                                         std::uint32_t test, double interval) {
  collision_forge::PlanningState message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stampOf(observation.ego.time);
  message.test = test;
  message.interval = interval;
  message.ego = toMessage(observation.ego);
  message.ego_size = toMessage(task.ego.size);
  message.center_offset = task.ego.center_offset;
  message.wheelbase = task.wheelbase;
  for (const Track& agent : observation.agents) message.agents.push_back(toMessage(agent));
  message.red_lanes = observation.red_lanes;
  const Polyline route(task.route);
  for (const double arc_length : route.arcLengths()) {
    message.route.push_back(toPose2dMessage(route.poseAt(arc_length)));
  }
  return message;
}

std::vector<TrajectoryPoint> fromMessage(const collision_forge::PlannedTrajectory& message) {
  requireMapFrame(message.header, names::kPlannedTrajectory);
  std::vector<TrajectoryPoint> points;
  for (const auto& point : message.points) {
    const auto& q = point.pose.orientation;
    if (q.x == 0.0 && q.y == 0.0 && q.z == 0.0 && q.w == 0.0) {
      throw MessageError("points[" + std::to_string(points.size()) +
                         "].pose.orientation is 0, 0, 0, 0, which is no rotation");
    }
    points.push_back(fromMessage(point));
  }
  return points;
}

collision_forge::PlannerOutcome toMessage(const PlannerTrial& trial, const std::string& planner,
                                          PolicyKind policy) {
  const RolloutOutcome& outcome = trial.outcome;
  collision_forge::PlannerOutcome message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stampOf(outcome.driven.front().time);
  message.planner = planner;
  message.attacker_id = outcome.attacker.attacker_id;
  message.attacker_policy = toString(policy);
  message.attacker_phase = toString(outcome.phase);
  message.attacker_plans = static_cast<std::uint32_t>(outcome.attacker_plans.size());
  if (!outcome.attacker_plans.empty()) {
    message.attacker_decision = outcome.attacker_plans.back().reason;
  }
  message.failure = toString(outcome.failure);
  message.failure_message = outcome.failure_message;
  for (const CarefulDrive& drive : outcome.careful_drivers) {
    message.careful_drivers.push_back(toMessage(drive));
  }
  message.duration = outcome.duration;
  message.collided = outcome.contact.has_value();
  if (outcome.contact) fillContact(*outcome.contact, message);
  message.max_braking = outcome.max_braking;
  message.hard_braking = outcome.hard_braking;
  message.off_road_share = outcome.off_road_share;
  message.progress = outcome.progress;
  message.recorded_progress = outcome.recorded_progress;
  fillNuplan(outcome.nuplan, message);
  message.avoidable = trial.avoidability.isAvoidable();
  for (const Avoidance& avoidance : trial.avoidability.from_now) {
    message.avoided_by.push_back(toString(avoidance.manoeuvre));
  }
  if (trial.avoidability.last) {
    message.last_manoeuvre = toString(trial.avoidability.last->manoeuvre);
    message.last_moment = stampOf(trial.avoidability.last->start);
  }
  message.ticks = static_cast<std::uint32_t>(outcome.plans);
  message.mean_call_time = trial.mean_call;
  message.max_call_time = trial.max_call;
  for (const TrajectoryPoint& point : outcome.driven) message.driven.push_back(toMessage(point));
  return message;
}

}  // namespace forge
