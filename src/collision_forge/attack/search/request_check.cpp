#include "collision_forge/attack/search/request_check.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/base/scene/contact_conditions.h"
#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/base/scene/hitched.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/base/scene/short_id.h"

namespace forge {
namespace {

constexpr double kStandingSpeed = 0.5;  // m/s; a faster leader does not stand
constexpr double kBrakingLead = 1.0;    // m/s2; a leader that decelerates more brakes

template <typename... Parts>
Status refuse(StatusCode code, const Parts&... parts) {
  std::ostringstream message;
  (message << ... << parts);
  return {code, message.str()};
}

bool isFinite(const Track& track) {
  return std::all_of(track.states.begin(), track.states.end(),
                     [](const AgentState& state) { return state.pose.isFinite(); });
}

/// Returns false if the newest two states are too far apart in time to derive a motion.
bool hasMotion(const Track& track) {
  const auto& states = track.states;
  return states.size() >= 2 && states.back().time - states[states.size() - 2].time <= kMaxGap;
}

Status checkEgo(const Snapshot& snapshot) {
  const Track& ego = snapshot.ego;
  if (!(ego.size.length > 0.0 && ego.size.width > 0.0)) {
    return refuse(StatusCode::kInvalidInput, "the ego's size is ", ego.size.length, " x ",
                  ego.size.width, " m");
  }
  if (!isFinite(ego)) return refuse(StatusCode::kInvalidInput, "the ego's pose is not finite");
  if (static_cast<int>(ego.states.size()) < kMinHistoryFrames || !endsAt(ego, snapshot.now)) {
    return refuse(StatusCode::kTooLittleHistory, "the ego was observed in ", ego.states.size(),
                  " frames up to t0, ", kMinHistoryFrames, " are needed");
  }
  if (!hasMotion(ego)) {
    return refuse(StatusCode::kTooLittleHistory, "the ego was not observed in the ", kMaxGap,
                  " s before t0");
  }
  return {};
}

Status checkAttacker(const std::string& id, const std::optional<AgentClass>& wanted,
                     const Snapshot& snapshot) {
  const auto attacker = std::find_if(snapshot.agents.begin(), snapshot.agents.end(),
                                     [&](const Track& agent) { return agent.id == id; });
  if (attacker == snapshot.agents.end()) {
    return refuse(StatusCode::kUnknownAttacker, "attacker_id \"", id, "\" is not in the scene");
  }
  if (!endsAt(*attacker, snapshot.now)) {
    return refuse(StatusCode::kAbsentAttacker, "attacker \"", id, "\" is not present at t0");
  }
  if (!canAttack(attacker->agent_class)) {
    return refuse(StatusCode::kAbsentAttacker, "attacker \"", id, "\" is a ",
                  toString(attacker->agent_class), ", which cannot attack");
  }
  if (const Track* const other = hitchedTo(*attacker, snapshot.agents)) {
    return refuse(StatusCode::kAbsentAttacker, "attacker \"", id, "\" forms one vehicle with ",
                  toString(other->agent_class), " \"", other->id, "\" and cannot attack");
  }
  if (wanted && attacker->agent_class != *wanted) {
    return refuse(StatusCode::kInvalidInput, "attacker \"", id, "\" is a ",
                  toString(attacker->agent_class), ", but attacker_class = ", toString(*wanted));
  }
  if (!isFinite(*attacker)) {
    return refuse(StatusCode::kInvalidInput, "the pose of attacker \"", id, "\" is not finite");
  }
  if (!(attacker->size.length > 0.0 && attacker->size.width > 0.0)) {
    return refuse(StatusCode::kInvalidInput, "the size of attacker \"", id, "\" is ",
                  attacker->size.length, " x ", attacker->size.width, " m");
  }
  if (!hasMotion(*attacker)) {
    return refuse(StatusCode::kTooLittleHistory, "attacker \"", id,
                  "\" was not observed before t0");
  }
  return {};
}

/// Checks the ranges of kRangeControls and `from_side`, each by itself.
Status checkRanges(const CollisionRequest& request) {
  for (const RangeControl& control : kRangeControls) {
    const std::optional<Range>& range = request.*control.asked;
    if (!range) continue;
    if (!(range->min >= control.least && range->max >= range->min && range->max <= control.most)) {
      return refuse(StatusCode::kInvalidInput, control.name, " = ", range->min, " to ", range->max,
                    " ", control.unit, " must be a range within ", control.least, " to ",
                    control.most);
    }
  }
  if (request.from_side && *request.from_side != Side::kLeft &&
      *request.from_side != Side::kRight) {
    return refuse(StatusCode::kInvalidInput, "from_side = ", toString(*request.from_side),
                  " is neither left nor right");
  }
  return {};
}

/// Checks the ranges, and that no two fields contradict each other.
Status checkConditions(const CollisionRequest& request) {
  const Status ranges = checkRanges(request);
  if (ranges.code != StatusCode::kOk) return ranges;
  const auto contradicts = [](const auto&... parts) {
    return refuse(StatusCode::kInvalidInput, parts...);
  };
  const std::optional<Manoeuvre>& manoeuvre = request.manoeuvre;
  if (request.from_side && request.type == CollisionType::kRearEnd) {
    return contradicts("from_side = ", toString(*request.from_side),
                       " contradicts type = rear_end, whose attacker comes from ahead or behind");
  }
  if (request.from_side && request.ego_side &&
      (*request.ego_side == Side::kLeft || *request.ego_side == Side::kRight) &&
      *request.ego_side != *request.from_side) {
    return contradicts("from_side = ", toString(*request.from_side),
                       " contradicts ego_side = ", toString(*request.ego_side));
  }
  if (request.impact_location && request.ego_side.value_or(Side::kFront) != Side::kFront) {
    return contradicts("impact_location is a place on the ego's front and contradicts ego_side = ",
                       toString(*request.ego_side));
  }
  if (request.lateral_speed && request.attacker_speed &&
      request.lateral_speed->min > request.attacker_speed->max) {
    return contradicts("lateral_speed = ", request.lateral_speed->min,
                       " m/s at least contradicts attacker_speed = ", request.attacker_speed->max,
                       " m/s at most");
  }
  if (manoeuvre == Manoeuvre::kLeadStopped && request.attacker_speed &&
      request.attacker_speed->min > kStandingSpeed) {
    return contradicts("attacker_speed = ", request.attacker_speed->min,
                       " m/s at least contradicts manoeuvre = lead_stopped");
  }
  if (request.departure_time && manoeuvre == Manoeuvre::kLeadStopped) {
    return contradicts("departure_time contradicts manoeuvre = lead_stopped");
  }
  if (request.departure_time &&
      request.departure_time->min > request.tta + request.crash.time_tolerance) {
    return contradicts("departure_time = ", request.departure_time->min,
                       " s at least is after the contact, tta = ", request.tta, " s");
  }
  if (request.queue && request.type != CollisionType::kRearEnd) {
    return contradicts("queue = true requires type = rear_end, not type = ",
                       toString(request.type));
  }
  if (request.queue && manoeuvre.value_or(Manoeuvre::kLeadStopped) != Manoeuvre::kLeadStopped) {
    return contradicts("queue = true requires manoeuvre = lead_stopped, not manoeuvre = ",
                       toString(*manoeuvre));
  }
  if (request.reverses()) {
    if (request.attacker || request.choice == AttackerChoice::kExisting) {
      return contradicts("manoeuvre = back_out is by an added vehicle and contradicts ",
                         request.attacker ? "attacker_id" : "choice = existing");
    }
    if (request.attacker_class && !isCarLike(*request.attacker_class)) {
      return contradicts("manoeuvre = back_out contradicts attacker_class = ",
                         toString(*request.attacker_class), ", which does not reverse");
    }
    if (!request.crash.believable || request.mode == Mode::kAdaptive) {
      return contradicts("manoeuvre = back_out is not supported with ",
                         request.crash.believable ? "mode = adaptive" : "believable = false");
    }
  }
  const bool keeps_speed =
      manoeuvre == Manoeuvre::kLeadStopped || manoeuvre == Manoeuvre::kLeadSlow;
  if (keeps_speed && request.deceleration && request.deceleration->min > kBrakingLead) {
    return contradicts("deceleration = ", request.deceleration->min,
                       " m/s2 at least contradicts manoeuvre = ", toString(*manoeuvre));
  }
  return {};
}

}  // namespace

bool isCandidate(const Track& agent, const Snapshot& snapshot, const PredictionOptions& options,
                 const std::optional<AgentClass>& wanted) {
  if (!(isMotorVehicle(agent.agent_class) || agent.agent_class == wanted)) return false;
  if (!hasMotion(agent)) return false;
  if (!endsAt(agent, snapshot.now) || !isFinite(agent)) return false;
  if (!(agent.size.length > 0.0 && agent.size.width > 0.0)) return false;
  const Vector2 ego = snapshot.ego.states.back().pose.position();
  return (agent.states.back().pose.position() - ego).norm() <= options.candidate_radius &&
         hitchedTo(agent, snapshot.agents) == nullptr;
}

bool stands(const Track& agent) { return estimateMotion(agent).speed < kStandstillSpeed; }

bool asksForPedestrian(const CollisionRequest& request, const Snapshot& snapshot) {
  if (request.attacker_class) return isOnFoot(*request.attacker_class);
  const Track* attacker =
      request.attacker ? findTrack(snapshot.agents, *request.attacker) : nullptr;
  return attacker != nullptr && isOnFoot(attacker->agent_class);
}

CollisionRequest withFullId(CollisionRequest request, const Snapshot& snapshot) {
  if (!request.attacker || request.attacker->size() < kShortId) return request;
  std::vector<std::string> named;
  for (const Track& agent : snapshot.agents) {
    if (agent.id == *request.attacker) return request;
    if (agent.id.compare(0, request.attacker->size(), *request.attacker) == 0) {
      named.push_back(agent.id);
    }
  }
  if (named.size() == 1) request.attacker = named.front();
  return request;
}

Status checkControls(const CollisionRequest& request) {
  if (request.attacker && request.choice == AttackerChoice::kNew) {
    return refuse(StatusCode::kInvalidInput, "choice = new, but attacker_id = \"",
                  *request.attacker, "\" is a recorded vehicle");
  }
  if (request.attacker_class && !canAttack(*request.attacker_class)) {
    return refuse(StatusCode::kInvalidInput, "attacker_class = ", toString(*request.attacker_class),
                  " cannot attack");
  }
  if (request.turning == Turning::kEgo && !mayAskForEgoTurn(request.type)) {
    return refuse(StatusCode::kInvalidInput,
                  "turning = ego requires type = ltap, junction_crossing, angle_same_direction or "
                  "angle_opposite_direction, not type = ",
                  toString(request.type));
  }
  if (request.manoeuvre && !isManoeuvreOf(*request.manoeuvre, request.type, request.turning)) {
    return refuse(StatusCode::kInvalidInput, "manoeuvre = ", toString(*request.manoeuvre),
                  " is not of type = ", toString(request.type),
                  request.turning == Turning::kEgo ? " with turning = ego" : "", ", which has ",
                  manoeuvreNames(request.type, request.turning));
  }
  if (request.impact_speed) {
    const Range& speed = *request.impact_speed;
    if (!(speed.min >= 0.0 && speed.max >= speed.min && std::isfinite(speed.max))) {
      return refuse(StatusCode::kInvalidInput, "impact_speed = ", speed.min, " to ", speed.max,
                    " m/s must be a range with 0 <= min <= max");
    }
  }
  if (request.overlap) {
    const Range& overlap = *request.overlap;
    if (!(overlap.min >= 0.0 && overlap.max >= overlap.min && overlap.max <= 1.0)) {
      return refuse(StatusCode::kInvalidInput, "overlap = ", overlap.min, " to ", overlap.max,
                    " must be a range within 0 to 1");
    }
  }
  const Status conditions = checkConditions(request);
  if (conditions.code != StatusCode::kOk) return conditions;
  if (request.alternatives < 1 || request.alternatives > kMaxAlternatives) {
    return refuse(StatusCode::kInvalidInput, "alternatives = ", request.alternatives,
                  " must be 1 to ", kMaxAlternatives);
  }
  if (request.mode == Mode::kAdaptive && request.crash.limits == LimitSet::kStrict) {
    return refuse(StatusCode::kInvalidInput,
                  "limits = strict is not supported with mode = adaptive, whose attackers keep the "
                  "limits of their vehicle class");
  }
  if (request.mode == Mode::kAdaptive && request.hidden_by) {
    return refuse(StatusCode::kInvalidInput, "hidden_by = ", toString(*request.hidden_by),
                  " is not supported with mode = adaptive");
  }
  if (request.mode == Mode::kAdaptive && request.queue) {
    return refuse(StatusCode::kInvalidInput, "queue = true is not supported with mode = adaptive");
  }
  if (request.mode == Mode::kAdaptive && request.alternatives > 1) {
    return refuse(StatusCode::kInvalidInput, "alternatives = ", request.alternatives,
                  " is not supported with mode = adaptive, which drives one attacker");
  }
  if (request.crash.believable && request.crash.limits == LimitSet::kStrict) {
    return refuse(StatusCode::kInvalidInput,
                  "limits = strict requires believable = false: a plausible attacker keeps "
                  "the limits of its vehicle class");
  }
  return {};
}

Status checkRequest(const CollisionRequest& request, const Snapshot& snapshot,
                    const PredictionOptions& options) {
  if (!(request.tta >= options.min_tta && request.tta <= options.max_tta)) {
    return refuse(StatusCode::kTtaOutOfRange, "tta = ", request.tta, " s is outside ",
                  options.min_tta, " to ", options.max_tta, " s");
  }
  const Status controls = checkControls(request);
  if (controls.code != StatusCode::kOk) return controls;
  if (request.mode == Mode::kAdaptive && asksForPedestrian(request, snapshot)) {
    return refuse(StatusCode::kInvalidInput,
                  "mode = adaptive is not supported for a person on foot as the attacker");
  }
  const Status ego = checkEgo(snapshot);
  if (ego.code != StatusCode::kOk) return ego;
  if (!request.attacker) return {};
  const Status attacker = checkAttacker(*request.attacker, request.attacker_class, snapshot);
  if (attacker.code != StatusCode::kOk || !request.departure_time) return attacker;
  if (stands(*findTrack(snapshot.agents, *request.attacker))) return {};
  return refuse(StatusCode::kInvalidInput, "attacker \"", *request.attacker,
                "\" moves at t0 and contradicts departure_time");
}

}  // namespace forge
