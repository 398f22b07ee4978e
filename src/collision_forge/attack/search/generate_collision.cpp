#include "collision_forge/attack/search/generate_collision.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/attack/drivers/careful_drive.h"
#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/alternatives.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/scene/support_vehicles.h"

namespace forge {
namespace {

constexpr double kGreatestScore = 1.0;  // full confidence without effort

void addCarefulDrives(Future recorded, Attack& attack) {
  addSupports(attack.supports, recorded);
  attack.report.careful_drivers = driveCarefully(recorded, attack.trajectory);
}

/// Returns the moment with the adults who run at t0 as runners: logs have no such class.
Moment withRunners(Moment moment) {
  // m/s, own choice; 99 % of recorded walkers are slower than 1.72.
  constexpr double kRunning = 2.0;
  std::set<std::string> runners;
  for (const Track& agent : moment.snapshot.agents) {
    const bool runs = agent.agent_class == AgentClass::kPedestrian &&
                      endsAt(agent, moment.snapshot.now) &&
                      agent.states.back().velocity.norm() >= kRunning;
    if (runs) runners.insert(agent.id);
  }
  const auto reclassify = [&](std::vector<Track>& agents) {
    for (Track& agent : agents) {
      if (runners.count(agent.id) > 0) agent.agent_class = AgentClass::kRunner;
    }
  };
  if (runners.empty()) return moment;
  reclassify(moment.snapshot.agents);
  if (moment.recorded) reclassify(moment.recorded->agents);
  if (moment.past) {
    Snapshot past = *moment.past;
    reclassify(past.agents);
    moment.past = std::make_shared<Snapshot>(std::move(past));
  }
  return moment;
}

/// Returns the rejection of a request for any type from the rejections of all types.
Attack refusalOfAll(const std::vector<std::pair<CollisionType, Status>>& refusals) {
  Status status = refusals.front().second;
  const auto has_code = [&](const auto& refusal) { return refusal.second.code == status.code; };
  if (!std::all_of(refusals.begin(), refusals.end(), has_code)) {
    status.code = StatusCode::kNoAttackWithinLimits;
  }
  status.message = "no type of collision is possible";
  for (const auto& [type, refusal] : refusals) {
    status.message += (&refusal == &refusals.front().second ? ": " : ", ") +
                      std::string(toString(type)) + " " + toString(refusal.code);
  }
  return rejection(status);
}

/// Returns the best attack over all types that the other fields of the request allow.
Attack generateAny(const AttackMethod& method, const Moment& moment,
                   const CollisionRequest& request, const PredictionOptions& options) {
  std::vector<CollisionType> types = typesMeant(CollisionType::kAny);
  Random random(request.seed);
  for (std::size_t i = types.size(); i > 1; --i) std::swap(types[i - 1], types[random.index(i)]);
  std::optional<Attack> best;
  std::vector<std::pair<CollisionType, Status>> refusals;
  CollisionRequest one = request;
  Status contradiction;
  for (const CollisionType type : types) {
    one.type = type;
    const Status controls = checkControls(one);
    if (controls.code != StatusCode::kOk) {
      contradiction = controls;
      continue;
    }
    Attack found = generateOne(method, moment, one, options);
    if (found.status.code != StatusCode::kOk) {
      if (!dependsOnScene(found.status.code)) return found;
      refusals.emplace_back(type, found.status);
      continue;
    }
    found.pattern.type = type;
    if (!best || scoreOf(found) > scoreOf(*best)) best = std::move(found);
    if (scoreOf(*best) >= kGreatestScore) break;
  }
  if (best) return *best;
  return refusals.empty() ? rejection(contradiction) : refusalOfAll(refusals);
}

Attack generateAt(const AttackMethod& method, const Moment& moment, const CollisionRequest& asked,
                  const PredictionOptions& options) {
  const bool is_any = asked.type == CollisionType::kAny;
  Attack answer = is_any ? generateAny(method, moment, asked, options)
                         : generateOne(method, moment, asked, options);
  const CollisionRequest request = is_any ? withTypeOf(asked, answer) : asked;
  if (answer.status.code == StatusCode::kOk && request.alternatives > 1) {
    answer.alternatives =
        findAlternatives(answer, method, moment, withFullId(request, moment.snapshot), options);
  }
  // Only in replay mode the attack is one on the recorded ego.
  if (answer.status.code == StatusCode::kOk && request.mode == Mode::kReplay && moment.recorded) {
    addCarefulDrives(*moment.recorded, answer);
    for (Attack& other : answer.alternatives) addCarefulDrives(*moment.recorded, other);
  }
  return answer;
}

}  // namespace

CollisionRequest withTypeOf(CollisionRequest request, const Attack& attack) {
  const bool is_found = attack.status.code == StatusCode::kOk;
  if (is_found && request.type == CollisionType::kAny) request.type = attack.pattern.type;
  return request;
}

Attack generateCollision(const AttackMethod& method, const Moment& moment,
                         const CollisionRequest& asked, const PredictionOptions& options) {
  return asked.attacker_class == AgentClass::kRunner
             ? generateAt(method, withRunners(moment), asked, options)
             : generateAt(method, moment, asked, options);
}

}  // namespace forge
