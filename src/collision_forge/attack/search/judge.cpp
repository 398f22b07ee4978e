#include "collision_forge/attack/search/judge.h"

#include <algorithm>
#include <set>

#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

/// Returns every second sample from `first` on; without samples, the known ego.
std::vector<const Track*> everySecond(const Future& future, std::size_t first) {
  std::vector<const Track*> egos;
  for (std::size_t i = first; i < future.ego_samples.size(); i += 2) {
    egos.push_back(&future.ego_samples[i]);
  }
  if (egos.empty()) egos.push_back(&future.ego);
  return egos;
}

/// Returns why the attacker is not of the requested kind, worded to follow the attack; empty if it
/// is.
std::string wrongAttacker(const AttackerTrajectory& attacker, const CollisionRequest& request) {
  if (request.attacker && attacker.attacker_id != *request.attacker) {
    return "is by attacker " + attacker.attacker_id;
  }
  if (request.attacker_class && attacker.agent_class != *request.attacker_class) {
    return std::string("is by a ") + toString(attacker.agent_class);
  }
  if (attacker.isAdded() && request.choice == AttackerChoice::kExisting)
    return "is by an added vehicle";
  if (!attacker.isAdded() && request.choice == AttackerChoice::kNew)
    return "is by a recorded vehicle";
  return "";
}

/// Returns which of kRangeControls, `from_side` or `hidden_by` the attack misses, worded to follow
/// the attack; empty if none.
std::string conditionMissed(const CollisionReport& report, const CollisionRequest& request) {
  if (request.departure_time && report.conditions.departure_time == kNoDeparture) {
    return "does not start from a standstill after t0";
  }
  for (const RangeControl& control : kRangeControls) {
    const std::optional<Range>& range = request.*control.asked;
    if (!range) continue;
    const double measured = report.conditions.*control.measured;
    if (measured < range->min) return std::string("has too small a value of ") + control.name;
    if (measured > range->max) return std::string("has too great a value of ") + control.name;
  }
  if (request.impact_location && report.ego_side != Side::kFront) {
    return std::string("touched the ego's ") + toString(report.ego_side) + " side, not its front";
  }
  if (request.from_side && report.conditions.from_side != *request.from_side) {
    return std::string("came from the ") + toString(report.conditions.from_side);
  }
  if (request.hidden_by && report.conditions.hidden_by != request.hidden_by) {
    return std::string("was not hidden by a ") + toString(*request.hidden_by);
  }
  if (request.hidden_by && !request.visible_for) {
    const Range usual = usualSight(*request.hidden_by);
    const double seen = report.conditions.visible_for;
    if (seen < usual.min || seen > usual.max) return "came into view too early or too late";
  }
  return "";
}

}  // namespace

std::string shortcomingOf(const CollisionReport& report, const CollisionRequest& request) {
  if (!report.contact) return "missed the ego";
  if (!report.first_other_id.empty()) return "touched another agent first";
  if (!report.on_time) return "made contact at the wrong time";
  if (!report.type_kept) return "made contact of another type";
  if (!report.limits_kept) return "violates " + report.broken_limit;
  if (request.crash.believable && !report.believable()) {
    return "is implausible: it " + report.unbelievable;
  }
  if (request.manoeuvre && report.manoeuvre != *request.manoeuvre) {
    return std::string("has manoeuvre ") + toString(report.manoeuvre);
  }
  if (request.ego_side && report.ego_side != *request.ego_side) {
    return std::string("touched the wrong side of the ego: ") + toString(report.ego_side);
  }
  if (request.impact_speed) {
    if (report.impact_speed < request.impact_speed->min) return "hit the ego too slowly";
    if (report.impact_speed > request.impact_speed->max) return "hit the ego too fast";
  }
  if (request.overlap) {
    if (report.overlap < request.overlap->min) return "overlapped too little of the ego's side";
    if (report.overlap > request.overlap->max) return "overlapped too much of the ego's side";
  }
  return conditionMissed(report, request);
}

bool meetsRequest(const CollisionReport& report, const CollisionRequest& request) {
  return shortcomingOf(report, request).empty();
}

Status verdictOn(const Attack& answer, const CollisionRequest& request) {
  if (answer.status.code != StatusCode::kOk) return answer.status;
  if (answer.report.verified() && request.crash.believable && !answer.report.believable()) {
    return {StatusCode::kNotBelievable, "the attacker " + answer.report.unbelievable};
  }
  std::string shortcoming = shortcomingOf(answer.report, request);
  if (shortcoming.empty()) shortcoming = wrongAttacker(answer.trajectory, request);
  if (shortcoming.empty()) return {};
  return {StatusCode::kNoAttackWithinLimits, "the method's attack " + shortcoming};
}

double scoreOf(const Attack& answer) { return answer.report.confidence - answer.effort; }

bool hasConstraints(const CollisionRequest& request) {
  return request.manoeuvre || request.ego_side || request.impact_speed || request.overlap ||
         asksForConditions(request);
}

double confidenceOf(double share, const std::vector<double>& curve) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(curve.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), curve.size() - 2);
  return curve[i] + (place - static_cast<double>(i)) * (curve[i + 1] - curve[i]);
}

AttackJudge::AttackJudge(const VerificationInput& input, const AttackOptions& options, bool exact)
    : input_(input),
      options_(options),
      exact_(exact),
      searched_(everySecond(input.future, 0)),
      tried_(input.future) {}

bool AttackJudge::accepts(Attack& attack, const Track& attacker,
                          const std::vector<const Track*>& egos) {
  constexpr std::size_t kTries = 4;
  const auto end = egos.begin() + static_cast<std::ptrdiff_t>(std::min(kTries, egos.size()));
  std::optional<CollisionReport> rejected;
  const bool is_verified = std::any_of(egos.begin(), end, [&](const Track* ego) {
    if (isVerifiedIn(attack, *ego)) return true;
    if (!rejected) rejected = attack.report;
    return false;
  });
  if (!is_verified) {
    if (rejected) countRejection(*rejected);
    return false;
  }
  if (exact_ && !isExact(attack.miss)) {
    ++rejections_["missed the pattern"];
    if (!nearest_ || attack.miss.distance < nearest_->distance) nearest_ = attack.miss;
    return false;
  }
  const double confidence = confidenceIn(attacker, attack.trajectory.points);
  attack.report.confidence = confidence;
  if (confidence >= input_.request.crash.min_confidence) return true;
  surest_ = std::max(surest_.value_or(0.0), confidence);
  return false;
}

bool AttackJudge::isVerifiedIn(Attack& attack, const Track& ego) {
  tried_.ego = ego;
  attack.report = verify(attack.trajectory, {input_.snapshot, tried_, input_.request, input_.lanes},
                         options_.verification);
  if (!meetsRequest(attack.report, input_.request)) {
    const bool is_verified = attack.report.verified();
    if (is_verified && input_.request.crash.believable && !attack.report.believable()) {
      unbelievable_ = attack.report.unbelievable;
    }
    return false;
  }
  attack.miss =
      missBetween(attack.pattern.attacker_offset,
                  relativeTo(attack.report.ego_at_contact, attack.report.attacker_at_contact));
  return true;
}

void AttackJudge::countRejection(const CollisionReport& report) {
  std::string kind = shortcomingOf(report, input_.request);
  kind.erase(std::min(kind.find_first_of("0123456789"), kind.size()));  // strips the value
  while (!kind.empty() && kind.back() == ' ') kind.pop_back();
  ++rejections_[kind];
}

double AttackJudge::confidenceIn(const Track& attacker,
                                 const std::vector<TrajectoryPoint>& points) {
  if (input_.future.ego_samples.empty()) return 1.0;
  if (!held_out_) {
    held_out_.emplace(everySecond(input_.future, 1), input_.future.agents, input_.request,
                      input_.snapshot.now, input_.lanes.map().driving_side, options_);
  }
  return confidenceOf(held_out_->score(attacker, points).share, options_.search.confidence_curve);
}

Status AttackJudge::refusal(const std::vector<CollisionPattern>& patterns) const {
  if (surest_) {
    return {StatusCode::kLowConfidence,
            "the best attack has a confidence of " + percentText(*surest_) +
                ", less than min_confidence = " + numberText(input_.request.crash.min_confidence)};
  }
  if (!unbelievable_.empty()) {
    return {StatusCode::kNotBelievable, "the best attacker " + unbelievable_};
  }
  return {StatusCode::kNoAttackWithinLimits, failureText(patterns)};
}

std::string AttackJudge::failureText(const std::vector<CollisionPattern>& patterns) const {
  std::set<std::string> attackers;
  for (const CollisionPattern& pattern : patterns) attackers.insert(pattern.attacker_id);
  const std::string tried = "tried " + counted(patterns.size(), "candidate") + " (" +
                            counted(attackers.size(), "vehicle") + "): ";
  if (rejections_.empty()) {
    return tried + "none hits the ego at " + numberText(input_.request.tta) + " +- " +
           numberText(input_.request.crash.time_tolerance) + " s within its limits";
  }
  std::string text;
  for (const auto& [reason, count] : rejections_) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + reason;
  }
  if (nearest_) {
    text += ", the nearest by " + numberText(nearest_->distance) + " m and " +
            numberText(nearest_->heading) + " rad";
  }
  return tried + "the best motions within the limits fail verification: " + text;
}

}  // namespace forge
