#include "collision_forge/attack/policy/adaptive_attacker.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/policy/normal_driver.h"
#include "collision_forge/attack/search/manoeuvre_search.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/attack/verify/drive_check.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

// The budget of a new plan in one update step:
constexpr int kWays = 3;  // the path of the present plan first
constexpr int kRounds = 2;
constexpr int kPerturbations = 12;
constexpr double kMinGain = 0.05;    // of the search's objective: a new plan must be better by this
constexpr double kMinHope = 0.02;    // closeness (0 to 1) of a plan that hits no future; with less
                                     // the attack is aborted
constexpr double kOwnSpacing = 1.0;  // m between the points of the planned path
constexpr double kOwnBeyond = 40.0;  // m by which the planned path continues straight

AttackOptions optionsOfPlans(AttackOptions options, double aggressiveness) {
  options.route.ways = kWays;
  options.route.rounds = kRounds;
  options.route.perturbations = kPerturbations;
  for (DriveLimits& limits : options.verification.drivable.rows) {
    limits.max_braking *= aggressiveness;
    limits.max_forward_acceleration *= aggressiveness;
    limits.max_lateral_acceleration *= aggressiveness;
    limits.max_jerk *= aggressiveness;
    limits.max_steering_rate *= aggressiveness;
  }
  return options;
}

/// Resamples the points every `step` s up to `end`; extended straight beyond their end.
std::vector<TrajectoryPoint> spread(const std::vector<TrajectoryPoint>& points, double step,
                                    double end) {
  const AttackerTrajectory whole{"", AgentClass::kCar, {}, points};
  const TrajectoryPoint& last = points.back();
  const auto steps = static_cast<std::size_t>(std::lround((end - points.front().time) / step)) + 1;
  std::vector<TrajectoryPoint> found;
  auto next = points.begin();
  for (std::size_t i = 0; i < steps; ++i) {
    const double time = points.front().time + static_cast<double>(i) * step;
    while (next != points.end() && next->time < time - kTimeEpsilon) ++next;
    TrajectoryPoint point = next == points.end() ? last : *next;
    if (next == points.end()) {
      point = {time, compose(last.pose, {(time - last.time) * last.speed, 0.0, 0.0}), last.speed,
               0.0, 0.0};
    } else if (std::abs(next->time - time) > kTimeEpsilon) {
      point.pose = poseAt(whole, time);
    }
    point.time = time;
    found.push_back(point);
  }
  return found;
}

std::string shareText(double share) {
  char text[64];
  std::snprintf(text, sizeof(text), "new plan hits the ego in %.0f %% of its predicted futures",
                100.0 * share);
  return text;
}

}  // namespace

AdaptiveAttacker::AdaptiveAttacker(AttackerTask task, AttackerSetup setup)
    : task_(std::move(task)),
      setup_(std::move(setup)),
      planning_(optionsOfPlans(setup_.attack, setup_.adaptive.fairness.aggressiveness)),
      vehicle_{task_.plan.attacker_id, task_.plan.agent_class, task_.plan.size, {}},
      limits_(driveLimitsOf(vehicle_, setup_.attack.verification)),
      scene_(setup_.attack.prediction.history_frames, task_.ego, task_.snapshot),
      impact_(task_.snapshot.now + task_.request.tta),
      last_update_(task_.snapshot.now),
      last_ego_(task_.snapshot.now),
      seen_ego_{task_.snapshot.ego.states.back()} {
  task_.request.attacker = vehicle_.id;
  task_.request.crash.min_confidence = 0.0;
  task_.request.crash.limits = kAdaptiveLimits;
  const double end = std::max(impact_ + setup_.attack.search.tail, task_.plan.points.back().time);
  task_.plan.points = spread(task_.plan.points, setup_.attack.search.step, end);
  plans_.push_back(firstPlan(task_.plan, phase_));
}

std::size_t AdaptiveAttacker::firstAfter(double time) const {
  const auto& points = task_.plan.points;
  const auto found = std::find_if(points.begin(), points.end(), [=](const TrajectoryPoint& point) {
    return point.time > time - kTimeEpsilon;
  });
  return static_cast<std::size_t>(found - points.begin());
}

bool AdaptiveAttacker::hasJumped(const Frame& seen) const {
  const AgentState& before = seen_ego_.back();
  const double way = (seen.ego.position() - before.pose.position()).norm();
  return way > setup_.adaptive.max_ego_speed * (seen.time - before.time);
}

void AdaptiveAttacker::observe(const Frame& seen) {
  const AdaptiveOptions& options = setup_.adaptive;
  if (seen.time < last_update_ + options.period - kTimeEpsilon) return;
  const std::size_t from = firstAfter(seen.time + options.fairness.reaction_time);
  if (from + 1 >= task_.plan.points.size()) return;
  const bool is_there = seen.ego.isFinite();
  const bool has_jumped = is_there && hasJumped(seen);
  last_update_ = seen.time;
  if (is_there) last_ego_ = seen.time;
  if (is_there || !seen.agents.empty()) {
    Frame kept = seen;
    if (!is_there) kept.ego = scene_.newest().ego;  // other agents are still observed
    scene_.add(kept);
  }
  if (phase_ == AttackerPhase::kDrivingOn) {
    driveOnFrom(seen.time, from, "");
  } else if (has_jumped) {
    abortAttack(seen.time, from, "the ego jumped");
  } else if (seen.time - last_ego_ > options.lost_after) {
    abortAttack(seen.time, from, "the ego is no longer observed");
  } else if (seen.time > impact_ + task_.request.crash.time_tolerance) {
    abortAttack(seen.time, from, "the requested time has passed");
  } else if (timeOf(from) + options.commit_time < impact_ + task_.request.crash.time_tolerance) {
    if (is_there) replan(seen, from);
  } else if (phase_ == AttackerPhase::kAttacking) {
    phase_ = AttackerPhase::kCommitted;
    plans_.push_back({seen.time, timeOf(from), phase_, "too late to replan", {}});
  }
  if (is_there) seen_ego_.push_back({seen.time, seen.ego, Vector2::Zero()});
}

Future AdaptiveAttacker::outlook() const {
  Future future = predict(scene_.snapshot());
  std::vector<AgentState> ego = seen_ego_;
  for (const AgentState& state : future.ego.states) {
    if (state.time > ego.back().time + kTimeEpsilon) ego.push_back(state);
  }
  future.ego.states = std::move(ego);
  deriveVelocities(future.ego);
  return future;
}

Future AdaptiveAttacker::predict(const Snapshot& snapshot) const {
  const double end = task_.plan.points.back().time - snapshot.now;
  // The plan may end less than a step from now.
  const double central = std::min(std::max(impact_ - snapshot.now, kPredictionStep), end);
  return predictWithEgoSamples(snapshot, *task_.lanes, *setup_.ego_futures, end, central,
                               setup_.adaptive.ego_samples, task_.request.seed);
}

/// Returns the snapshot with the attacker at point `from` of its plan, whose time becomes t0.
Snapshot AdaptiveAttacker::asOf(std::size_t from, Snapshot snapshot) const {
  const TrajectoryPoint& point = task_.plan.points[from];
  snapshot.now = point.time;
  Track vehicle = vehicle_;
  vehicle.states.push_back({point.time, point.pose, point.speed * point.pose.heading()});
  const auto known = std::find_if(snapshot.agents.begin(), snapshot.agents.end(),
                                  [&](const Track& agent) { return agent.id == vehicle_.id; });
  if (known != snapshot.agents.end()) {
    *known = std::move(vehicle);
  } else {
    snapshot.agents.push_back(std::move(vehicle));
  }
  return snapshot;
}

/// Returns the path of the current plan, extended straight.
ReferencePath AdaptiveAttacker::ownWay() const {
  const auto& points = task_.plan.points;
  std::vector<Vector2> way = {points.front().pose.position()};
  for (const TrajectoryPoint& point : points) {
    if ((point.pose.position() - way.back()).norm() >= kOwnSpacing) {
      way.push_back(point.pose.position());
    }
  }
  const Vector2 heading = points.back().pose.heading();
  way.push_back(points.back().pose.position() + kOwnBeyond * heading);
  return ReferencePath(Polyline(way));
}

/// Returns the driven and planned motion as of point `from` of the plan.
Underway AdaptiveAttacker::underwayFrom(std::size_t from) const {
  const auto& points = task_.plan.points;
  const auto now = points.begin() + static_cast<std::ptrdiff_t>(from);
  Underway underway{task_.snapshot,        seen_ego_,           driveStateOf(*now, limits_),
                    {points.begin(), now}, {now, points.end()}, drafted_ ? drafted_->way : ownWay(),
                    std::nullopt};
  underway.effort = task_.effort;
  if (drafted_) {
    underway.draft = drafted_->draft;
    underway.style = drafted_->style;
    underway.draft->contact -= now->time;
    if (underway.draft->wait > 0.0) {
      underway.draft->wait = std::max(0.0, underway.draft->wait - now->time);
    }
  }
  return underway;
}

void AdaptiveAttacker::replan(const Frame& seen, std::size_t from) {
  const Snapshot known = scene_.snapshot();
  const Future future = predict(known);
  std::vector<const Track*> egos;
  for (const Track& ego : future.ego_samples) egos.push_back(&ego);
  if (egos.empty()) egos.push_back(&future.ego);
  const Snapshot snapshot = asOf(from, known);
  CollisionRequest request = task_.request;
  request.tta = impact_ - snapshot.now;
  CollisionPattern pattern = task_.pattern;
  pattern.time = impact_;
  pattern.ego = {stateAt(future.ego, impact_).value_or(future.ego.states.back()).pose,
                 task_.ego.size};
  const std::vector<CollisionPattern> patterns = {pattern};
  const Underway underway = underwayFrom(from);
  SearchInput input{snapshot, future, egos, patterns, request, *task_.lanes};
  input.underway = &underway;
  const std::vector<FoundAttack> found = searchManoeuvres(input, planning_);
  if (found.empty()) return;
  const auto present = std::prev(found.end());
  const auto better = std::find_if(found.begin(), present, [&](const FoundAttack& attack) {
    return attack.objective > present->objective + kMinGain &&
           isBelievable(from, attack.points, snapshot.now + attack.drafted->draft.contact);
  });
  if (better != present) {
    drafted_ = better->drafted;
    drafted_->draft.contact += snapshot.now;
    if (drafted_->draft.wait > 0.0) drafted_->draft.wait += snapshot.now;
    take(seen.time, from, better->points, shareText(better->score.share));
  } else if (present->score.share == 0.0 && present->score.closeness < kMinHope) {
    abortAttack(seen.time, from, "no plan comes close to the requested crash");
    return;
  }
  if (better->score.share == 0.0 && touchesOthers(future, from)) {
    abortAttack(seen.time, from, "another agent blocks the plan");
  }
}

/// Checks the motion driven up to point `from` of the plan, followed by `points`.
bool AdaptiveAttacker::isBelievable(std::size_t from, const std::vector<TrajectoryPoint>& points,
                                    double contact) const {
  if (!task_.request.crash.believable) return true;
  const BelievabilityOptions& options = setup_.attack.verification.believability;
  const LaneIndex& lanes = drivenLanes(task_.request, *task_.lanes);
  std::vector<TrajectoryPoint> whole(task_.plan.points.begin(),
                                     task_.plan.points.begin() + static_cast<std::ptrdiff_t>(from));
  whole.insert(whole.end(), points.begin(), points.end());
  const RoadUse road = roadUseOfAttack(whole, vehicle_.size, contact, lanes, options);
  return implausibilityOf(road, whole, vehicle_.size, contact, lanes, options).empty();
}

/// Returns true if the plan hits another agent within options.evade_time from point `from` on.
bool AdaptiveAttacker::touchesOthers(const Future& future, std::size_t from) const {
  const auto& points = task_.plan.points;
  const auto steps =
      static_cast<std::size_t>(std::lround(setup_.adaptive.evade_time / setup_.attack.search.step));
  const std::vector<TrajectoryPoint> next(
      points.begin() + static_cast<std::ptrdiff_t>(from),
      points.begin() + static_cast<std::ptrdiff_t>(std::min(from + steps, points.size())));
  std::vector<const Track*> others;
  for (const Track& agent : future.agents) {
    if (agent.id != vehicle_.id) others.push_back(&agent);
  }
  return firstTouch(next, vehicle_.size, others).has_value();
}

void AdaptiveAttacker::abortAttack(double seen, std::size_t from, const std::string& reason) {
  phase_ = AttackerPhase::kDrivingOn;
  driveOnFrom(seen, from, reason);
}

void AdaptiveAttacker::driveOnFrom(double seen, std::size_t from, const std::string& reason) {
  Future future = predict(scene_.snapshot());
  if (last_ego_ < seen - kTimeEpsilon) future.ego.states.clear();  // unknown position
  const auto& points = task_.plan.points;
  const DriveState state = driveStateOf(points[from], limits_);
  take(seen, from,
       driveOn({vehicle_, state, points[from].time, points.size() - from, future, *task_.lanes},
               setup_.attack),
       reason);
}

void AdaptiveAttacker::take(double seen, std::size_t from, std::vector<TrajectoryPoint> points,
                            const std::string& reason) {
  auto& plan = task_.plan.points;
  points.resize(std::min(points.size(), plan.size() - from));
  plan.resize(from);
  plan.insert(plan.end(), points.begin(), points.end());
  if (reason.empty()) return;
  plans_.push_back({seen, points.front().time, phase_, reason, std::move(points)});
}

}  // namespace forge
