#include "collision_forge/planner_test/trials/step_metrics.h"

#include <cmath>

#include "collision_forge/base/geometry/swept_contact.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/planner_test/statistics/csv_text.h"

namespace forge {
namespace {

constexpr double kLaneRadius = 0.5 * kLaneWidth;  // m from the centreline of the ego's lane
constexpr double kLaneHeading = M_PI_4;           // rad between the ego and its lane

/// Returns the motion over kTtcHorizon at a constant velocity.
BoxMotion steadyMotion(const AgentState& state, const BoxSize& size) {
  const Vector2 end = state.pose.position() + kTtcHorizon * state.velocity;
  return {state.pose, {end.x(), end.y(), state.pose.yaw}, size};
}

/// Sets the measures that need the step before.
void addChanges(const TrajectoryPoint& before, StepMetrics& step) {
  const double duration = step.point.time - before.time;
  if (!(duration > 0.0)) return;
  step.jerk = (step.point.acceleration - before.acceleration) / duration;
  const double yaw_rate = angleBetween(before.pose.yaw, step.point.pose.yaw) / duration;
  step.lateral_acceleration = step.point.speed * yaw_rate;
}

/// Sets the measures of gaps. `agents`: the attacker first.
void addGaps(const std::vector<Track>& agents, const BoxSize& ego, StepMetrics& step) {
  for (const Track& agent : agents) {
    const bool is_attacker = &agent == &agents.front();
    if (!is_attacker && agent.id == agents.front().id) continue;
    const auto state = stateAt(agent, step.point.time);
    if (!state) continue;
    const double gap = distance({step.point.pose, ego}, boxAt(agent, state->pose));
    if (!step.nearest_gap || gap < *step.nearest_gap) {
      step.nearest = agent.id;
      step.nearest_gap = gap;
    }
    if (!is_attacker) continue;
    step.attacker_gap = gap;
    const auto share = firstContact(steadyMotion(toStates({step.point}).front(), ego),
                                    steadyMotion(*state, agent.size));
    if (share) step.attacker_ttc = *share * kTtcHorizon;
  }
}

std::string csvNumber(const std::optional<double>& value) {
  return value ? formatted("%.3f,", *value) : ",";
}

std::string csvStep(const StepMetrics& step, double now) {
  const TrajectoryPoint& point = step.point;
  return formatted("%.3f,%.3f,%.3f,%.5f,%.3f,%.3f,", point.time - now, point.pose.x, point.pose.y,
                   point.pose.yaw, point.speed, point.acceleration) +
         csvNumber(step.jerk) + csvNumber(step.lateral_acceleration) +
         csvNumber(step.attacker_gap) + csvNumber(step.attacker_ttc) + csvText(step.nearest) + ',' +
         csvNumber(step.nearest_gap) + csvText(step.lane) + ',' +
         (step.on_road ? (*step.on_road ? "1" : "0") : "");
}

}  // namespace

std::vector<StepMetrics> stepMetrics(const CrashScenario& scenario, const PlannerRow& row) {
  const AttackerTrajectory& attacker = scenario.attacker;
  std::vector<Track> agents = {{attacker.attacker_id, attacker.agent_class, attacker.size,
                                toStates(row.outcome.attacker.points)}};
  const bool replays = row.background == Background::kReplay;
  const auto& others = replays ? scenario.recorded.agents : row.outcome.others;
  agents.insert(agents.end(), others.begin(), others.end());
  std::vector<StepMetrics> steps;
  for (const TrajectoryPoint& point : row.outcome.driven) {
    StepMetrics step;
    step.point = point;
    if (!steps.empty()) addChanges(steps.back().point, step);
    addGaps(agents, scenario.ego.size, step);
    const auto lanes = scenario.lanes->lanesNear(point.pose, kLaneRadius, kLaneHeading);
    if (!lanes.empty()) step.lane = scenario.lanes->map().lanes[lanes.front().lane].id;
    const auto off = scenario.lanes->offRoadShare({point.pose, scenario.ego.size});
    if (off) step.on_road = *off <= 0.0;
    steps.push_back(step);
  }
  return steps;
}

std::string stepsCsv(const PlannerCase& one, const PlannerTestResult& result) {
  std::string text =
      "case,planner,policy,background,t,x,y,yaw,speed,acceleration,jerk,lateral_acceleration,"
      "attacker_gap,attacker_ttc,nearest,nearest_gap,lane,on_road\n";
  for (const PlannerRow& row : result.rows) {
    const std::string start = csvText(result.name) + ',' + row.planner + ',' +
                              toString(row.attacker.policy) + ',' + toString(row.background) + ',';
    for (const StepMetrics& step : stepMetrics(one.scenario, row)) {
      text += start + csvStep(step, result.now) + '\n';
    }
  }
  return text;
}

}  // namespace forge
