#include "collision_forge/planner_test/trials/attacker_stress.h"

#include <limits>
#include <vector>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/policy/adaptive_attacker.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/geometry/enum_words.h"
#include "collision_forge/base/scene/clock.h"
#include "collision_forge/planner_test/trials/evasive_drives.h"

namespace forge {
namespace {

constexpr EnumWord<EgoConduct> kConductWords[] = {
    {EgoConduct::kEvades, "evades"},     {EgoConduct::kStops, "stops"},
    {EgoConduct::kReverses, "reverses"}, {EgoConduct::kJumps, "jumps"},
    {EgoConduct::kVanishes, "vanishes"},
};

constexpr double kJump = 30.0;         // m ahead
constexpr double kReverseSpeed = 3.0;  // m/s
constexpr double kLatestStart = 0.9;   // share of the requested TTA
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Returns the recorded state at `time`; extrapolates straight ahead after the recording's end.
AgentState recordedAt(const Track& ego, double time) {
  if (const auto state = stateAt(ego, time)) return *state;
  AgentState last = ego.states.back();
  const double way = last.velocity.dot(last.pose.heading()) * (time - last.time);
  last.pose = compose(last.pose, {way, 0.0, 0.0});
  last.time = time;
  return last;
}

/// Returns the state of an ego that performs the disturbance since it was at `from`.
AgentState confusing(EgoConduct conduct, const AgentState& from, double time) {
  AgentState state = from;
  state.time = time;
  const double since = time - from.time;
  const double speed = from.velocity.dot(from.pose.heading());
  switch (conduct) {
    case EgoConduct::kEvades:
      break;
    case EgoConduct::kStops:
      state.velocity = Vector2::Zero();
      break;
    case EgoConduct::kReverses:
      state.pose = compose(from.pose, {-kReverseSpeed * since, 0.0, 0.0});
      break;
    case EgoConduct::kJumps:
      state.pose = compose(from.pose, {kJump + speed * since, 0.0, 0.0});
      break;
    case EgoConduct::kVanishes:
      state.pose = {kUnknown, kUnknown, kUnknown};
      break;
  }
  return state;
}

/// Returns the ego's motion at every step from t0 to the scenario's end.
Track egoOf(const CrashScenario& scenario, double tta, EgoConduct conduct, std::uint64_t seed,
            const RolloutSetup& setup) {
  const double step = setup.planners.rollout.step;
  const double now = scenario.snapshot.now;
  Random random(seed);
  const double start = now + random.uniform(step, kLatestStart * tta);
  Track ego{kEgoId, AgentClass::kCar, scenario.ego.size, {}};
  double time = now;
  for (; time < start - kTimeEpsilon; time += step) {
    ego.states.push_back(recordedAt(scenario.recorded.ego, time));
  }
  const AgentState from = recordedAt(scenario.recorded.ego, time);
  if (conduct == EgoConduct::kEvades) {
    const EvasiveDrives drives(scenario, setup.planners.avoidability, setup.planners.planning.route,
                               setup.attack);
    std::vector<TrajectoryPoint> points;
    drives.drive(from, drives.plans()[random.index(drives.plans().size())], points);
    for (const AgentState& state : toStates(points)) ego.states.push_back(state);
    return ego;
  }
  for (; time < scenario.end() - kTimeEpsilon; time += step) {
    ego.states.push_back(confusing(conduct, from, time));
  }
  return ego;
}

}  // namespace

const char* toString(EgoConduct conduct) { return wordOf(kConductWords, conduct); }

StressOutcome stressAttacker(const CrashScenario& scenario, const CollisionRequest& asked,
                             EgoConduct conduct, std::uint64_t seed, const RolloutSetup& setup) {
  checkScenario(scenario);
  CollisionRequest request = asked;
  if (setup.attacker) request.crash.limits = kAdaptiveLimits;
  const Track ego = egoOf(scenario, request.tta, conduct, seed, setup);
  Traffic traffic(scenario, makeRolloutAttacker(scenario, setup), setup.background,
                  setup.planners.traffic, setup.planners.planning.history);
  Future driven = scenario.recorded;
  driven.ego.states.clear();
  for (std::size_t i = 0; i < ego.states.size(); ++i) {
    const AgentState& state = ego.states[i];
    if (state.pose.isFinite()) driven.ego.states.push_back(state);
    if (i + 1 < ego.states.size()) {
      traffic.advance(ego.states[i + 1].time, {ego.id, ego.agent_class, ego.size, {state}});
    }
  }
  const AttackerTrajectory& trajectory = traffic.attacker().trajectory();
  const auto verified = [&] {
    return verifyDrive(trajectory, {scenario.snapshot, driven, request, *scenario.lanes},
                       setup.attack.verification);
  };
  const bool touches_ego = verified().contact;
  driven.ego.states.resize(1);  // without a contact, the limits are checked over the whole motion
  const CollisionReport whole = verified();
  return {whole.broken_limit, whole.first_other_id, touches_ego, traffic.attacker().phase()};
}

}  // namespace forge
