#include "collision_forge/planner_test/trials/crash_scenario.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "collision_forge/base/scene/find_track.h"

namespace forge {

Track attackerTrack(const CrashScenario& scenario) {
  const AttackerTrajectory& attacker = scenario.attacker;
  const Track* seen = findTrack(scenario.snapshot.agents, attacker.attacker_id);
  return {attacker.attacker_id, seen ? seen->agent_class : attacker.agent_class, attacker.size,
          toStates(attacker.points)};
}

std::vector<Track> agentsFromT0(const CrashScenario& scenario) {
  std::vector<Track> others = {attackerTrack(scenario)};
  for (const Track& agent : scenario.recorded.agents) {
    if (agent.id != scenario.attacker.attacker_id) others.push_back(agent);
  }
  return others;
}

std::set<std::string> agentsOverlappingEgoAtT0(const CrashScenario& scenario) {
  const OrientedBox ego{scenario.recorded.ego.states.front().pose, scenario.ego.size};
  std::set<std::string> ids;
  for (const Track& agent : scenario.recorded.agents) {
    const auto state = stateAt(agent, scenario.snapshot.now);
    if (agent.id != scenario.attacker.attacker_id && state &&
        overlaps(ego, boxAt(agent, state->pose))) {
      ids.insert(agent.id);
    }
  }
  return ids;
}

void addAttackerPast(CrashScenario& scenario) {
  const AttackerTrajectory& attacker = scenario.attacker;
  if (!attacker.isAdded()) return;
  scenario.snapshot.agents.push_back(
      {attacker.attacker_id, attacker.agent_class, attacker.size, attacker.past});
}

void checkScenario(const CrashScenario& scenario) {
  constexpr double kSameTime = 1e-5;  // s; files store microseconds
  const auto& points = scenario.attacker.points;
  const double now = scenario.snapshot.now;
  const auto refuse = [&](const std::string& problem) {
    throw std::invalid_argument("attacker " + scenario.attacker.attacker_id + ": " + problem);
  };
  if (!scenario.lanes) throw std::invalid_argument("the scenario has no map");
  if (points.size() < 2) refuse("its trajectory has fewer than two points");
  if (std::abs(points.front().time - now) > kSameTime)
    refuse("its trajectory does not start at t0");
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!(points[i].time > points[i - 1].time))
      refuse("the times of its trajectory do not increase");
  }
  if (scenario.snapshot.ego.states.empty() || scenario.recorded.ego.states.empty()) {
    throw std::invalid_argument("the ego has no state at t0");
  }
  const Pose2& ego = scenario.snapshot.ego.states.back().pose;
  if (overlaps({ego, scenario.ego.size}, {points.front().pose, scenario.attacker.size})) {
    refuse("it touches the ego at t0");
  }
}

}  // namespace forge
