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
constexpr double kEarly[] = {0.3, 0.7, 1.1, 1.6,
                             2.2};                     // s by which it has left before it would hit
constexpr double kDurations[] = {2.8, 2.2, 3.5, 1.8};  // s of the lane change
constexpr double kStep = 0.1;                          // s between its points
constexpr double kAfterwards = 1.5;    // s that its motion is planned beyond the contact
constexpr double kSpeedSpan = 0.25;    // s to either side for its speed
constexpr double kLeastGap = 2.0;      // m to the ego at t0
constexpr double kEgoClearance = 0.5;  // m to the ego
constexpr double kAcrossStep = 0.5;    // m between the points that look for a lane
constexpr double kNarrowest = 2.5;     // m between the middles of neighbouring lanes
constexpr double kWidest = 4.5;        // m
constexpr double kSteadyBefore = 1.0;  // s in its lane before it steers
constexpr double kSettled = 2.0;       // s after the lane change
constexpr double kStandingStep = 0.1;  // m per step below which it stands
constexpr double kSharpest = 0.1;      // 1/m
constexpr double kLaneHeading = 0.3;   // rad between neighbouring lanes
constexpr double kSteady = 0.1;        // rad to the lane at the contact
constexpr double kInLane = 0.4;        // m from the middle of a lane

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
    end_ = input.contact + kAfterwards;
  }

  std::optional<SupportVehicle> run(Status& refusal) {
    const std::vector<double> neighbours = neighbouringLanes();
    if (neighbours.empty()) {
      refusal = {StatusCode::kRoadDoesNotAllow, "no lane beside the ego's lane leads on"};
      return std::nullopt;
    }
    for (const double early : kEarly) {
      for (const double time_gap : kTimeGaps) {
        for (const double duration : kDurations) {
          for (const double across : neighbours) {
            for (const AddedKind& kind : options_.added.kinds) {
              if (kind.agent_class != AgentClass::kCar) continue;
              SupportVehicle leader;
              const char* problem = tryOne({time_gap, early, duration, across}, kind, leader);
              if (!problem) return leader;
              ++reasons_[problem];
            }
          }
        }
      }
    }
    for (const auto& [problem, count] : reasons_) {
      refusal.message +=
          (refusal.message.empty() ? "" : ", ") + std::to_string(count) + " " + problem;
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

  /// Returns m to the left from the ego's path to the lanes beside it.
  std::vector<double> neighbouringLanes() const {
    const Pose2 place = courseAt(input_.contact);
    std::vector<double> neighbours;
    for (const double side : {1.0, -1.0}) {
      for (double across = kNarrowest; across <= kWidest; across += kAcrossStep) {
        const Pose2 there = compose(place, {0.0, side * across, 0.0});
        const auto lanes = input_.lanes.lanesNear(there, kAcrossStep, kLaneHeading);
        if (lanes.empty()) continue;
        neighbours.push_back(side * across - lanes.front().projection.lateral);
        break;
      }
    }
    return neighbours;
  }

  /// Returns the planned state at `time`.
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
    double across;
  };

  const char* tryOne(const Try& tried, const AddedKind& kind, SupportVehicle& leader) const {
    const BoxSize size{kind.length, kind.width};
    const double reaches = input_.contact - tried.time_gap;  // place of the ego at the contact
    const double speed = std::max(1.0, speedAt(input_.contact));
    const double sooner = 0.5 * (size.length - input_.future.ego.size.length) / speed;
    CutOut cut_out{tried.time_gap, reaches - sooner - tried.early - tried.duration, tried.duration,
                   tried.across};
    if (cut_out.begin + cut_out.duration < now_) return "would have to leave before t0";
    const OrientedBox ego{courseAt(now_), input_.future.ego.size};
    if (distance(ego, {courseAt(now_ + tried.time_gap), size}) < kLeastGap) {
      return "drive too close to the ego";
    }
    leader.role = SupportRole::kLeader;
    leader.motion = {search_.newId("leader", 0), kind.agent_class, size, {}};
    if (!drive(cut_out, leader.motion)) return "break a limit";
    if (!endsInLane(cut_out, leader.motion)) return "miss the neighbouring lane";
    if (const char* problem = whyNot(leader.motion)) return problem;
    const Hiding hiding = search_.hidingBy([&](double time, std::vector<Block>& blocks) {
      blocks.push_back(
          {{poseAt(leader.motion, time), size}, typicalHeight(kind.agent_class, size)});
    });
    return search_.isInRange(hiding) ? nullptr : "do not hide the attacker until visible_for";
  }

  /// Sets past and points; returns false if the class cannot drive so. The vehicle steers by itself
  /// from shortly before the lane change on, which may begin before t0.
  bool drive(const CutOut& cut_out, AttackerTrajectory& leader) const {
    const auto steps = static_cast<int>(std::ceil((now_ - cut_out.begin + kSteadyBefore) / kStep));
    const double begin = now_ - std::max(0, steps) * kStep;
    const DriveLimits limits =
        driveLimitsOf(leader.agent_class, leader.size, options_.verification.drivable);
    std::vector<PlannedStep> plan;
    const auto count = static_cast<int>(std::lround((end_ - begin) / kStep));
    for (int i = 0; i <= count; ++i) plan.push_back(stepAt(cut_out, begin + i * kStep));
    const PlannedStep before = stepAt(cut_out, begin - kStep);
    const double turn = angleBetween(before.pose().yaw, plan[0].pose().yaw);
    const double bend = turn / std::max(kStandingStep, plan[0].speed * kStep);
    const TrajectoryPoint start{begin, plan[0].pose(), plan[0].speed,
                                (plan[0].speed - before.speed) / kStep,
                                std::clamp(bend, -kSharpest, kSharpest)};
    const DriveState state = driveStateOf(start, limits);
    std::vector<TrajectoryPoint> points;
    TrackDriver(limits, kLimitShare, kPreview, kStep).drive(state, begin, plan, points);
    if (findBrokenDrive(points, state, end_, limits)) return false;
    const Track driven{leader.attacker_id, leader.agent_class, leader.size, toStates(points)};
    for (const AgentState& frame : input_.past.ego.states) {
      const PlannedStep step = stepAt(cut_out, frame.time);
      const AgentState planned{frame.time, step.pose(), step.speed * step.heading};
      leader.past.push_back(stateAt(driven, frame.time).value_or(planned));
    }
    leader.points.assign(points.begin() + std::max(0, steps), points.end());
    leader.points.front().time = now_;
    return true;
  }

  bool endsInLane(const CutOut& cut_out, const AttackerTrajectory& leader) const {
    const double settled = std::min(cut_out.begin + cut_out.duration + kSettled, end_);
    const Pose2 there = poseAt(leader, settled);
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
                                               const AttackOptions& options, Status& refusal) {
  return LeaderSearch(input, options).run(refusal);
}

}  // namespace forge
