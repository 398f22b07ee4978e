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

/// The one place that says what is wrong with an attack.
namespace forge {

/// Why an attack with this report is not what was asked for, for people: "missed the ego", ...;
/// empty where it is.
std::string shortcomingOf(const CollisionReport& report, const CollisionRequest& request);

/// Verified, believable if the request wants that, and of the manoeuvre, the ego's side, the
/// impact speed and the overlap that it names.
bool isAsAsked(const CollisionReport& report, const CollisionRequest& request);

/// Returns kOk for an attack with status kOk that is as asked and by an attacker of the requested
/// kind, else the status that declines it. An attack with another status keeps that status.
Status verdictOn(const Realization& answer, const CollisionRequest& request);

/// What speaks for an answer: its confidence less its effort.
double worthOf(const Realization& answer);

/// The request names more than a type, a time and an attacker: how the crash shall be.
bool namesHow(const CollisionRequest& request);

/// What a share of the futures is worth as confidence: linear between the points of `curve`, which
/// are evenly spread over shares from 0 to 1.
double confidenceOf(double share, const std::vector<double>& curve);

/// Judges attacks on one request, whoever found them, in the futures of the ego: every second one
/// may be searched, the share of the others tells the confidence. An ego without samples is known,
/// and the confidence is 1. Counts why attacks were declined. Not thread-safe.
class AttackJudge {
 public:
  /// `input` and `options` must outlive the judge. `exact`: a contact that is not at its aim
  /// (isExact()) is declined.
  AttackJudge(const VerificationInput& input, const AttackOptions& options, bool exact);

  /// The futures of the ego that may be searched, at least one.
  const std::vector<const Track*>& searched() const { return searched_; }

  /// Verifies the attack in the first four of these futures, until one bears it out as asked, and
  /// fills in report, miss and confidence from that one. `attack` has an aim and a trajectory,
  /// `attacker` is its track in the snapshot. Returns whether the attack is an answer.
  bool accepts(Realization& attack, const Track& attacker, const std::vector<const Track*>& egos);

  /// Why none of the attacks that came from these patterns was accepted.
  Status refusal(const std::vector<CollisionPattern>& patterns) const;

 private:
  void reject(const CollisionReport& report);
  bool isVerifiedIn(Realization& attack, const Track& ego);
  double confidenceIn(const Track& attacker, const std::vector<TrajectoryPoint>& points);
  std::string whatFailed(const std::vector<CollisionPattern>& patterns) const;

  const VerificationInput& input_;
  const AttackOptions& options_;
  bool exact_;
  std::vector<const Track*> searched_;
  Future tried_;                           // the one whose ego is being tried
  std::optional<FutureScorer> held_out_;   // made when the first confidence is asked for
  std::map<std::string, int> rejections_;  // by shortcoming
  std::string unbelievable_;  // why no driver would drive the last attack that is else as asked
  std::optional<PatternMiss> nearest_;  // of the attacks that hold and miss their aim
  std::optional<double> surest_;        // confidence of those that promise too little
};

}  // namespace forge
