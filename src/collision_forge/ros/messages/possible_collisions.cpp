#include "collision_forge/ros/messages/possible_collisions.h"

#include <algorithm>
#include <map>

#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/report_text.h"

namespace forge {
namespace {

/// Returns the named types; without names the manoeuvre's type, without a manoeuvre all types.
std::variant<std::vector<CollisionType>, Status> typesNamed(const std::vector<std::string>& names,
                                                            const std::string& manoeuvre) {
  std::vector<CollisionType> types;
  for (const std::string& name : names) {
    const auto type = collisionTypeFromString(name);
    if (!type) {
      return Status{StatusCode::kUnknownType,
                    "collision_types: \"" + name + "\" is not a collision type"};
    }
    for (const CollisionType meant : typesMeant(*type)) types.push_back(meant);
  }
  if (!types.empty()) return types;
  if (const auto known = manoeuvreFromString(manoeuvre)) return std::vector{typeOf(*known)};
  types.assign(std::begin(kCollisionTypes), std::end(kCollisionTypes));
  return types;
}

collision_forge::PossibleCollision inShort(const collision_forge::CollisionAnswer& answer,
                                           const collision_forge::Attack& attack,
                                           std::uint32_t number) {
  collision_forge::PossibleCollision collision;
  collision.collision_type = answer.collision_type;
  collision.tta = answer.tta;
  collision.alternative = number;
  collision.attacker_id = attack.trajectory.attacker_id;
  collision.attacker_class = toString(static_cast<AgentClass>(attack.trajectory.agent_class));
  collision.added = attack.trajectory.added;
  collision.manoeuvre = attack.report.manoeuvre;
  collision.confidence = attack.report.confidence;
  collision.contact_after = (attack.report.contact_time - attack.header.stamp).toSec();
  collision.impact_speed = attack.report.impact_speed;
  return collision;
}

/// Returns the most frequent reason of rejection among `answers`, with the message of the first
/// answer that has it; empty without answers.
std::string commonestReason(const std::vector<collision_forge::CollisionAnswer>& answers) {
  std::map<std::uint8_t, std::size_t> counts;
  for (const auto& answer : answers) ++counts[answer.code];
  const auto is_commonest = [&](const auto& answer) {
    return std::all_of(counts.begin(), counts.end(),
                       [&](const auto& other) { return other.second <= counts.at(answer.code); });
  };
  const auto first = std::find_if(answers.begin(), answers.end(), is_commonest);
  if (first == answers.end()) return {};
  return "no collision is possible; " + std::to_string(counts[first->code]) + " of " +
         std::to_string(answers.size()) +
         " requests: " + toString(static_cast<StatusCode>(first->code)) + ", as " + first->message;
}

}  // namespace

std::variant<std::vector<CollisionRequest>, Status> requestsForEach(
    collision_forge::CollisionRequest request, const std::vector<std::string>& names,
    std::vector<double> ttas, const std::vector<double>& usual_ttas, const CrashDefinition& crash) {
  if (!request.collision_type.empty() || request.tta != 0.0) {
    return Status{StatusCode::kInvalidInput,
                  "request.collision_type and request.tta must be empty and 0: set "
                  "collision_types and ttas instead"};
  }
  const auto types = typesNamed(names, request.manoeuvre);
  if (const Status* unknown = std::get_if<Status>(&types)) return *unknown;
  if (ttas.empty()) ttas = usual_ttas;
  std::vector<CollisionRequest> requests;
  for (const CollisionType type : std::get<std::vector<CollisionType>>(types)) {
    request.collision_type = toString(type);
    const auto parsed = fromMessage(request, crash);
    if (const Status* refusal = std::get_if<Status>(&parsed)) return *refusal;
    for (const double tta : ttas) {
      requests.push_back(std::get<CollisionRequest>(parsed));
      requests.back().tta = tta;
    }
  }
  return requests;
}

collision_forge::CollisionAnswer toMessage(const CollisionRequest& request, const Attack& answer,
                                           const std::string& method, double now) {
  collision_forge::CollisionAnswer message;
  message.collision_type = toString(request.type);
  message.tta = request.tta;
  message.code = static_cast<std::uint8_t>(answer.status.code);
  message.message = answer.status.message;
  if (answer.status.code != StatusCode::kOk) return message;
  message.attack = toMessage(answer, method, now);
  for (const Attack& alternative : answer.alternatives) {
    message.alternatives.push_back(toMessage(alternative, method, now));
  }
  message.summary = summaryOf(message.attack);
  return message;
}

Status listPossible(const std::vector<collision_forge::CollisionAnswer>& answers,
                    std::vector<collision_forge::PossibleCollision>& collisions) {
  for (const collision_forge::CollisionAnswer& answer : answers) {
    const auto code = static_cast<StatusCode>(answer.code);
    if (dependsOnScene(code)) continue;
    if (code != StatusCode::kOk) return {code, answer.message};
    const auto first = static_cast<std::ptrdiff_t>(collisions.size());
    std::uint32_t number = 1;
    collisions.push_back(inShort(answer, answer.attack, number));
    for (const auto& attack : answer.alternatives) {
      collisions.push_back(inShort(answer, attack, ++number));
    }
    std::stable_sort(collisions.begin() + first, collisions.end(),
                     [](const auto& a, const auto& b) { return a.confidence > b.confidence; });
  }
  return {StatusCode::kOk, collisions.empty() ? commonestReason(answers) : ""};
}

}  // namespace forge
