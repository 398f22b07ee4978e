#include "collision_forge/attack/search/alternatives.h"

#include <algorithm>
#include <utility>

#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/scene/request_words.h"

namespace forge {
namespace {

/// Returns the side of the ego at which an attacker stands at t0.
Side sideNow(const AttackerTrajectory& attacker, const Snapshot& snapshot) {
  return touchedSide({snapshot.ego.states.back().pose, snapshot.ego.size},
                     {attacker.points.front().pose, attacker.size});
}

bool isSameAttacker(const AttackerTrajectory& a, const AttackerTrajectory& b,
                    const Snapshot& snapshot) {
  if (a.isAdded() != b.isAdded()) return false;
  if (!a.isAdded()) return a.attacker_id == b.attacker_id;
  return a.agent_class == b.agent_class && sideNow(a, snapshot) == sideNow(b, snapshot);
}

/// Returns the ids of the candidate attackers, nearest first.
std::vector<std::string> candidatesIn(const Snapshot& snapshot, const CollisionRequest& request,
                                      const PredictionOptions& options) {
  const Vector2 ego = snapshot.ego.states.back().pose.position();
  std::vector<std::pair<double, std::string>> found;
  for (const Track& agent : snapshot.agents) {
    if (!isCandidate(agent, snapshot, options, request.attacker_class)) continue;
    if (request.attacker_class.value_or(agent.agent_class) != agent.agent_class) continue;
    found.emplace_back((agent.states.back().pose.position() - ego).norm(), agent.id);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> ids;
  for (auto& [distance, id] : found) ids.push_back(std::move(id));
  return ids;
}

/// Returns the request with one additional constraint each, in the order in which they are tried.
std::vector<CollisionRequest> furtherRequests(const Attack& first, const Snapshot& snapshot,
                                              const CollisionRequest& request,
                                              const PredictionOptions& options) {
  CollisionRequest plain = request;
  plain.alternatives = 1;
  std::vector<CollisionRequest> further;
  for (const Manoeuvre manoeuvre : manoeuvresOf(request.type, request.turning)) {
    if (request.manoeuvre) break;
    if (manoeuvre == first.report.manoeuvre) continue;
    // These are plausible only if they are requested.
    if (request.crash.believable && manoeuvre == Manoeuvre::kWrongWay) continue;
    if (manoeuvre == Manoeuvre::kBackOut) continue;
    further.push_back(plain);
    further.back().manoeuvre = manoeuvre;
  }
  if (request.attacker) return further;
  if (request.choice != AttackerChoice::kNew) {
    for (const std::string& id : candidatesIn(snapshot, request, options)) {
      if (id == first.trajectory.attacker_id) continue;
      further.push_back(plain);
      further.back().attacker = id;
    }
  }
  if (request.choice != AttackerChoice::kExisting) {
    for (const AgentClass agent_class : kAttackerClasses) {
      if (request.attacker_class.value_or(agent_class) != agent_class) continue;
      if (!request.attacker_class && !isMotorVehicle(agent_class)) continue;
      further.push_back(plain);
      further.back().choice = AttackerChoice::kNew;
      further.back().attacker_class = agent_class;
    }
  }
  return further;
}

/// Gives an added vehicle an id that no other attacker in `others` has: methods number added
/// vehicles per result.
void giveOwnId(Attack& answer, const std::vector<Attack>& others, const Snapshot& snapshot) {
  AttackerTrajectory& attacker = answer.trajectory;
  if (!attacker.isAdded()) return;
  const std::string id = attacker.attacker_id;
  const auto has_id = [&](const Attack& other) {
    return other.trajectory.attacker_id == attacker.attacker_id &&
           !isSameAttacker(other.trajectory, attacker, snapshot);
  };
  for (int number = 2; std::any_of(others.begin(), others.end(), has_id); ++number) {
    attacker.attacker_id = id + "-" + std::to_string(number);
  }
  answer.pattern.attacker_id = attacker.attacker_id;
}

}  // namespace

bool areDistinct(const Attack& a, const Attack& b, const Snapshot& snapshot) {
  return a.report.manoeuvre != b.report.manoeuvre ||
         !isSameAttacker(a.trajectory, b.trajectory, snapshot);
}

std::vector<Attack> findAlternatives(const Attack& first, const AttackMethod& method,
                                     const Moment& moment, const CollisionRequest& request,
                                     const PredictionOptions& options) {
  const Snapshot& snapshot = moment.snapshot;
  std::vector<Attack> found = {first};
  for (const CollisionRequest& asked : furtherRequests(first, snapshot, request, options)) {
    if (static_cast<int>(found.size()) >= request.alternatives) break;
    Attack answer = generateOne(method, moment, asked, options);
    if (answer.status.code != StatusCode::kOk) continue;
    const bool is_new = std::all_of(found.begin(), found.end(), [&](const Attack& other) {
      return areDistinct(answer, other, snapshot);
    });
    if (!is_new) continue;
    giveOwnId(answer, found, snapshot);
    found.push_back(std::move(answer));
  }
  found.erase(found.begin());
  std::stable_sort(found.begin(), found.end(), [](const Attack& a, const Attack& b) {
    return a.report.confidence > b.report.confidence;
  });
  return found;
}

Attack attackOf(Attack answer, std::size_t number) {
  if (answer.status.code != StatusCode::kOk) return answer;
  std::vector<Attack> others = std::move(answer.alternatives);
  answer.alternatives.clear();
  if (number == 1) return answer;
  if (number >= 2 && number - 2 < others.size()) return others[number - 2];
  return rejection({StatusCode::kNoAttackWithinLimits,
                    "alternative = " + std::to_string(number) + ": there are only " +
                        std::to_string(others.size() + 1) + " distinct attacks"});
}

}  // namespace forge
