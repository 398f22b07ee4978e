#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/search/future_scorer.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/scene/attack.h"

/// The only place that decides whether an attack meets its request.
namespace forge {

/// Returns the range, s, of `visible_for` that a request with `hidden_by` has if it names none:
/// long enough to be seen, and too short for most drivers to react and stop. A leader leaves its
/// lane earlier than a pedestrian steps out.
constexpr Range usualSight(Hider hider) {
  return hider == Hider::kLeader ? Range{0.3, 3.5} : Range{0.3, 2.0};
}

/// Returns why an attack with this report violates the request, worded to follow the attack
/// ("missed the ego"); empty if it meets the request.
std::string shortcomingOf(const CollisionReport& report, const CollisionRequest& request);

/// Returns true if shortcomingOf() is empty: the attack is verified, plausible (if required), and
/// has the requested manoeuvre, side of the ego, impact speed, overlap and conditions
/// (asksForConditions()).
bool meetsRequest(const CollisionReport& report, const CollisionRequest& request);

/// Returns kOk if an attack with status kOk meets the request and its attacker is of the requested
/// id, class and choice, else the status that rejects it: kNotBelievable if only plausibility
/// fails, else kNoAttackWithinLimits. Another status is returned unchanged.
Status verdictOn(const Attack& answer, const CollisionRequest& request);

/// Returns the score by which attacks are compared, greater is better: confidence minus effort.
double scoreOf(const Attack& answer);

/// Returns true if the request constrains manoeuvre, side of the ego, impact speed, overlap or a
/// condition (asksForConditions()).
bool hasConstraints(const CollisionRequest& request);

/// Returns the confidence 0..1 for a share 0..1 of futures hit: piecewise linear through the points
/// of `curve` (at least two), evenly spaced over the shares. A share outside [0, 1] is clamped.
double confidenceOf(double share, const std::vector<double>& curve);

/// Accepts or rejects attacks on one request, from any realiser, and counts the reasons. Every
/// second sampled ego future is available to the search; the others give the confidence. If the
/// ego's future is known, the confidence is 1. Not thread-safe.
class AttackJudge {
 public:
  /// `input` and `options` must outlive this object. `exact`: reject contacts that are not at the
  /// pattern (isExact()). `input.future` holds the sampled futures, or the known one without
  /// samples.
  AttackJudge(const VerificationInput& input, const AttackOptions& options, bool exact);

  /// Returns the ego futures available to the search, at least one; they point into `input.future`.
  const std::vector<const Track*>& searched() const { return searched_; }

  /// Verifies `attack` in the first four futures of `egos` (FoundAttack::hits) until it meets the
  /// request in one, and sets report, miss and confidence from that one. `attack` needs pattern and
  /// trajectory; `attacker` is its track in the snapshot. Returns true if the attack is accepted:
  /// it meets the request and its confidence is at least min_confidence. For refusal(), a
  /// rejected attack that meets the request in no future adds 1 to the count of its reason in the
  /// first future tried, and an attack rejected by `exact` adds 1 to the misses of the pattern; low
  /// confidence is kept apart, as the highest one. The report of a rejected attack is the last one
  /// tried. Without `egos` the attack is rejected and not counted.
  bool accepts(Attack& attack, const Track& attacker, const std::vector<const Track*>& egos);

  /// Returns the status that explains why accepts() accepted no attack from these patterns:
  /// kLowConfidence with the highest confidence if one attack failed by that alone, else
  /// kNotBelievable if one failed by plausibility alone, else kNoAttackWithinLimits with the
  /// counted reasons. `patterns`: the patterns tried, whose number and number of attackers the last
  /// message names.
  Status refusal(const std::vector<CollisionPattern>& patterns) const;

 private:
  void countRejection(const CollisionReport& report);
  bool isVerifiedIn(Attack& attack, const Track& ego);
  double confidenceIn(const Track& attacker, const std::vector<TrajectoryPoint>& points);
  std::string failureText(const std::vector<CollisionPattern>& patterns) const;

  const VerificationInput& input_;
  const AttackOptions& options_;
  bool exact_;
  std::vector<const Track*> searched_;
  Future tried_;                           // with the ego future under test
  std::optional<FutureScorer> held_out_;   // created at the first use
  std::map<std::string, int> rejections_;  // attacks by the reason of their first future
  std::string unbelievable_;  // why the last attack that only fails plausibility is implausible
  std::optional<PatternMiss> nearest_;  // of verified attacks that miss their pattern
  std::optional<double> surest_;        // highest confidence below the minimum
};

}  // namespace forge
