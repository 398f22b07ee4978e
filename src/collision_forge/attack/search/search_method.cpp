#include "collision_forge/attack/search/search_method.h"

#include <optional>
#include <utility>

#include "collision_forge/attack/search/added_vehicle.h"
#include "collision_forge/attack/search/cut_out_leader.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/parked_vehicle.h"
#include "collision_forge/attack/search/queued_vehicle.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/attack/search/roadside.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/scene/support_vehicles.h"

namespace forge {
namespace {

/// Returns true if an added vehicle could improve on the result of the recorded vehicles.
bool mayBeAdded(const Attack& existing, const Moment& moment, const CollisionRequest& request,
                const AttackOptions& options) {
  if (request.attacker || request.choice == AttackerChoice::kExisting) return false;
  if (!request.crash.believable || moment.lanes->map().lanes.empty()) return false;
  switch (existing.status.code) {
    case StatusCode::kOk:
      // Not if the result already has the greatest possible score.
      return request.choice == AttackerChoice::kNew || request.reverses() ||
             scoreOf(existing) + options.added.preference < options.search.confidence_curve.back();
    case StatusCode::kNoCandidate:
    case StatusCode::kNoAttackWithinLimits:
    case StatusCode::kNotBelievable:
    case StatusCode::kLowConfidence:
      return true;
    default:
      return false;
  }
}

// s, added to the requested time; each moves the place at which a parked vehicle must stand.
constexpr double kHiddenShifts[] = {0.0, -0.3, 0.3};

/// Returns the sides from which attacks are searched for a request with hidden_by.
std::vector<std::optional<Side>> sidesOf(const CollisionRequest& request) {
  if (request.from_side || request.type == CollisionType::kRearEnd) return {request.from_side};
  return {Side::kRight, Side::kLeft};
}

/// Returns the request without what the support vehicles provide; behind a leader and in a queue, a
/// vehicle stands.
CollisionRequest openRequest(CollisionRequest request) {
  if ((request.hidden_by == Hider::kLeader || request.queue) && !request.manoeuvre) {
    request.manoeuvre = Manoeuvre::kLeadStopped;
  }
  if (request.hidden_by) request.visible_for.reset();
  request.hidden_by.reset();
  return request;
}

/// Returns `future` with an ego that the attack hits as requested as its ego; empty if there is
/// none.
std::optional<Future> futureHit(const Attack& attack, const Future& future, const Moment& moment,
                                const CollisionRequest& request,
                                const VerificationOptions& options) {
  Future tried = future;
  tried.ego_samples.clear();
  const auto isHit = [&] {
    return meetsRequest(
        verify(attack.trajectory, {moment.snapshot, tried, request, *moment.lanes}, options),
        request);
  };
  if (isHit()) return tried;
  for (const Track& ego : future.ego_samples) {
    tried.ego = ego;
    if (isHit()) return tried;
  }
  return std::nullopt;
}

bool isPreferred(const Attack& added, const Attack& existing, bool may_exist,
                 const AddedVehicleOptions& options) {
  if (!may_exist) return true;
  if (existing.status.code != StatusCode::kOk) {
    return added.status.code == StatusCode::kOk ||
           added.status.code == StatusCode::kRoadDoesNotAllow;
  }
  return added.status.code == StatusCode::kOk &&
         scoreOf(added) > scoreOf(existing) + options.preference;
}

}  // namespace

SearchMethod::SearchMethod(const AttackOptions& options,
                           std::shared_ptr<const PatternPredictor> predictor)
    : SearchMethod(options, std::move(predictor), std::make_shared<SearchRealizer>(options)) {}

SearchMethod::SearchMethod(const AttackOptions& options,
                           std::shared_ptr<const PatternPredictor> predictor,
                           std::shared_ptr<const TrajectoryRealizer> realizer)
    : options_(options), predictor_(std::move(predictor)), realizer_(std::move(realizer)) {}

Attack SearchMethod::answer(const Moment& moment, const CollisionRequest& request) const {
  if (!request.hidden_by && !request.queue) return search(moment, request).attack;
  const Found found =
      request.hidden_by ? searchHidden(moment, request) : search(moment, openRequest(request));
  if (!request.queue || found.attack.status.code != StatusCode::kOk) return found.attack;
  return queued(found, moment, request);
}

SearchMethod::Found SearchMethod::searchHidden(const Moment& moment,
                                               const CollisionRequest& request) const {
  CollisionRequest open = openRequest(request);
  std::optional<Status> refusal;
  for (const std::optional<Side>& side : sidesOf(request)) {
    open.from_side = side;
    for (const double shift : kHiddenShifts) {
      open.tta = request.tta + shift;
      const Found found = search(moment, open);
      const bool is_found = found.attack.status.code == StatusCode::kOk;
      const Found answer = is_found ? hiddenBy(found, moment, request) : found;
      if (answer.attack.status.code == StatusCode::kOk) return answer;
      // An attack that nothing hides says more than a side without an attack.
      if (!refusal || (is_found && shift == 0.0)) refusal = answer.attack.status;
      if (!is_found || request.hidden_by == Hider::kLeader) break;
    }
  }
  return {rejection(*refusal), {}};
}

SearchMethod::Found SearchMethod::hiddenBy(const Found& found, const Moment& moment,
                                           const CollisionRequest& request) const {
  const auto refuse = [](const std::string& why) {
    return Found{rejection({StatusCode::kNoAttackWithinLimits, why}), {}};
  };
  const VerificationOptions& options = options_.verification;
  auto future = futureHit(found.attack, found.future, moment, openRequest(request), options);
  if (!future) return refuse("the attack hits none of the ego's futures as requested");
  Attack answer = found.attack;
  const auto judge = [&] {
    const double confidence = answer.report.confidence;
    answer.report =
        verify(answer.trajectory, {moment.snapshot, *future, request, *moment.lanes}, options);
    answer.report.confidence = confidence;
    return shortcomingOf(answer.report, request);
  };
  if (judge().empty()) return {answer, *future};  // recorded vehicles hide it
  const std::string hider = toString(*request.hidden_by);
  if (!moment.past) {
    return refuse("no " + hider + " can be added live: the ego has seen where it would have been");
  }
  Status refused{StatusCode::kNoAttackWithinLimits, ""};
  const HidingInput input{
      answer.trajectory, answer.report.contact_time,
      *future,           *moment.past,
      *moment.lanes,     request.visible_for.value_or(usualSight(*request.hidden_by))};
  if (request.hidden_by == Hider::kParkedVehicle) {
    answer.supports = findParkedVehicles(input, options_, refused);
  } else if (answer.report.manoeuvre != Manoeuvre::kLeadStopped) {
    refused.message = "the attacker does not stand in the ego's lane";
  } else if (auto leader = findCutOutLeader(input, options_, refused)) {
    answer.supports = {std::move(*leader)};
  }
  if (answer.supports.empty()) {
    refused.message = "no " + hider + " can be added: " + refused.message;
    return {rejection(refused), {}};
  }
  addSupports(answer.supports, *future);
  const std::string shortcoming = judge();
  if (!shortcoming.empty()) return refuse("behind a " + hider + ", the attack " + shortcoming);
  return {answer, *future};
}

Attack SearchMethod::queued(const Found& found, const Moment& moment,
                            const CollisionRequest& request) const {
  const auto refuse = [](const std::string& why) {
    return rejection({StatusCode::kNoAttackWithinLimits, why});
  };
  const VerificationOptions& options = options_.verification;
  auto future = futureHit(found.attack, found.future, moment, openRequest(request), options);
  if (!future) return refuse("the attack hits none of the ego's futures as requested");
  Attack answer = found.attack;
  const HidingInput input{answer.trajectory, answer.report.contact_time,
                          *future,           moment.past ? *moment.past : moment.snapshot,
                          *moment.lanes,     {}};
  if (answer.report.manoeuvre != Manoeuvre::kLeadStopped) {
    return refuse("the attacker does not stand in the ego's lane");
  }
  if (!isQueued(input)) {
    if (!moment.past) {
      return refuse("no queue can be added live: the ego has seen where it would have been");
    }
    Status refused;
    auto vehicle = findQueuedVehicle(input, options_, refused);
    if (!vehicle) {
      refused.message = "no queue can be added: " + refused.message;
      return rejection(refused);
    }
    addSupports({*vehicle}, *future);
    answer.supports.push_back(std::move(*vehicle));
  }
  const double confidence = answer.report.confidence;
  answer.report =
      verify(answer.trajectory, {moment.snapshot, *future, request, *moment.lanes}, options);
  answer.report.confidence = confidence;
  const std::string shortcoming = shortcomingOf(answer.report, request);
  if (!shortcoming.empty()) return refuse("before a queue, the attack " + shortcoming);
  return answer;
}

SearchMethod::Found SearchMethod::search(const Moment& moment,
                                         const CollisionRequest& request) const {
  PatternPrediction prediction = predictor_->predict(moment.snapshot, *moment.lanes, request,
                                                     moment.recorded ? &*moment.recorded : nullptr);
  if (prediction.future.ego.states.empty()) return {rejection(prediction.status), {}};
  const auto withFuture = [&](Attack attack) {
    return Found{std::move(attack), std::move(prediction.future)};
  };
  const VerificationInput input{moment.snapshot, prediction.future, request, *moment.lanes};
  const AddedVehicleInput added_input{moment.snapshot, moment.past.get(), prediction.future,
                                      request, *moment.lanes};
  const bool may_exist =
      !request.reverses() && (request.attacker || request.choice != AttackerChoice::kNew);
  const bool has_patterns = may_exist && prediction.status.code == StatusCode::kOk;
  const bool from_roadside = request.reverses() || asksForPedestrian(request, moment.snapshot);
  std::optional<AddedVehicles> vehicles;
  const auto answerBy = [&](SearchedMotion motion) {
    const Attack existing =
        has_patterns ? realizer_->realize({prediction.patterns, input, false, kNoPaths, motion})
                     : rejection(prediction.status);
    if (!mayBeAdded(existing, moment, request, options_)) return existing;
    if (!vehicles) {
      vehicles = from_roadside ? addFromRoadside(added_input, options_)
                               : addVehicles(added_input, options_);
    }
    const Attack added = realizeByAdded(*vehicles, added_input, options_, *realizer_, motion);
    return isPreferred(added, existing, may_exist, options_.added) ? added : existing;
  };

  if (!may_exist && (!request.crash.believable || moment.lanes->map().lanes.empty())) {
    return withFuture(
        rejection({StatusCode::kNoCandidate,
                   "an added vehicle requires believable = true and a map with lanes"}));
  }
  const Attack answer = answerBy(SearchedMotion::kByRoutes);
  // Attackers from the roadside are searched on paths alone.
  if (answer.status.code == StatusCode::kOk || !request.crash.believable || from_roadside) {
    return withFuture(answer);
  }
  const Attack other = answerBy(SearchedMotion::kAny);
  const StatusCode code = other.status.code;
  const bool tells_more =
      answer.status.code == StatusCode::kNoAttackWithinLimits &&
      (code == StatusCode::kNotBelievable || code == StatusCode::kLowConfidence);
  return withFuture(code == StatusCode::kOk || tells_more ? other : answer);
}

}  // namespace forge
