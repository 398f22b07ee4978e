#include "collision_forge/attack/realizer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "collision_forge/attack/attack_search.h"
#include "collision_forge/scene/number_words.h"

namespace forge {
namespace {

void checkPatterns(const std::vector<CollisionPattern>& patterns, const Snapshot& snapshot) {
  for (const CollisionPattern& pattern : patterns) {
    const bool known =
        std::any_of(snapshot.agents.begin(), snapshot.agents.end(),
                    [&](const Track& agent) { return agent.id == pattern.attacker_id; });
    if (!known) {
      throw std::invalid_argument("the pattern's attacker_id \"" + pattern.attacker_id +
                                  "\" is nobody in the scene");
    }
    if (!(pattern.time > snapshot.now)) {
      throw std::invalid_argument("the pattern's time is not after now");
    }
    if (!pattern.ego.center.isFinite() || !pattern.attacker_offset.isFinite() ||
        !std::isfinite(pattern.attacker_speed)) {
      throw std::invalid_argument("the pattern of attacker_id \"" + pattern.attacker_id +
                                  "\" has an ego, an attacker_offset or an attacker_speed that is "
                                  "not finite");
    }
    if (!(pattern.tolerance >= 0.0)) {
      throw std::invalid_argument("the pattern's tolerance = " + numberText(pattern.tolerance) +
                                  " is not 0 m or more");
    }
  }
}

/// Counts why attacks were not taken, for the message of a refusal.
class Rejections {
 public:
  void add(const CollisionReport& report, const CollisionRequest& request) {
    std::string kind = shortcomingOf(report, request);
    kind.erase(std::min(kind.find_first_of("0123456789"), kind.size()));  // by how much
    while (!kind.empty() && kind.back() == ' ') kind.pop_back();
    ++counts_[kind];
    if (report.verified() && request.crash.believable && !report.believable()) {
      unbelievable_ = report.unbelievable;
    }
  }

  /// Why an attack that holds would be driven by nobody; empty if there was none.
  const std::string& unbelievable() const { return unbelievable_; }

  /// Of an attack that holds, but is not exactly the pattern.
  void add(const PatternMiss& miss) {
    ++counts_["missed the pattern"];
    if (!nearest_ || miss.distance < nearest_->distance) nearest_ = miss;
  }

  std::string summary() const {
    std::string text;
    for (const auto& [reason, count] : counts_) {
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + reason;
    }
    if (!nearest_) return text;
    return text + ", the nearest by " + numberText(nearest_->distance) + " m and " +
           numberText(nearest_->heading) + " rad";
  }

 private:
  std::map<std::string, int> counts_;
  std::string unbelievable_;
  std::optional<PatternMiss> nearest_;
};

/// Every second sample, from `first` on; the known ego without samples.
std::vector<const Track*> everySecond(const Future& future, std::size_t first) {
  std::vector<const Track*> egos;
  for (std::size_t i = first; i < future.ego_samples.size(); i += 2) {
    egos.push_back(&future.ego_samples[i]);
  }
  if (egos.empty()) egos.push_back(&future.ego);
  return egos;
}

/// Verifies the attack in the futures that it should hit, until one bears it out.
bool verifyInFutures(const FoundAttack& attack, const VerificationInput& input,
                     const AttackOptions& options, Rejections& rejections, Realization& found) {
  constexpr std::size_t kTries = 4;
  const Track& agent = *attack.attacker;
  found.aim = *attack.aim;
  found.trajectory = {agent.id, agent.agent_class, agent.size, attack.points};
  Future future = input.future;
  for (std::size_t i = 0; i < std::min(kTries, attack.hits.size()); ++i) {
    future.ego = *attack.hits[i];
    found.report = verify(found.trajectory, {input.snapshot, future, input.request, input.lanes},
                          options.verification);
    if (!isAsAsked(found.report, input.request)) {
      rejections.add(found.report, input.request);
      continue;
    }
    found.miss =
        missBetween(found.aim.attacker_offset,
                    relativeTo(found.report.ego_at_contact, found.report.attacker_at_contact));
    return true;
  }
  return false;
}

/// The score on the futures that were held back, as confidence.
double confidenceIn(const VerificationInput& input, const FoundAttack& attack,
                    const AttackOptions& options) {
  if (input.future.ego_samples.empty()) return 1.0;
  const FutureScorer held_out(everySecond(input.future, 1), input.future.agents, input.request,
                              input.snapshot.now, input.lanes.map().driving_side, options);
  return confidenceOf(held_out.score(*attack.attacker, attack.points).share,
                      options.search.confidence_curve);
}

/// What was tried, and how it failed, for people.
std::string whatFailed(const std::vector<CollisionPattern>& patterns,
                       const CollisionRequest& request, const Rejections& rejections) {
  std::set<std::string> attackers;
  for (const CollisionPattern& pattern : patterns) attackers.insert(pattern.attacker_id);
  const std::string tried = "tried " + counted(patterns.size(), "collision pattern") + " of " +
                            counted(attackers.size(), "vehicle") + ": ";
  const std::string reasons = rejections.summary();
  if (reasons.empty()) {
    return tried + "no motion within the limits hits the ego as asked, " + numberText(request.tta) +
           " +- " + numberText(request.crash.time_tolerance) + " s from now";
  }
  return tried + "the best motions within the limits fail the verification: " + reasons;
}

}  // namespace

std::string shortcomingOf(const CollisionReport& report, const CollisionRequest& request) {
  if (!report.contact) return "missed the ego";
  if (!report.first_other_id.empty()) return "touched someone else first";
  if (!report.on_time) return "made contact at the wrong time";
  if (!report.type_kept) return "made contact in another way";
  if (!report.limits_kept) return "broke " + report.broken_limit;
  if (request.crash.believable && !report.believable()) {
    return "is not believable: it " + report.unbelievable;
  }
  if (request.manoeuvre && report.manoeuvre != *request.manoeuvre) {
    return std::string("is of manoeuvre ") + toString(report.manoeuvre);
  }
  if (request.ego_side && report.ego_side != *request.ego_side) {
    return std::string("touched the ego's side ") + toString(report.ego_side);
  }
  if (request.impact_speed) {
    if (report.impact_speed < request.impact_speed->min) return "hit the ego too slowly";
    if (report.impact_speed > request.impact_speed->max) return "hit the ego too fast";
  }
  if (request.overlap) {
    if (report.overlap < request.overlap->min) return "covered too little of the ego's side";
    if (report.overlap > request.overlap->max) return "covered too much of the ego's side";
  }
  return "";
}

bool isAsAsked(const CollisionReport& report, const CollisionRequest& request) {
  return shortcomingOf(report, request).empty();
}

double worthOf(const Realization& answer) { return answer.report.confidence - answer.effort; }

bool namesHow(const CollisionRequest& request) {
  return request.manoeuvre || request.ego_side || request.impact_speed || request.overlap;
}

double confidenceOf(double share, const std::vector<double>& curve) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(curve.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), curve.size() - 2);
  return curve[i] + (place - static_cast<double>(i)) * (curve[i + 1] - curve[i]);
}

Realization realize(const std::vector<CollisionPattern>& patterns, const VerificationInput& input,
                    const AttackOptions& options, bool exact, const AttackerWays& ways,
                    SearchedMotion motion) {
  checkPatterns(patterns, input.snapshot);
  const std::vector<const Track*> searched = everySecond(input.future, 0);
  const std::vector<FoundAttack> attacks =
      searchAttacks({input.snapshot, input.future, searched, patterns, input.request, input.lanes,
                     exact, ways, motion},
                    options);
  Rejections rejections;
  Realization found;
  for (const FoundAttack& attack : attacks) {
    if (!verifyInFutures(attack, input, options, rejections, found)) continue;
    if (exact && !isExact(found.miss, options.search)) {
      rejections.add(found.miss);
      continue;
    }
    found.effort = attack.effort;
    found.report.confidence = confidenceIn(input, attack, options);
    if (found.report.confidence < input.request.crash.min_confidence) {
      Realization declined;
      declined.status = {
          StatusCode::kLowConfidence,
          "the best attack has a confidence of " + percentText(found.report.confidence) +
              ", less than min_confidence = " + numberText(input.request.crash.min_confidence)};
      return declined;
    }
    return found;
  }
  Realization refused;
  if (!rejections.unbelievable().empty()) {
    refused.status = {StatusCode::kNotBelievable, "the best attacker " + rejections.unbelievable()};
    return refused;
  }
  refused.status = {StatusCode::kNoAttackWithinLimits,
                    whatFailed(patterns, input.request, rejections)};
  return refused;
}

}  // namespace forge
