#include "collision_forge/attack/search/search_method.h"

#include <optional>
#include <utility>

#include "collision_forge/attack/search/added_vehicle.h"
#include "collision_forge/attack/search/added_walkers.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/request_check.h"

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
      return request.choice == AttackerChoice::kNew ||
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
  const PatternPrediction prediction = predictor_->predict(
      moment.snapshot, *moment.lanes, request, moment.recorded ? &*moment.recorded : nullptr);
  if (prediction.future.ego.states.empty()) return rejection(prediction.status);
  const VerificationInput input{moment.snapshot, prediction.future, request, *moment.lanes};
  const AddedVehicleInput added_input{moment.snapshot, moment.past.get(), prediction.future,
                                      request, *moment.lanes};
  const bool may_exist = request.attacker || request.choice != AttackerChoice::kNew;
  const bool has_patterns = may_exist && prediction.status.code == StatusCode::kOk;
  const bool walks = asksForPedestrian(request, moment.snapshot);
  std::optional<AddedVehicles> vehicles;
  const auto answerBy = [&](SearchedMotion motion) {
    const Attack existing =
        has_patterns ? realizer_->realize({prediction.patterns, input, false, kNoWays, motion})
                     : rejection(prediction.status);
    if (!mayBeAdded(existing, moment, request, options_)) return existing;
    if (!vehicles) {
      vehicles = walks ? addWalkers(added_input, options_) : addVehicles(added_input, options_);
    }
    const Attack added = realizeByAdded(*vehicles, added_input, options_, *realizer_, motion);
    return isPreferred(added, existing, may_exist, options_.added) ? added : existing;
  };

  if (!may_exist && (!request.crash.believable || moment.lanes->map().lanes.empty())) {
    return rejection(
        {StatusCode::kNoCandidate, "choice = new requires believable = true and a map with lanes"});
  }
  const Attack answer = answerBy(SearchedMotion::kByRoutes);
  // Pedestrians are searched on paths alone.
  if (answer.status.code == StatusCode::kOk || !request.crash.believable || walks) return answer;
  const Attack other = answerBy(SearchedMotion::kAny);
  const StatusCode code = other.status.code;
  const bool tells_more =
      answer.status.code == StatusCode::kNoAttackWithinLimits &&
      (code == StatusCode::kNotBelievable || code == StatusCode::kLowConfidence);
  return code == StatusCode::kOk || tells_more ? other : answer;
}

}  // namespace forge
