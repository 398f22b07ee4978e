#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/network/foresight.h"
#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/planner_test/trials/avoidability.h"
#include "collision_forge/planner_test/trials/escape.h"
#include "collision_forge/planner_test/trials/planner_case.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// What is kept of an Avoidability, or of findEscape().
struct AvoidabilitySummary {
  bool is_avoidable = false;
  std::vector<EvasiveManoeuvre>
      from_now;  ///< those that work from now on; not asked of findEscape()
  EvasiveManoeuvre last =
      EvasiveManoeuvre::kKeeping;  ///< these three with is_avoidable: the witness with the
  double last_after = 0.0;         ///< latest start, s from now
  double off_road_share = 0.0;
};

/// Who is tested, and against whom.
struct TestPlan {
  std::vector<std::string> planners;
  Background background = Background::kReplay;
  std::vector<PolicyKind> policies = {PolicyKind::kFixed};
  Foresight foresight = {};  ///< of adaptive attackers
};

/// What tables call a planner that is tested against such an attacker: its own name where the
/// attacker is fixed.
std::string rowName(const std::string& planner, PolicyKind policy);
/// Of all rows of a plan, in their order: the policies of a planner beside each other.
std::vector<std::string> rowNames(const TestPlan& plan);

/// What became of an attacker.
struct AttackerSummary {
  PolicyKind policy = PolicyKind::kFixed;
  AttackerPhase phase = AttackerPhase::kCommitted;  ///< at the end
  int plans = 0;                                    ///< that it made, the first one counted
  std::string broken_limit;  ///< that it was to keep, by what it drove; empty where all are kept
  /// Whom it touched before the end, the ego aside; empty if nobody, and where the others react.
  std::string touched;
  /// It touched the ego as the type that was asked for, at most the tolerance before or after the
  /// time asked for.
  bool as_asked = false;
};

/// One planner in one case. The motions of the outcome and `escape_drive` are there until
/// dropMotions().
struct PlannerRow {
  std::string planner;
  RolloutOutcome outcome;
  AttackerSummary attacker;
  /// Where the attacker has hit the ego: findEscape().
  std::optional<AvoidabilitySummary> escape = {};
  std::optional<Escape> escape_drive = {};  ///< with an escape
  /// False of a hit that the ego could not have escaped, driving as it did, for at least
  /// FairnessOptions::avoidable_for.
  bool is_fair = true;
  /// In a clip of COLLIDE: the published protocol sees the attacker hit the ego that the planner
  /// drives to the last frame, through whom it may touch (PublishedProtocol).
  std::optional<bool> published_hit = {};
};

/// Status of a case that cannot be read: its name alone is known.
inline constexpr const char* kUnreadable = "UNREADABLE";

/// Status of a case that nobody can be driven through.
inline constexpr const char* kUnfit = "UNFIT";

/// All planners in one case.
struct PlannerTestResult {
  std::string name;
  std::string source;  ///< these five with isRead()
  std::string scene;
  CollisionType type = CollisionType::kRearEnd;
  double tta = 0.0;
  double now = 0.0;  ///< s, the scene's clock
  Background background = Background::kReplay;
  std::string status;      ///< "OK", a StatusCode, kUnreadable or kUnfit: nothing to test on
  std::string message;     ///< for people; empty with OK
  bool is_strict = false;  ///< with OK: all conditions of the strict protocol against the recording
  AvoidabilitySummary avoidability;  ///< these two with OK
  /// With OK a row a planner and policy, in the order of rowNames(). Of an unfit clip idm_published
  /// alone, with `published_hit` alone: that test drives the clip from its first frame.
  std::vector<PlannerRow> rows;

  bool isTested() const { return status == "OK"; }
  bool isRead() const { return status != kUnreadable; }
};

/// A result without anything tested.
PlannerTestResult untested(const PlannerCase& one, const std::string& status,
                           const std::string& message);

/// Tells what a case is without a planner: its status and, with OK, whether it is strict and
/// avoidable. A case that checkScenario() refuses is kUnfit.
PlannerTestResult judgeCase(const PlannerCase& one, const AnswerOptions& options,
                            const TrialOptions& trials);

/// Who drives the attacker of a case; null for PolicyKind::kFixed.
std::unique_ptr<AttackerPolicy> makeAttacker(const PlannerCase& one, PolicyKind policy,
                                             const Foresight& foresight,
                                             const AnswerOptions& options);

/// Drives a planner through a case that judgeCase() finds OK; of the plan the background and the
/// foresight count. Throws std::invalid_argument for an unknown planner.
PlannerRow testPlanner(const PlannerCase& one, const std::string& planner, PolicyKind policy,
                       const TestPlan& plan, const AnswerOptions& options,
                       const TrialOptions& trials);

/// Removes the motions from the rows: what the tables need is small.
void dropMotions(PlannerTestResult& result);

/// Drives every planner of the plan through the case as judgeCase() finds it, against an attacker
/// of each policy; rows as PlannerTestResult has them. Throws as testPlanner().
PlannerTestResult testPlanners(const PlannerCase& one, const TestPlan& plan,
                               const AnswerOptions& options, const TrialOptions& trials);

}  // namespace forge
