#include "collision_forge/attack/verify/verification.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <tuple>

#include <Eigen/Geometry>

#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/attack/severity/severity.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/attack/verify/drive_check.h"
#include "collision_forge/attack/verify/limits.h"
#include "collision_forge/attack/verify/manoeuvre_detection.h"
#include "collision_forge/attack/verify/measured_conditions.h"
#include "collision_forge/attack/verify/reversing.h"
#include "collision_forge/attack/verify/step_out.h"
#include "collision_forge/base/geometry/swept_contact.h"
#include "collision_forge/base/scene/find_track.h"

namespace forge {
namespace {

/// Returns the times, from the first point to `end`, at which either vehicle starts a new linear
/// piece.
std::vector<double> breakpoints(const AttackerTrajectory& trajectory, const Track& track,
                                double end) {
  std::vector<double> times;
  const double begin = trajectory.points.front().time;
  for (const TrajectoryPoint& point : trajectory.points) times.push_back(point.time);
  for (const AgentState& state : track.states) times.push_back(state.time);
  times.push_back(end);
  std::sort(times.begin(), times.end());
  times.erase(std::remove_if(times.begin(), times.end(),
                             [=](double time) { return time < begin || time > end; }),
              times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Returns true if the bounding boxes of both paths up to `end` are too far apart for a contact.
bool staysClear(const AttackerTrajectory& trajectory, const Track& track, double end) {
  if (track.states.empty()) return true;
  const double reach = circumradius(trajectory.size) + circumradius(track.size);
  const auto extent = [end](const auto& samples, auto position) {
    Eigen::AlignedBox2d box;
    for (const auto& sample : samples) {
      box.extend(position(sample));
      if (sample.time > end) break;
    }
    return box;
  };
  const auto attacker =
      extent(trajectory.points, [](const TrajectoryPoint& p) { return p.pose.position(); });
  const auto other = extent(track.states, [](const AgentState& s) { return s.pose.position(); });
  return attacker.squaredExteriorDistance(other) > reach * reach;
}

/// Returns the next time if the track has states from times[index] until then, else times[index].
double seenUntil(const Track& track, const std::vector<double>& times, std::size_t index) {
  if (index + 1 == times.size()) return times[index];
  const double next = times[index + 1];
  const double middle = 0.5 * (times[index] + next);  // inside the track's gap, if there is one
  return stateAt(track, middle) && stateAt(track, next) ? next : times[index];
}

Vector2 velocityAt(const AttackerTrajectory& trajectory, double time) {
  const auto& points = trajectory.points;
  const auto after = std::find_if(points.begin(), points.end(),
                                  [=](const TrajectoryPoint& point) { return point.time >= time; });
  const auto velocity = [](const TrajectoryPoint& point) -> Vector2 {
    return point.speed * point.pose.heading();
  };
  if (after == points.end()) return velocity(points.back());
  if (after == points.begin()) return velocity(points.front());
  const TrajectoryPoint& before = *std::prev(after);
  const double ratio = (time - before.time) / (after->time - before.time);
  return velocity(before) + ratio * (velocity(*after) - velocity(before));
}

void describeContact(const AttackerTrajectory& trajectory, const VerificationInput& input,
                     CollisionReport& report) {
  const auto ego = stateAt(input.future.ego, report.contact_time);
  report.ego_at_contact = ego->pose;
  report.attacker_at_contact = poseAt(trajectory, report.contact_time);
  report.relative_heading = angleBetween(ego->pose.yaw, report.attacker_at_contact.yaw);
  const OrientedBox ego_box{ego->pose, input.future.ego.size};
  const OrientedBox attacker_box{report.attacker_at_contact, trajectory.size};
  report.ego_side = touchedSide(ego_box, attacker_box);
  report.attacker_side = touchedSide(attacker_box, ego_box);
  report.overlap = sideOverlap(ego_box, report.ego_side, attacker_box);
  report.impact_speed = (velocityAt(trajectory, report.contact_time) - ego->velocity).norm();
  report.conditions = measuredConditions(trajectory, report, input.future);
}

CrashSeverity severityOfContact(const AttackerTrajectory& trajectory, const Track& ego, double time,
                                const VerificationOptions& options) {
  const CrashedVehicle other{trajectory.agent_class,
                             trajectory.size,
                             {time, poseAt(trajectory, time), velocityAt(trajectory, time)}};
  return severityOf({ego.agent_class, ego.size, *stateAt(ego, time)}, other, options.severity);
}

/// `attacker`: its track up to t0, null if unknown.
std::optional<BrokenLimit> findBrokenDrive(const AttackerTrajectory& trajectory,
                                           const Track* attacker, double until, bool reverses,
                                           const VerificationOptions& options) {
  const Track box{trajectory.attacker_id, trajectory.agent_class, trajectory.size, {}};
  if (!reverses) {
    const DriveLimits limits = driveLimitsOf(box, options);
    const DriveState start = attacker ? driveStateNow(*attacker, options)
                                      : driveStateOf(trajectory.points.front(), limits);
    return findBrokenDrive(trajectory.points, start, until, limits);
  }
  std::vector<TrajectoryPoint> travelled = trajectory.points;
  turnRound(travelled);
  const DriveLimits limits = reversingLimits(box, options);
  const DriveState start =
      attacker ? reversingStateNow(*attacker, options) : driveStateOf(travelled.front(), limits);
  return findBrokenDrive(travelled, start, until, limits);
}

/// Sets whether the contact has the requested type and time.
void judgeContact(const AttackerTrajectory& trajectory, const VerificationInput& input,
                  const VerificationOptions& options, CollisionReport& report) {
  const TypeDefinition type = input.request.bands();
  report.type_kept = headingFits(report.relative_heading, type);
  if (input.request.crash.rules == TypeRules::kFull) {
    const TrajectoryPoint& start = trajectory.points.front();
    const AgentState ego_now =
        stateAt(input.future.ego, start.time).value_or(input.future.ego.states.front());
    const Pose2 offset = relativeTo(report.ego_at_contact, report.attacker_at_contact);
    const DrivingSide driving_side = input.lanes.map().driving_side;
    // A person on foot may turn towards the road at any time.
    const bool approaches = isOnFoot(trajectory.agent_class) ||
                            approachFits(angleBetween(ego_now.pose.yaw, start.pose.yaw), type);
    report.type_kept = report.type_kept && approaches &&
                       contactFits(input.request.type, offset, input.future.ego.size,
                                   trajectory.size, driving_side, input.request.turning);
    if (input.request.turning == Turning::kEgo) {
      const TurnHeadings headings{angleBetween(ego_now.pose.yaw, report.ego_at_contact.yaw),
                                  angleBetween(start.pose.yaw, report.attacker_at_contact.yaw),
                                  report.relative_heading};
      report.type_kept =
          report.type_kept &&
          egoTurns(input.request.type, headings, trajectory.agent_class, type, driving_side) &&
          (input.request.type == CollisionType::kLtap ||
           passesJunction(input.future.ego, start.time, report.contact_time, input.lanes,
                          options.believability));
    }
  }
  const double elapsed = report.contact_time - input.snapshot.now;
  report.on_time = std::abs(elapsed - input.request.tta) <= input.request.crash.time_tolerance;
}

void findFirstOther(const AttackerTrajectory& trajectory, const Future& future, double end,
                    double tolerance, CollisionReport& report) {
  for (const Track& other : future.agents) {
    if (other.id == trajectory.attacker_id) continue;
    const auto time = firstContactTime(trajectory, other, end, tolerance);
    if (!time || (report.contact && *time >= report.contact_time)) continue;
    const auto touched = std::tie(*time, other.id);  // at equal times, the smallest id
    if (report.first_other_id.empty() ||
        touched < std::tie(report.first_other_time, report.first_other_id)) {
      report.first_other_id = other.id;
      report.first_other_time = *time;
    }
  }
}

}  // namespace

std::optional<double> firstContactTime(const AttackerTrajectory& trajectory, const Track& track,
                                       double end, double tolerance) {
  if (staysClear(trajectory, track, end)) return std::nullopt;
  const std::vector<double> times = breakpoints(trajectory, track, end);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto from = stateAt(track, times[i]);
    if (!from) continue;
    const double until = seenUntil(track, times, i);
    const auto to = stateAt(track, until);
    const auto ratio =
        firstContact({poseAt(trajectory, times[i]), poseAt(trajectory, until), trajectory.size},
                     {from->pose, to->pose, track.size}, tolerance);
    if (ratio) return std::min(times[i] + *ratio * (until - times[i]), until);
  }
  return std::nullopt;
}

DriveLimits driveLimitsOf(const Track& attacker, const VerificationOptions& options) {
  return driveLimitsOf(attacker.agent_class, attacker.size, options.drivable);
}

DriveState driveStateNow(const Track& attacker, const VerificationOptions& options) {
  return driveStateOf(estimateMotion(attacker), driveLimitsOf(attacker, options));
}

CollisionReport verifyDrive(const AttackerTrajectory& trajectory, const VerificationInput& input,
                            const VerificationOptions& options) {
  if (trajectory.points.empty()) throw std::invalid_argument("the trajectory has no points");
  if (input.future.ego.states.empty()) throw std::invalid_argument("the ego's future is empty");
  CollisionReport report;
  const double end = trajectory.points.back().time;
  const double tolerance = options.overlap_tolerance;
  const auto contact = firstContactTime(trajectory, input.future.ego, end, tolerance);
  report.contact = contact && *contact > trajectory.points.front().time;
  if (report.contact) {
    report.contact_time = *contact;
    describeContact(trajectory, input, report);
  }
  const double until = report.contact ? *contact : end;
  findFirstOther(trajectory, input.future, until, tolerance, report);

  const Track* attacker = findTrack(input.snapshot.agents, trajectory.attacker_id);
  std::optional<BrokenLimit> broken;
  if (input.request.crash.limits == LimitSet::kStrict) {
    const double start_yaw =
        attacker ? attacker->states.back().pose.yaw : trajectory.points.front().pose.yaw;
    broken = findBrokenLimit(trajectory.points, start_yaw, until, options.limits);
    if (!broken) broken = findBrokenPositions(trajectory.points, until, options.limits);
  } else {
    broken = findBrokenDrive(trajectory, attacker, until, input.request.reverses(), options);
  }
  report.limits_kept = !broken;
  if (broken) report.broken_limit = describe(*broken);
  return report;
}

CollisionReport verifyMotion(const AttackerTrajectory& trajectory, const VerificationInput& input,
                             const VerificationOptions& options) {
  CollisionReport report = verifyDrive(trajectory, input, options);
  if (!report.contact) return report;
  judgeContact(trajectory, input, options, report);
  return report;
}

double offRoadShare(const AttackerTrajectory& trajectory, const CollisionReport& report,
                    const LaneIndex& lanes, const VerificationOptions& options) {
  const double until = report.contact ? report.contact_time : trajectory.points.back().time;
  double sum = 0.0;
  int count = 0;
  for (double time = trajectory.points.front().time; time <= until;
       time += options.off_road_interval) {
    sum += lanes.offRoadShare({poseAt(trajectory, time), trajectory.size}).value_or(0.0);
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

CollisionReport verify(const AttackerTrajectory& trajectory, const VerificationInput& input,
                       const VerificationOptions& options) {
  CollisionReport report = verifyMotion(trajectory, input, options);
  report.off_road_share = offRoadShare(trajectory, report, input.lanes, options);
  if (!report.contact) return report;
  report.severity = severityOfContact(trajectory, input.future.ego, report.contact_time, options);
  const DetectedManoeuvre detected = detectManoeuvre(trajectory, report, input, options);
  report.manoeuvre = detected.manoeuvre;
  report.manoeuvre_begin = detected.begin;
  const std::vector<TrajectoryPoint>& points = trajectory.points;
  const BelievabilityOptions& believability = options.believability;
  const auto roadUseOn = [&](const LaneIndex& lanes) {
    return roadUseOfAttack(points, trajectory.size, report.contact_time, lanes, believability);
  };
  report.road = roadUseOn(input.lanes);
  const LaneIndex& driven = drivenLanes(input.request, input.lanes);
  const RoadUse judged = &driven == &input.lanes ? report.road : roadUseOn(driven);
  if (isOnFoot(trajectory.agent_class)) {
    report.unbelievable = implausibleWalk(stepOutOf(points, report.contact_time, input.lanes));
  } else if (input.request.reverses()) {
    report.unbelievable = implausibleReversing(points, trajectory.size, report.contact_time,
                                               input.lanes, believability);
  } else {
    report.unbelievable = implausibilityOf(judged, points, trajectory.size, report.contact_time,
                                           driven, believability);
  }
  return report;
}

}  // namespace forge
