#include "collision_forge/ros/possible_collisions.h"

#include <algorithm>

#include "collision_forge/scene/request_words.h"

namespace forge {
namespace {

/// The scene does not allow it; another scene may.
bool isOfTheScene(StatusCode code) {
  switch (code) {
    case StatusCode::kNoCandidate:
    case StatusCode::kNoAttackWithinLimits:
    case StatusCode::kBeyondRecording:
    case StatusCode::kLowConfidence:
    case StatusCode::kNotBelievable:
    case StatusCode::kRoadDoesNotAllow:
      return true;
    default:
      return false;
  }
}

collision_forge::PossibleCollision inShort(const collision_forge::CollisionAnswer& answer,
                                           const collision_forge::Attack& attack) {
  collision_forge::PossibleCollision collision;
  collision.collision_type = answer.collision_type;
  collision.tta = answer.tta;
  collision.attacker_id = attack.trajectory.attacker_id;
  collision.attacker_class = toString(static_cast<AgentClass>(attack.trajectory.agent_class));
  collision.added = attack.trajectory.added;
  collision.manoeuvre = attack.report.manoeuvre;
  collision.confidence = attack.report.confidence;
  collision.contact_after = (attack.report.contact_time - attack.header.stamp).toSec();
  collision.impact_speed = attack.report.impact_speed;
  return collision;
}

}  // namespace

Status statusOf(const collision_forge::CollisionAnswer& answer) {
  return {static_cast<StatusCode>(answer.code), answer.message};
}

std::variant<std::vector<collision_forge::CollisionRequest>, Status> requestsForEach(
    const collision_forge::CollisionRequest& request, std::vector<std::string> types,
    std::vector<double> ttas, const std::vector<double>& usual_ttas) {
  if (!request.collision_type.empty() || request.tta != 0.0) {
    return Status{StatusCode::kInvalidInput,
                  "request.collision_type and request.tta are left empty and 0: collision_types "
                  "and ttas say what is asked for"};
  }
  const auto manoeuvre = manoeuvreFromString(request.manoeuvre);
  if (types.empty() && manoeuvre) types = {toString(typeOf(*manoeuvre))};
  if (types.empty()) {
    for (const CollisionType type : kCollisionTypes) types.emplace_back(toString(type));
  }
  for (std::string& name : types) {
    const auto type = collisionTypeFromString(name);
    if (!type) {
      return Status{StatusCode::kUnknownType,
                    "collision_types: \"" + name + "\" is no collision type"};
    }
    name = toString(*type);
  }
  if (ttas.empty()) ttas = usual_ttas;
  std::vector<collision_forge::CollisionRequest> requests;
  for (const std::string& type : types) {
    for (const double tta : ttas) {
      requests.push_back(request);
      requests.back().collision_type = type;
      requests.back().tta = tta;
    }
  }
  return requests;
}

Status listPossible(const std::vector<collision_forge::CollisionAnswer>& answers,
                    std::vector<collision_forge::PossibleCollision>& collisions) {
  for (const collision_forge::CollisionAnswer& answer : answers) {
    const Status status = statusOf(answer);
    if (isOfTheScene(status.code)) continue;
    if (status.code != StatusCode::kOk) return status;
    const auto first = static_cast<std::ptrdiff_t>(collisions.size());
    collisions.push_back(inShort(answer, answer.attack));
    for (const auto& attack : answer.alternatives) collisions.push_back(inShort(answer, attack));
    std::stable_sort(collisions.begin() + first, collisions.end(),
                     [](const auto& a, const auto& b) { return a.confidence > b.confidence; });
  }
  return {};
}

}  // namespace forge
