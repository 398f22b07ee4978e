#include "collision_forge/ros/messages/conversions.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/scene/request_words.h"

namespace forge {
namespace {

/// "none of A, B, ...", of the words that name these values.
template <typename Values>
std::string noneOf(const Values& values) {
  std::string words;
  for (const auto value : values)
    words += (words.empty() ? "" : ", ") + std::string(toString(value));
  return "none of " + words;
}

/// Returns the allowed words of a field of the request, worded to follow "is".
std::string allowedWords(const std::string& field) {
  if (field == "choice") return "none of any, existing and new";
  if (field == "believable") return "neither true nor false";
  if (field == "limits") return "neither drivable nor strict";
  if (field == "attacker_class") return noneOf(kAttackerClasses);
  if (field == "manoeuvre") return noneOf(kManoeuvres);
  if (field == "ego_side") return "none of front, rear, left and right";
  if (field == "hidden_by") return "neither parked_vehicle nor leader";
  return field == "turning" ? "neither attacker nor ego" : "neither left nor right";
}

/// The fields of a range in the message and in the request.
struct RangeFields {
  double collision_forge::CollisionRequest::*least;
  double collision_forge::CollisionRequest::*most;
  std::optional<Range> CollisionRequest::*asked;
};

constexpr RangeFields kRangeFields[] = {
    {&collision_forge::CollisionRequest::min_attacker_speed,
     &collision_forge::CollisionRequest::max_attacker_speed, &CollisionRequest::attacker_speed},
    {&collision_forge::CollisionRequest::min_deceleration,
     &collision_forge::CollisionRequest::max_deceleration, &CollisionRequest::deceleration},
    {&collision_forge::CollisionRequest::min_gap, &collision_forge::CollisionRequest::max_gap,
     &CollisionRequest::gap},
    {&collision_forge::CollisionRequest::min_headway,
     &collision_forge::CollisionRequest::max_headway, &CollisionRequest::headway},
    {&collision_forge::CollisionRequest::min_lateral_speed,
     &collision_forge::CollisionRequest::max_lateral_speed, &CollisionRequest::lateral_speed},
    {&collision_forge::CollisionRequest::min_impact_location,
     &collision_forge::CollisionRequest::max_impact_location, &CollisionRequest::impact_location},
    {&collision_forge::CollisionRequest::min_departure_time,
     &collision_forge::CollisionRequest::max_departure_time, &CollisionRequest::departure_time},
    {&collision_forge::CollisionRequest::min_visible_for,
     &collision_forge::CollisionRequest::max_visible_for, &CollisionRequest::visible_for},
};

/// Reads the constraints besides type, time and attacker; returns the problem, or "".
std::string readControls(const collision_forge::CollisionRequest& message,
                         CollisionRequest& request) {
  const std::pair<const char*, const std::string&> words[] = {
      {"choice", message.choice},       {"believable", message.believable},
      {"limits", message.limits},       {"attacker_class", message.attacker_class},
      {"manoeuvre", message.manoeuvre}, {"ego_side", message.ego_side},
      {"turning", message.turning},     {"from_side", message.from_side},
      {"hidden_by", message.hidden_by}};
  for (const auto& [field, word] : words) {
    if (!word.empty() && !setRequestWord(field, lowered(word), request)) {
      return field + (" = \"" + word + "\" is ") + allowedWords(field);
    }
  }
  request.queue = message.queue != 0;
  if (message.min_impact_speed != 0.0 || message.max_impact_speed != 0.0) {
    request.impact_speed = Range{message.min_impact_speed, message.max_impact_speed};
  }
  if (message.min_overlap != 0.0 || message.max_overlap != 0.0) {
    request.overlap = Range{message.min_overlap, message.max_overlap};
  }
  for (const RangeFields& fields : kRangeFields) {
    const Range range{message.*fields.least, message.*fields.most};
    if (range.min != 0.0 || range.max != 0.0) request.*fields.asked = range;
  }
  constexpr std::uint32_t kMany = std::numeric_limits<int>::max();
  if (message.alternatives != 0) {
    request.alternatives = static_cast<int>(std::min(message.alternatives, kMany));
  }
  return "";
}

}  // namespace

std::variant<CollisionRequest, Status> fromMessage(const collision_forge::CollisionRequest& message,
                                                   const CrashDefinition& crash) {
  CollisionRequest request;
  request.crash = crash;
  const auto type = collisionTypeFromString(message.collision_type);
  if (!type) {
    return Status{StatusCode::kUnknownType, "collision_type = \"" + message.collision_type +
                                                "\" is none of " + collisionTypeWords()};
  }
  request.type = *type;
  request.tta = message.tta;
  return withFieldsOf(message, request);
}

std::variant<CollisionRequest, Status> withFieldsOf(
    const collision_forge::CollisionRequest& message, CollisionRequest request) {
  const auto mode = modeFromString(message.mode.empty() ? "history" : message.mode);
  if (!mode) {
    return Status{StatusCode::kInvalidInput,
                  "mode = \"" + message.mode + "\" is neither history nor replay nor adaptive"};
  }
  if (message.tta != 0.0) request.tta = message.tta;
  if (!message.attacker_id.empty()) request.attacker = message.attacker_id;
  request.mode = *mode;
  if (request.mode == Mode::kAdaptive) request.crash.min_confidence = 0.0;
  if (message.seed != 0) request.seed = message.seed;
  const std::string problem = readControls(message, request);
  if (!problem.empty()) return Status{StatusCode::kInvalidInput, problem};
  return request;
}

collision_forge::CollisionRequest toMessage(const CollisionRequest& request) {
  collision_forge::CollisionRequest message;
  message.collision_type = toString(request.type);
  message.tta = request.tta;
  message.attacker_id = request.attacker.value_or("");
  message.choice = toString(request.choice);
  message.mode = toString(request.mode);
  message.seed = request.seed;
  message.believable = request.crash.believable ? "true" : "false";
  message.limits = toString(request.crash.limits);
  if (request.attacker_class) message.attacker_class = toString(*request.attacker_class);
  if (request.manoeuvre) message.manoeuvre = toString(*request.manoeuvre);
  if (request.ego_side) message.ego_side = toString(*request.ego_side);
  message.min_impact_speed = request.impact_speed.value_or(Range{}).min;
  message.max_impact_speed = request.impact_speed.value_or(Range{}).max;
  message.min_overlap = request.overlap.value_or(Range{}).min;
  message.max_overlap = request.overlap.value_or(Range{}).max;
  if (request.turning != Turning::kAttacker) message.turning = toString(request.turning);
  if (request.from_side) message.from_side = toString(*request.from_side);
  if (request.hidden_by) message.hidden_by = toString(*request.hidden_by);
  message.queue = static_cast<std::uint8_t>(request.queue);
  for (const RangeFields& fields : kRangeFields) {
    const Range range = (request.*fields.asked).value_or(Range{});
    message.*fields.least = range.min;
    message.*fields.most = range.max;
  }
  message.alternatives = static_cast<std::uint32_t>(request.alternatives);
  return message;
}

collision_forge::CollisionRequest requestIn(
    const collision_forge::GenerateCollision::Request& message) {
  collision_forge::CollisionRequest request;
  request.collision_type = message.collision_type;
  request.tta = message.tta;
  request.attacker_id = message.attacker_id;
  request.choice = message.choice;
  request.mode = message.mode;
  const bool is_history = message.mode.empty() || modeFromString(message.mode) == Mode::kHistory;
  if (message.adaptive && is_history) request.mode = toString(Mode::kAdaptive);
  request.seed = message.seed;
  request.believable = message.believable;
  request.limits = message.limits;
  request.attacker_class = message.attacker_class;
  request.manoeuvre = message.manoeuvre;
  request.ego_side = message.ego_side;
  request.min_impact_speed = message.min_impact_speed;
  request.max_impact_speed = message.max_impact_speed;
  request.min_overlap = message.min_overlap;
  request.max_overlap = message.max_overlap;
  request.turning = message.turning;
  request.from_side = message.from_side;
  request.min_attacker_speed = message.min_attacker_speed;
  request.max_attacker_speed = message.max_attacker_speed;
  request.min_deceleration = message.min_deceleration;
  request.max_deceleration = message.max_deceleration;
  request.min_gap = message.min_gap;
  request.max_gap = message.max_gap;
  request.min_headway = message.min_headway;
  request.max_headway = message.max_headway;
  request.min_lateral_speed = message.min_lateral_speed;
  request.max_lateral_speed = message.max_lateral_speed;
  request.min_impact_location = message.min_impact_location;
  request.max_impact_location = message.max_impact_location;
  request.min_departure_time = message.min_departure_time;
  request.max_departure_time = message.max_departure_time;
  request.hidden_by = message.hidden_by;
  request.queue = message.queue;
  request.min_visible_for = message.min_visible_for;
  request.max_visible_for = message.max_visible_for;
  request.alternatives = message.alternatives;
  return request;
}

}  // namespace forge
