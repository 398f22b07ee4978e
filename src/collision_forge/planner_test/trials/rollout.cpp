#include "collision_forge/planner_test/trials/rollout.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "collision_forge/attack/drivers/careful_drive.h"
#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/attack/severity/severity.h"
#include "collision_forge/base/geometry/enum_words.h"
#include "collision_forge/base/geometry/swept_contact.h"
#include "collision_forge/base/scene/clock.h"
#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/planner_test/planners/route_road.h"

namespace forge {
namespace {

constexpr double kTimeSlack = 1e-3;    // s; no step is shorter
constexpr double kLongestPlan = 60.0;  // s; no scenario lasts longer, later points are ignored

constexpr EnumWord<PlannerFailure> kFailureNames[] = {
    {PlannerFailure::kNone, "none"},           {PlannerFailure::kError, "error"},
    {PlannerFailure::kEmpty, "empty"},         {PlannerFailure::kNotFinite, "not_finite"},
    {PlannerFailure::kUnordered, "unordered"}, {PlannerFailure::kLate, "late"},
    {PlannerFailure::kTimedOut, "timed_out"},  {PlannerFailure::kOffMap, "off_map"},
};

struct Failure {
  PlannerFailure kind = PlannerFailure::kNone;
  std::string message;
};

bool isFinite(const TrajectoryPoint& point) {
  return std::isfinite(point.time) && point.pose.isFinite() && std::isfinite(point.speed) &&
         std::isfinite(point.acceleration) && std::isfinite(point.curvature);
}

/// Returns the failure of a plan made at `now` that must last until the next call.
Failure failureOf(const std::vector<TrajectoryPoint>& plan, double now, double next_call) {
  if (plan.empty()) return {PlannerFailure::kEmpty, "the trajectory has no points"};
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const std::string where = "point " + std::to_string(i);
    if (!isFinite(plan[i])) return {PlannerFailure::kNotFinite, where + " is not finite"};
    if (i > 0 && plan[i].time <= plan[i - 1].time) {
      return {PlannerFailure::kUnordered, where + " is not later than the previous one"};
    }
  }
  const double first = plan.front().time - now;
  const double last = plan.back().time - now;
  if (std::abs(first) > kTimeEpsilon || plan.back().time < next_call - kTimeEpsilon) {
    return {PlannerFailure::kLate, "the trajectory goes from " + numberText(first) + " to " +
                                       numberText(last) + " s after the call, not from 0 to " +
                                       numberText(next_call - now) + " s"};
  }
  return {};
}

/// Moves the ego along its plans.
class EgoDriver {
 public:
  EgoDriver(const TrajectoryPoint& start, const Driving& driving, const EgoVehicle& ego,
            const PlannerOptions& options)
      : point_(start),
        is_exact_(driving.is_exact),
        center_offset_(ego.center_offset),
        step_(options.lqr.step),
        bicycle_(options.car),
        tracker_(options.lqr, options.car.wheelbase),
        state_(bicycle_.stateOf(start, ego.center_offset)) {}

  const TrajectoryPoint& point() const { return point_; }

  void follow(std::vector<TrajectoryPoint> plan) {
    plan_ = std::move(plan);
    if (is_exact_) return;
    const double duration = std::min(plan_.back().time - plan_.front().time, kLongestPlan);
    const int steps = std::max(1, static_cast<int>(std::floor(duration / step_ + kTimeEpsilon)));
    std::vector<Pose2> axles;
    for (int i = 0; i <= steps; ++i) {
      const TrajectoryPoint planned = pointAt(plan_, plan_.front().time + i * step_);
      axles.push_back(rearAxleOf(planned.pose, center_offset_));
    }
    tracker_.setReference(std::move(axles));
  }

  void advance(double time) {
    if (is_exact_) {
      point_ = pointAt(plan_, time);
      point_.time = time;
      return;
    }
    const double elapsed = (point_.time - plan_.front().time) / step_;
    const auto index = static_cast<std::size_t>(std::lround(std::max(elapsed, 0.0)));
    state_ = bicycle_.step(state_, tracker_.command(state_, index), time - point_.time);
    point_ = bicycle_.pointOf(state_, time, center_offset_);
  }

 private:
  TrajectoryPoint point_;
  bool is_exact_;
  double center_offset_;
  double step_;
  KinematicBicycle bicycle_;
  LqrTracker tracker_;
  BicycleState state_;
  std::vector<TrajectoryPoint> plan_;
};

/// Returns the recorded ego at t0 with its motion estimated from the past.
TrajectoryPoint startOf(const CrashScenario& scenario, const AttackOptions& options) {
  const Motion motion = estimateMotion(scenario.snapshot.ego);
  TrajectoryPoint start{scenario.snapshot.now, motion.pose, std::max(motion.speed, 0.0),
                        motion.acceleration, 0.0};
  if (start.speed >= options.verification.limits.curvature_min_speed) {
    start.curvature =
        std::clamp(motion.yaw_rate / start.speed, -options.verification.limits.max_curvature,
                   options.verification.limits.max_curvature);
  }
  return start;
}

Vector2 velocityOf(const TrajectoryPoint& point) { return point.speed * point.pose.heading(); }

Track trackAt(const TrajectoryPoint& point, const BoxSize& size) {
  return {kEgoId, AgentClass::kCar, size, {{point.time, point.pose, velocityOf(point)}}};
}

/// One rollout, step by step.
class Run {
 public:
  Run(Planner& planner, const Driving& driving, const CrashScenario& scenario,
      const RolloutSetup& setup)
      : planner_(planner),
        driving_(driving),
        scenario_(scenario),
        setup_(setup),
        options_(setup.planners.rollout),
        task_{scenario.lanes,
              routeOf(scenario.recorded.ego, *scenario.lanes, setup.planners.planning.route),
              scenario.ego, setup.planners.car.wheelbase},
        road_(roadAlong(*scenario.lanes, task_.route, setup.planners.route_centerline,
                        setup.planners.pdm.map)),
        judge_(road_.map, scenario.ego, setup.planners.pdm.scoring, setup.planners.nuplan_score),
        traffic_(makeRolloutTraffic(scenario, setup)),
        ego_(startOf(scenario, setup.attack), driving, scenario.ego, setup.planners) {
    const OrientedBox box{ego_.point().pose, scenario.ego.size};
    for (const Track& agent : traffic_.agents()) {
      if (overlaps(box, boxAt(agent, agent.states.back().pose))) ignored_.insert(agent.id);
    }
    outcome_.driven.push_back(ego_.point());
    keepOthers();
    judge_.addStep(ego_.point(), traffic_.agents(), ignored_);
    was_on_road_ = offRoadShare() < 1.0;
  }

  RolloutOutcome run() {
    attempt([&] { planner_.initialize(task_); });
    const int steps_per_plan =
        std::max(1, static_cast<int>(std::lround(driving_.interval / options_.step)));
    while (!isOver()) {
      if (steps_ % steps_per_plan == 0) callPlanner();
      if (outcome_.failure == PlannerFailure::kNone) advance();
    }
    summarize();
    return std::move(outcome_);
  }

 private:
  double now() const { return ego_.point().time; }

  /// The last step ends with the attacker's trajectory and may be slightly shorter or longer.
  double timeOfStep(int step) const {
    const double time = outcome_.driven.front().time + step * options_.step;
    return time > scenario_.end() - kTimeSlack ? scenario_.end() : time;
  }

  bool isOver() const {
    return (outcome_.contact && setup_.ends_at_contact) ||
           outcome_.failure != PlannerFailure::kNone || now() >= scenario_.end() - kTimeEpsilon;
  }

  /// Exceptions of the planner count as its failures; their time is measured like any call's.
  template <typename Call>
  void attempt(const Call& call) {
    const auto start = std::chrono::steady_clock::now();
    try {
      call();
    } catch (const PlannerTimeout& error) {
      fail({PlannerFailure::kTimedOut, error.what()});
    } catch (const LatePlan& error) {
      fail({PlannerFailure::kLate, error.what()});
    } catch (const std::exception& error) {
      fail({PlannerFailure::kError, error.what()});
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    outcome_.planning_seconds += elapsed.count();
  }

  void fail(const Failure& failure) {
    outcome_.failure = failure.kind;
    outcome_.failure_message = failure.message;
  }

  void callPlanner() {
    std::vector<TrajectoryPoint> plan;
    const Observation observation{ego_.point(), traffic_.agents(),
                                  redLanes(scenario_.lights, now())};
    attempt([&] { plan = planner_.plan(observation); });
    ++outcome_.plans;
    if (outcome_.failure != PlannerFailure::kNone) return;
    const double next_call = std::min(now() + driving_.interval, scenario_.end() - kTimeSlack);
    fail(failureOf(plan, now(), next_call));
    if (outcome_.failure == PlannerFailure::kNone) ego_.follow(std::move(plan));
  }

  void advance() {
    const double next = timeOfStep(++steps_);
    const TrajectoryPoint from = ego_.point();
    const std::vector<Track> before = traffic_.agents();
    traffic_.advance(next, trackAt(from, scenario_.ego.size));
    ego_.advance(next);
    keepOthers();
    if (!outcome_.contact) findContact(from, before);
    if (outcome_.contact && setup_.ends_at_contact) {
      outcome_.driven.push_back(pointAt({from, ego_.point()}, outcome_.contact->time));
    } else {
      outcome_.driven.push_back(ego_.point());
      judge_.addStep(ego_.point(), traffic_.agents(), ignored_);
      checkRoad();
    }
  }

  /// Returns the current poses of the agents; agents that do not react are at their recorded poses.
  void keepOthers() {
    if (setup_.background == Background::kReplay) return;
    for (const Track& agent : traffic_.agents()) {
      if (agent.id == scenario_.attacker.attacker_id) continue;
      const Track track{agent.id, agent.agent_class, agent.size, {}};
      others_.try_emplace(agent.id, track).first->second.states.push_back(agent.states.back());
    }
  }

  void findContact(const TrajectoryPoint& from, const std::vector<Track>& before) {
    const BoxSize& size = scenario_.ego.size;
    const TrajectoryPoint& to = ego_.point();
    double first = 1.0 + kTimeEpsilon;
    for (const Track& agent : before) {
      const Track* after = findTrack(traffic_.agents(), agent.id);
      if (after == nullptr || ignored_.count(agent.id) > 0) continue;
      const Pose2& start = agent.states.back().pose;
      const Pose2& end = after->states.back().pose;
      const double reach = circumradius(size) + circumradius(agent.size) +
                           (to.pose.position() - from.pose.position()).norm() +
                           (end.position() - start.position()).norm();
      if ((start.position() - from.pose.position()).norm() > reach) continue;
      const auto ratio = firstContact({from.pose, to.pose, size}, {start, end, agent.size},
                                      setup_.attack.verification.overlap_tolerance);
      if (!ratio || *ratio >= first) continue;
      first = *ratio;
      const double time = from.time + *ratio * (to.time - from.time);
      describeContact(pointAt({from, to}, time), *after, interpolate(start, end, *ratio));
    }
  }

  void describeContact(const TrajectoryPoint& ego, const Track& other, const Pose2& other_pose) {
    const OrientedBox ego_box{ego.pose, scenario_.ego.size};
    const OrientedBox other_box{other_pose, other.size};
    const ContactSide ego_side{ego_box, velocityOf(ego)};
    const ContactSide other_side{other_box, other.states.back().velocity,
                                 other.agent_class == AgentClass::kStaticObject};
    PlannerContact contact;
    contact.other_id = other.id;
    contact.is_attacker = other.id == scenario_.attacker.attacker_id;
    contact.time = ego.time;
    contact.place = placeOf(ego.pose.position(), *scenario_.lanes, options_.fault.lane_radius);
    contact.relative_heading = angleBetween(ego.pose.yaw, other_pose.yaw);
    contact.ego_side = touchedSide(ego_box, other_box);
    contact.other_side = touchedSide(other_box, ego_box);
    contact.impact_speed = impactSpeed(ego_side, other_side);
    contact.severity =
        severityOf({AgentClass::kCar, scenario_.ego.size, {ego.time, ego.pose, ego_side.velocity}},
                   {other.agent_class, other.size, {ego.time, other_pose, other_side.velocity}},
                   setup_.attack.verification.severity);
    contact.ego_speed = ego.speed;
    contact.cause = causeOf(ego_side, scenario_.ego.center_offset, other_side, options_.fault);
    contact.at_fault = isAtFault(contact.cause, ego_box, *scenario_.lanes, options_.fault);
    contact.type = typeOf(
        {outcome_.driven.front().pose, startPoseOf(other), ego_box, other_box, other.agent_class},
        scenario_.type, scenario_.turning, setup_.crash, scenario_.lanes->map().driving_side);
    outcome_.contact = contact;
    nuplan_contact_ = {contact.at_fault, other.agent_class == AgentClass::kStaticObject};
  }

  /// Returns the time t0, or when the other agent was first observed after it.
  Pose2 startPoseOf(const Track& other) const {
    if (other.id == scenario_.attacker.attacker_id) return scenario_.attacker.points.front().pose;
    const Track* recorded = findTrack(scenario_.recorded.agents, other.id);
    return recorded->states.front().pose;
  }

  double offRoadShare() const {
    return scenario_.lanes->offRoadShare({ego_.point().pose, scenario_.ego.size}).value_or(0.0);
  }

  /// Every `off_road_interval`, adds to the off-road share and ends the rollout if the whole box
  /// has left the road.
  void checkRoad() {
    const double interval = setup_.attack.verification.off_road_interval;
    const double start = outcome_.driven.front().time;
    if (now() < start + road_checks_ * interval - kTimeEpsilon) return;
    const double share = offRoadShare();
    off_road_sum_ += share;
    ++road_checks_;
    if (share >= 1.0 && was_on_road_) {
      fail({PlannerFailure::kOffMap, "the ego's whole box is off the drivable area"});
    }
    was_on_road_ = was_on_road_ || share < 1.0;
  }

  void summarize() {
    for (auto& [id, track] : others_) outcome_.others.push_back(std::move(track));
    const auto& driven = outcome_.driven;
    outcome_.duration = driven.back().time - driven.front().time;
    for (std::size_t i = 1; i < driven.size(); ++i) {
      const double duration = driven[i].time - driven[i - 1].time;
      if (duration <= kTimeEpsilon) continue;
      const double braking = (driven[i - 1].speed - driven[i].speed) / duration;
      outcome_.max_braking = std::max(outcome_.max_braking, braking);
      if (braking > options_.hard_braking) outcome_.hard_braking += duration;
    }
    if (road_checks_ > 0) outcome_.off_road_share = off_road_sum_ / road_checks_;
    const Polyline route(task_.route);
    const auto along = [&](const Pose2& pose) { return route.project(pose.position()).arc_length; };
    const double start = along(driven.front().pose);
    const auto recorded = stateAt(scenario_.recorded.ego, driven.back().time);
    const Pose2 recorded_end =
        recorded ? recorded->pose : scenario_.recorded.ego.states.back().pose;
    outcome_.progress = along(driven.back().pose) - start;
    outcome_.recorded_progress = along(recorded_end) - start;
    outcome_.attacker = traffic_.attacker().trajectory();
    outcome_.phase = traffic_.attacker().phase();
    outcome_.attacker_plans = traffic_.attacker().plans();
    if (outcome_.contact && outcome_.contact->is_attacker) {
      outcome_.careful_drivers = driveCarefully(drivenFuture(), outcome_.attacker);
    }
    outcome_.nuplan = judge_.score(nuplan_contact_, outcome_.progress, outcome_.recorded_progress);
  }

  /// Returns the ego as driven, and the other agents as recorded or as simulated.
  Future drivenFuture() const {
    Future future;
    future.ego = {kEgoId, AgentClass::kCar, scenario_.ego.size, toStates(outcome_.driven)};
    future.agents =
        setup_.background == Background::kReplay ? scenario_.recorded.agents : outcome_.others;
    return future;
  }

  Planner& planner_;
  const Driving& driving_;
  const CrashScenario& scenario_;
  const RolloutSetup& setup_;
  const RolloutOptions& options_;
  DrivingTask task_;
  RouteRoad road_;
  NuplanJudge judge_;
  std::optional<NuplanContact> nuplan_contact_;
  Traffic traffic_;
  EgoDriver ego_;
  std::map<std::string, Track> others_;
  std::set<std::string> ignored_;  // ids of agents that overlap the ego at t0
  RolloutOutcome outcome_;
  int steps_ = 0;
  double off_road_sum_ = 0.0;
  int road_checks_ = 0;
  bool was_on_road_ = false;
};

}  // namespace

const char* toString(PlannerFailure failure) { return wordOf(kFailureNames, failure); }

std::optional<PlannerFailure> plannerFailureFromString(const std::string& name) {
  return valueOf(kFailureNames, name);
}

bool isMoreSevere(const PlannerContact& a, const PlannerContact& b) {
  return std::pair(a.severity.worse().mais3, a.impact_speed) >
         std::pair(b.severity.worse().mais3, b.impact_speed);
}

std::unique_ptr<AttackerPolicy> makeRolloutAttacker(const CrashScenario& scenario,
                                                    const RolloutSetup& setup) {
  if (setup.attacker) return setup.attacker->clone();
  return std::make_unique<FixedAttacker>(scenario.attacker);
}

Traffic makeRolloutTraffic(const CrashScenario& scenario, const RolloutSetup& setup) {
  std::shared_ptr<BackgroundModel> model;
  if (setup.background == Background::kModel) {
    model = std::make_shared<BackgroundModel>(setup.planners.traffic_model, scenario.lanes);
  }
  return {scenario,
          makeRolloutAttacker(scenario, setup),
          setup.background,
          setup.planners.traffic,
          setup.planners.planning.history,
          std::move(model)};
}

RolloutOutcome rollout(Planner& planner, const Driving& driving, const CrashScenario& scenario,
                       const RolloutSetup& setup) {
  checkScenario(scenario);
  return Run(planner, driving, scenario, setup).run();
}

}  // namespace forge
