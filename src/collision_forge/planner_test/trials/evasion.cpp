#include "collision_forge/planner_test/trials/evasion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

/// A candidate motion, before the attacker's reaction is simulated.
struct Trial {
  EvasiveManoeuvre manoeuvre = EvasiveManoeuvre::kKeeping;
  std::vector<TrajectoryPoint> points;
  bool leaves_road = false;
  double distance = 0.0;  ///< m, mean between the middles of the ego and the attacker's plan
};

class Search {
 public:
  Search(const CrashScenario& scenario, const RolloutSetup& setup)
      : scenario_(scenario),
        setup_(setup),
        options_(setup.planners.avoidability),
        drives_(scenario, options_, setup.planners.planning.route, setup.attack),
        ignored_(agentsOverlappingEgoAtT0(scenario)) {}

  std::optional<Evasion> run(const std::vector<TrajectoryPoint>& driven) const {
    const std::vector<Traffic> moments = momentsOf(driven);
    for (auto moment = moments.rbegin(); moment != moments.rend(); ++moment) {
      const auto here = std::find_if(driven.begin(), driven.end(), [&](const auto& point) {
        return point.time > moment->time() - kTimeEpsilon;
      });
      if (auto found = searchFrom(*moment, *here)) return found;
    }
    return std::nullopt;
  }

 private:
  /// Records all agents at the start times before the contact.
  std::vector<Traffic> momentsOf(const std::vector<TrajectoryPoint>& driven) const {
    Traffic traffic = makeRolloutTraffic(scenario_, setup_);
    std::vector<Traffic> moments = {traffic};
    for (std::size_t i = 1; i + 1 < driven.size(); ++i) {
      traffic.advance(driven[i].time, egoAt(driven[i - 1]));
      const double since = driven[i].time - moments.back().time();
      if (since > options_.interval - kTimeEpsilon) moments.push_back(traffic);
    }
    return moments;
  }

  Track egoAt(const TrajectoryPoint& point) const {
    return {kEgoId, AgentClass::kCar, scenario_.ego.size, toStates({point})};
  }

  std::optional<Evasion> searchFrom(const Traffic& moment, const TrajectoryPoint& from) const {
    const AgentState state = toStates({from}).front();
    for (Trial& trial : trialsFrom(moment, state)) {
      Traffic traffic = moment;
      const auto report = drive(traffic, trial.points);
      if (!report || !EvasiveDrives::isEvasion(*report)) continue;
      return Evasion{
          {trial.manoeuvre, state.time, trial.points, drives_.shareOff(trial.points, *report)},
          traffic.attacker().trajectory()};
    }
    return std::nullopt;
  }

  /// Returns the plans that the attacker's current plan does not touch: first those that stay on
  /// the road, among them those farthest from it.
  std::vector<Trial> trialsFrom(const Traffic& moment, const AgentState& state) const {
    const Future others = expectedAt(moment);
    const Obstacles obstacles(others, state.time, scenario_.end(), options_.step);
    std::vector<Trial> trials;
    std::vector<TrajectoryPoint> points;
    for (const EvasivePlan& plan : drives_.plans()) {
      drives_.drive(state, plan, points);
      if (!obstacles.areClearOf(points, drives_.wideBox())) continue;
      trials.push_back(
          {kindOf(plan), points, drives_.leavesRoad(points), distanceTo(others.ego, points)});
    }
    std::stable_sort(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
      if (a.leaves_road != b.leaves_road) return b.leaves_road;
      return a.distance > b.distance;
    });
    const auto tries = static_cast<std::size_t>(options_.tries);
    if (trials.size() > tries) trials.resize(tries);
    return trials;
  }

  /// Returns the attacker (as `ego`) on its plan and the other agents as recorded.
  Future expectedAt(const Traffic& moment) const {
    Future others;
    const AttackerTrajectory& attacker = moment.attacker().trajectory();
    others.ego = {attacker.attacker_id, attacker.agent_class, attacker.size,
                  toStates(attacker.points)};
    for (const Track& agent : scenario_.recorded.agents) {
      if (agent.id != attacker.attacker_id && ignored_.count(agent.id) == 0) {
        others.agents.push_back(agent);
      }
    }
    return others;
  }

  /// Mean over the points.
  static double distanceTo(const Track& attacker, const std::vector<TrajectoryPoint>& points) {
    double sum = 0.0;
    int count = 0;
    for (const TrajectoryPoint& point : points) {
      const auto state = stateAt(attacker, point.time);
      if (!state) continue;
      sum += (state->pose.position() - point.pose.position()).norm();
      ++count;
    }
    return count > 0 ? sum / count : std::numeric_limits<double>::infinity();
  }

  /// Simulates the motion in closed loop; empty if it touches an agent.
  std::optional<CollisionReport> drive(Traffic& traffic,
                                       const std::vector<TrajectoryPoint>& points) const {
    std::map<std::string, Track> met;
    const auto look = [&] {
      for (const Track& agent : traffic.agents()) {
        if (ignored_.count(agent.id) > 0) continue;
        Track& track =
            met.try_emplace(agent.id,
                            Track{agent.id, agent.agent_class, agent.size, {}, agent.height})
                .first->second;
        track.states.push_back(agent.states.back());
      }
    };
    look();
    for (std::size_t i = 1; i < points.size(); ++i) {
      traffic.advance(points[i].time, egoAt(points[i - 1]));
      look();
      const OrientedBox ego{points[i].pose, scenario_.ego.size};
      for (const auto& [id, track] : met) {
        const AgentState& state = track.states.back();
        if (state.time < points[i].time - kTimeEpsilon) continue;
        if (overlaps(ego, boxAt(track, state.pose))) return std::nullopt;
      }
    }
    Future others;
    for (auto& [id, track] : met) {
      if (id == scenario_.attacker.attacker_id) {
        others.ego = std::move(track);
      } else {
        others.agents.push_back(std::move(track));
      }
    }
    return drives_.verify(points, others);
  }

  const CrashScenario& scenario_;
  const RolloutSetup& setup_;
  const AvoidabilityOptions& options_;
  EvasiveDrives drives_;
  std::set<std::string> ignored_;  // ids of agents that overlap the ego at t0
};

}  // namespace

std::optional<Evasion> findEvasion(const CrashScenario& scenario,
                                   const std::vector<TrajectoryPoint>& driven,
                                   const RolloutSetup& setup) {
  checkScenario(scenario);
  return Search(scenario, setup).run(driven);
}

std::vector<TrajectoryPoint> wholeEvasion(const std::vector<TrajectoryPoint>& driven,
                                          const Avoidance& evasion) {
  std::vector<TrajectoryPoint> whole;
  for (const TrajectoryPoint& point : driven) {
    if (point.time < evasion.start - kTimeEpsilon) whole.push_back(point);
  }
  whole.insert(whole.end(), evasion.motion.begin(), evasion.motion.end());
  return whole;
}

}  // namespace forge
