#include "collision_forge/attack/search/cut_out_leader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "collision_forge/attack/search/track_driver.h"
#include "collision_forge/attack/verify/drive_check.h"

namespace forge {
namespace {

constexpr double kTimeGaps[] = {1.0, 1.3, 0.8, 1.6, 2.0};  // s between leader and ego
constexpr double kEarly[] = {0.2, 0.5, 0.9, 1.4};  // s by which it has left before it would hit
constexpr double kDurations[] = {1.8, 2.2, 2.8,
                                 3.5};    // s of the lane change; UN R157: 0.5 to 3 m/s
constexpr double kSides[] = {1.0, -1.0};  // left, right
constexpr double kStep = 0.1;             // s between its points
constexpr double kAfterwards = 6.0;       // s that it drives on after the contact
constexpr double kSpeedSpan = 0.25;       // s to either side for its speed
constexpr double kLeastGap = 2.0;         // m to the ego at t0
constexpr double kEgoClearance = 0.5;     // m to the ego
constexpr double kAcrossStep = 0.5;       // m between the points that look for a lane
constexpr double kNarrowest = 2.5;        // m between the middles of neighbouring lanes
constexpr double kWidest = 4.5;           // m
constexpr double kLaneHeading = 0.3;      // rad between neighbouring lanes
constexpr double kSteady = 0.1;           // rad to the lane at the contact
constexpr double kInLane = 0.4;           // m from the middle of a lane

/// A lane change that is tried.
struct CutOut {
  double time_gap = 0.0;  // s
  double begin = 0.0;     // s, scene clock
  double duration = 0.0;  // s
  double across = 0.0;    // m to the left
};

class LeaderSearch {
 public:
  LeaderSearch(const HidingInput& input, const AttackOptions& options)
      : input_(input), options_(options), search_(input), now_(input.past.now) {
    course_ = input.past.ego;
    for (const AgentState& state : input.future.ego.states) {
      if (state.time > course_.states.back().time) course_.states.push_back(state);
    }
    end_ = std::max(input.attacker.points.back().time, input.contact + kAfterwards);
  }

  std::optional<SupportVehicle> run(std::string& reason) {
    for (const double early : kEarly) {
      for (const double time_gap : kTimeGaps) {
        for (const double duration : kDurations) {
          for (const double side : kSides) {
            for (const AddedKind& kind : options_.added.kinds) {
              if (kind.agent_class != AgentClass::kCar) continue;
              SupportVehicle leader;
              const char* problem = tryOne({time_gap, early, duration, side}, kind, leader);
              if (!problem) return leader;
              ++reasons_[problem];
            }
          }
        }
      }
    }
    for (const auto& [problem, count] : reasons_) {
      reason += (reason.empty() ? "" : ", ") + std::to_string(count) + " " + problem;
    }
    return std::nullopt;
  }

 private:
  /// Returns the ego's pose; beyond its known future it drives straight on.
  Pose2 courseAt(double time) const {
    if (const auto state = stateAt(course_, time)) return state->pose;
    const auto& states = time < now_ ? course_.states.front() : course_.states.back();
    return compose(states.pose, {states.velocity.norm() * (time - states.time), 0.0, 0.0});
  }

  double speedAt(double time) const {
    return (courseAt(time + kSpeedSpan).position() - courseAt(time - kSpeedSpan).position())
               .norm() /
           (2.0 * kSpeedSpan);
  }

  /// Returns m to the left, with the sign of `side`, to the middle of the neighbouring lane.
  std::optional<double> neighbourOf(const Pose2& place, double side) const {
    for (double across = kNarrowest; across <= kWidest; across += kAcrossStep) {
      const Pose2 there = compose(place, {0.0, side * across, 0.0});
      const auto lanes = input_.lanes.lanesNear(there, kAcrossStep, kLaneHeading);
      if (lanes.empty()) continue;
      const double offset = lanes.front().projection.lateral;
      return side * across - offset;
    }
    return std::nullopt;
  }

  /// Returns the pose at `time` and sets the speed.
  PlannedStep stepAt(const CutOut& cut_out, double time) const {
    const double u = std::clamp((time - cut_out.begin) / cut_out.duration, 0.0, 1.0);
    const double share = u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
    const double rate = 30.0 * u * u * (1.0 - u) * (1.0 - u) / cut_out.duration;
    const double along = speedAt(time + cut_out.time_gap);
    const double sideways = cut_out.across * rate;
    Pose2 pose = compose(courseAt(time + cut_out.time_gap), {0.0, cut_out.across * share, 0.0});
    pose.yaw = wrapAngle(pose.yaw + std::atan2(sideways, std::max(along, 1.0)));
    return {pose, std::hypot(along, sideways)};
  }

  struct Try {
    double time_gap;
    double early;
    double duration;
    double side;
  };

  const char* tryOne(const Try& tried, const AddedKind& kind, SupportVehicle& leader) const {
    const BoxSize size{kind.length, kind.width};
    const double reaches = input_.contact - tried.time_gap;  // place of the ego at the contact
    const double speed = std::max(1.0, speedAt(input_.contact));
    const double sooner = 0.5 * (size.length - input_.future.ego.size.length) / speed;
    CutOut cut_out{tried.time_gap, reaches - sooner - tried.early - tried.duration, tried.duration,
                   0.0};
    if (cut_out.begin < now_) return "would have to leave before t0";
    const OrientedBox ego{courseAt(now_), input_.future.ego.size};
    if (distance(ego, {courseAt(now_ + tried.time_gap), size}) < kLeastGap) {
      return "drive too close to the ego";
    }
    const auto across = neighbourOf(courseAt(input_.contact), tried.side);
    if (!across) return "have no lane into which to leave";
    cut_out.across = *across;
    leader.role = Hider::kLeader;
    leader.motion = {search_.newId("leader", 0), kind.agent_class, size, {}};
    if (!drive(cut_out, leader.motion)) return "break a limit";
    if (!endsInLane(leader.motion)) return "miss the neighbouring lane";
    if (const char* problem = whyNot(leader.motion)) return problem;
    const Hiding hiding = search_.hidingBy([&](double time, std::vector<OrientedBox>& boxes) {
      boxes.push_back({poseAt(leader.motion, time), size});
    });
    return search_.isInRange(hiding) ? nullptr : "do not hide the attacker until visible_for";
  }

  /// Sets past and points; returns false if the class cannot drive so.
  bool drive(const CutOut& cut_out, AttackerTrajectory& leader) const {
    for (const AgentState& frame : input_.past.ego.states) {
      const PlannedStep step = stepAt(cut_out, frame.time);
      leader.past.push_back({frame.time, step.pose(), step.speed * step.heading});
    }
    const DriveLimits limits =
        driveLimitsOf(leader.agent_class, leader.size, options_.verification.drivable);
    std::vector<PlannedStep> plan;
    for (double time = now_; time <= end_; time += kStep) plan.push_back(stepAt(cut_out, time));
    const double before = stepAt(cut_out, now_ - kStep).speed;
    const double turn = angleBetween(stepAt(cut_out, now_ - kStep).pose().yaw, plan[0].pose().yaw);
    const double metres = std::max(0.5, plan[0].speed * kStep);
    TrajectoryPoint start{now_, plan[0].pose(), plan[0].speed, (plan[0].speed - before) / kStep,
                          turn / metres};
    start.curvature = std::clamp(start.curvature, -0.1, 0.1);
    const DriveState state = driveStateOf(start, limits);
    TrackDriver(limits, kLimitShare, kPreview, kStep).drive(state, now_, plan, leader.points);
    return !findBrokenDrive(leader.points, state, end_, limits);
  }

  bool endsInLane(const AttackerTrajectory& leader) const {
    const Pose2 there = poseAt(leader, input_.contact);
    return !input_.lanes.lanesNear(there, kInLane, kSteady).empty();
  }

  const char* whyNot(const AttackerTrajectory& leader) const {
    const RecordedTraffic& traffic = search_.traffic();
    const Track past{leader.attacker_id, leader.agent_class, leader.size, leader.past};
    for (int instant = traffic.firstInstant(); instant <= traffic.lastInstant(); ++instant) {
      const double time = now_ + instant * traffic.interval();
      if (time > end_) break;
      const auto before = stateAt(past, time);
      const Pose2 pose = before ? before->pose : poseAt(leader, time);
      if (traffic.touches(pose, leader.size, instant, kSupportClearance)) {
        return "touch another agent";
      }
      if (time < now_) continue;
      if (!search_.isOnRoad({pose, leader.size})) return "leave the road";
      const auto ego = stateAt(input_.future.ego, time);
      if (ego && time <= input_.contact &&
          distance(boxAt(input_.future.ego, ego->pose), {pose, leader.size}) < kEgoClearance) {
        return "touch the ego";
      }
    }
    return nullptr;
  }

  const HidingInput& input_;
  const AttackOptions& options_;
  HidingSearch search_;
  double now_;
  double end_ = 0.0;  // s, scene clock, of its motion
  Track course_;      // of the ego, past and future
  std::map<std::string, int> reasons_;
};

}  // namespace

std::optional<SupportVehicle> findCutOutLeader(const HidingInput& input,
                                               const AttackOptions& options, std::string& reason) {
  return LeaderSearch(input, options).run(reason);
}

}  // namespace forge
