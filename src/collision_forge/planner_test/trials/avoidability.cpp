#include "collision_forge/planner_test/trials/avoidability.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

/// Searches for evasive motions in one scenario.
class Search {
 public:
  Search(const CrashScenario& scenario, const AvoidabilityOptions& options,
         const RouteOptions& route, const AttackOptions& attack)
      : scenario_(scenario), options_(options), drives_(scenario, options, route, attack) {
    others_.ego = attackerTrack(scenario);
    const std::set<std::string> ignored = agentsOverlappingEgoAtT0(scenario);
    for (const Track& agent : scenario.recorded.agents) {
      if (agent.id != scenario.attacker.attacker_id && ignored.count(agent.id) == 0) {
        others_.agents.push_back(agent);
      }
    }
  }

  Avoidability run() {
    Avoidability found;
    const double now = scenario_.recorded.ego.states.front().time;
    if (auto kept = keep()) {
      found.from_now.push_back(*kept);
      found.last = std::move(kept);
      return found;
    }
    for (const EvasiveManoeuvre kind : {EvasiveManoeuvre::kBraking, EvasiveManoeuvre::kAccelerating,
                                        EvasiveManoeuvre::kSteering, EvasiveManoeuvre::kBoth}) {
      if (auto avoidance = searchFrom(now, kind)) found.from_now.push_back(std::move(*avoidance));
    }
    found.last = searchLatest(now);
    if (!found.last && !found.from_now.empty()) found.last = found.from_now.front();
    return found;
  }

 private:
  /// Returns the recorded motion, extrapolated straight ahead at its end, if it has no contact.
  std::optional<Avoidance> keep() {
    const Track& ego = scenario_.recorded.ego;
    Avoidance kept{EvasiveManoeuvre::kKeeping, ego.states.front().time, {}, 0.0};
    for (const AgentState& state : ego.states) {
      if (state.time > scenario_.end() + kTimeEpsilon) break;
      kept.motion.push_back({state.time, state.pose, speedOf(state), 0.0, 0.0});
    }
    const AgentState& last = ego.states.back();
    if (last.time < scenario_.end() - kTimeEpsilon) {
      const double rest = scenario_.end() - last.time;
      kept.motion.push_back({scenario_.end(), compose(last.pose, {speedOf(last) * rest, 0.0, 0.0}),
                             speedOf(last), 0.0, 0.0});
    }
    const CollisionReport report = drives_.verify(kept.motion, others_);
    contact_time_ = report.contact ? report.contact_time : scenario_.end();
    if (!report.first_other_id.empty()) {
      contact_time_ = std::min(contact_time_, report.first_other_time);
    }
    if (report.contact || !report.first_other_id.empty()) return std::nullopt;
    kept.off_road_share = drives_.shareOff(kept.motion, report);
    return kept;
  }

  std::optional<Avoidance> searchLatest(double now) const {
    const int starts = static_cast<int>(std::floor((contact_time_ - now) / options_.interval));
    for (int i = starts; i >= 0; --i) {
      const double start = now + i * options_.interval;
      if (start >= contact_time_ - kTimeEpsilon) continue;
      if (auto avoidance = searchFrom(start, std::nullopt)) return avoidance;
    }
    return std::nullopt;
  }

  /// Returns the gentlest witness, of one kind or of any kind; one that stays on the road if there
  /// is one.
  std::optional<Avoidance> searchFrom(double start, std::optional<EvasiveManoeuvre> kind) const {
    const auto state = stateAt(scenario_.recorded.ego, start);
    if (!state) return std::nullopt;
    const Obstacles obstacles(others_, start, scenario_.end(), options_.step);
    std::optional<Avoidance> off_road;
    std::vector<TrajectoryPoint> points;
    for (const EvasivePlan& plan : drives_.plans()) {
      const EvasiveManoeuvre plan_kind = kindOf(plan);
      if (plan_kind == EvasiveManoeuvre::kKeeping || (kind && plan_kind != *kind)) continue;
      drives_.drive(*state, plan, points);
      const bool leaves_road = drives_.leavesRoad(points);
      if (leaves_road && off_road) continue;
      if (!obstacles.areClearOf(points, drives_.wideBox())) continue;
      const CollisionReport report = drives_.verify(points, others_);
      if (!EvasiveDrives::isEvasion(report)) continue;
      Avoidance avoidance{plan_kind, start, points, drives_.shareOff(points, report)};
      if (!leaves_road) return avoidance;
      off_road = std::move(avoidance);
    }
    return off_road;
  }

  const CrashScenario& scenario_;
  const AvoidabilityOptions& options_;
  EvasiveDrives drives_;
  Future others_;              // with the attacker as `ego`, for EvasiveDrives::verify()
  double contact_time_ = 0.0;  // s, first contact of the recorded ego; else the end
};

}  // namespace

const Avoidance* Avoidability::find(EvasiveManoeuvre manoeuvre) const {
  const auto found = std::find_if(from_now.begin(), from_now.end(), [=](const Avoidance& entry) {
    return entry.manoeuvre == manoeuvre;
  });
  return found == from_now.end() ? nullptr : &*found;
}

Avoidability findAvoidability(const CrashScenario& scenario, const AvoidabilityOptions& options,
                              const RouteOptions& route, const AttackOptions& attack) {
  checkScenario(scenario);
  return Search(scenario, options, route, attack).run();
}

}  // namespace forge
