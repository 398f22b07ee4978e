#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/network/prediction_models.h"
#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/planner_test/trials/avoidability.h"
#include "collision_forge/planner_test/trials/evasion.h"
#include "collision_forge/planner_test/trials/planner_case.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// Summary of an Avoidability or of findEvasion().
struct AvoidabilitySummary {
  bool is_avoidable = false;               ///< a witness is known
  std::vector<EvasiveManoeuvre> from_now;  ///< kinds that work from t0, in the order of
                                           ///< Avoidability::from_now; empty for findEvasion()
  EvasiveManoeuvre last = EvasiveManoeuvre::kKeeping;  ///< kind of the witness with the latest
                                                       ///< start; valid if avoidable
  double last_after = 0.0;  ///< s after t0, start of this witness; valid if avoidable
  /// Share 0..1 of the box off the drivable area, mean over this witness; valid if avoidable.
  double off_road_share = 0.0;
};

/// Configuration of a test: every planner meets every policy in every background.
struct TestPlan {
  std::vector<std::string> planners;                            ///< elements of plannerNames()
  std::vector<Background> backgrounds = {Background::kReplay};  ///< motions of the other agents
  std::vector<PolicyKind> policies = {PolicyKind::kFixed};      ///< of the attacker
  PredictionModels models = {};  ///< of adaptive attackers; unused by fixed ones
};

/// Identifies a row of a test: the planner, its attacker, and the motion of the other agents.
struct RowKey {
  std::string planner;                          ///< name of the planner, or of its variant
  PolicyKind policy = PolicyKind::kFixed;       ///< of the attacker
  Background background = Background::kReplay;  ///< motion of the other agents
};

/// Returns the title of a row: the planner's name, then " against adaptive" unless the attacker is
/// fixed, then " in BACKGROUND traffic" unless it is replayed.
std::string rowName(const RowKey& key);
/// Returns the rows of a plan: planners in the outer loop, then policies, then backgrounds, in
/// their order.
std::vector<RowKey> rowKeys(const TestPlan& plan);
/// Returns rowName() of each of rowKeys().
std::vector<std::string> rowNames(const TestPlan& plan);
/// Returns the file name, without an ending, of the picture of the rank-th worst hit of a row, from
/// 1 on: "PLANNER_POLICY_RANK", with the background before the rank unless it is replayed.
std::string pictureName(const RowKey& key, int rank);

/// State of an attacker at the end of a rollout.
struct AttackerSummary {
  PolicyKind policy = PolicyKind::kFixed;           ///< that drove the attacker
  AttackerPhase phase = AttackerPhase::kCommitted;  ///< at the end of the rollout
  int plans = 0;                                    ///< number of its plans, including the first
  std::string broken_limit;  ///< limit that its motion violated; empty if none
  /// Id of the agent that it touched before the end, the ego excluded; empty if none, and if the
  /// other agents are reactive.
  std::string touched;
  /// It hit the ego with the requested type, within CrashDefinition::time_tolerance of the
  /// requested time.
  bool as_asked = false;
};

/// Result of one planner in one case. dropMotions() removes the motions of the outcome and
/// `evasion_drive`.
struct PlannerRow {
  std::string planner;       ///< name of the planner, or of its variant
  RolloutOutcome outcome;    ///< of rollout()
  AttackerSummary attacker;  ///< of the same rollout
  /// Result of findEvasion(); set if and only if the attacker hit the ego.
  std::optional<AvoidabilitySummary> evasion = {};
  std::optional<Evasion> evasion_drive = {};  ///< set if `evasion` is avoidable
  /// False for a hit by the attacker without a known evasive manoeuvre that starts at least
  /// FairnessOptions::avoidable_for after t0, and for one that the driver
  /// FairnessOptions::avoidable_by (if set) does not avoid. True without a hit.
  bool is_fair = true;
  /// For a clip of COLLIDE: whether the attacker hits the planner's ego by the published protocol
  /// (PublishedProtocol). The ego drives to the last frame, even through contacts. Empty for other
  /// cases, adaptive attackers and after a failure of the planner.
  std::optional<bool> published_hit = {};
  Background background = Background::kReplay;  ///< motion of the other agents
};

/// Returns planner, policy and background of the row.
RowKey keyOf(const PlannerRow& row);
/// Returns rowName() of keyOf().
std::string rowName(const PlannerRow& row);

/// Status of a case that cannot be read; only its name is known.
inline constexpr const char* kUnreadable = "UNREADABLE";

/// Status of a case that checkScenario() rejects.
inline constexpr const char* kUnfit = "UNFIT";

/// Results of all planners in one case.
struct PlannerTestResult {
  std::string name;  ///< PlannerCase::name
  // Valid with isRead():
  std::string source;                            ///< PlannerCase::source
  std::string scene;                             ///< name of the scene
  CollisionType type = CollisionType::kRearEnd;  ///< requested type
  double tta = 0.0;                              ///< s, requested TTA
  double now = 0.0;                              ///< s, scene clock; t0
  // Valid for all results:
  /// "OK", or why there is no test: the name of a StatusCode, kUnreadable or kUnfit.
  std::string status;
  std::string message;     ///< for users; empty with OK
  bool is_strict = false;  ///< with OK: meets the strict protocol against the recording
  /// findAvoidability(); valid with OK, like the next two fields.
  AvoidabilitySummary avoidability;
  /// driveCarefully() in the recorded ego's place.
  std::vector<CarefulDrive> careful_drivers;
  /// With OK one row per planner, policy and background, ordered as rowKeys(). An unfit clip has
  /// one row, idm_published, with only `published_hit` set: that test drives the clip from its
  /// first frame.
  std::vector<PlannerRow> rows;

  /// Returns true if the planners were tested in the case.
  bool isTested() const { return status == "OK"; }
  /// Returns true if the case could be read.
  bool isRead() const { return status != kUnreadable; }
};

/// Returns a result without rows, with this status and message and the names and request of the
/// case.
PlannerTestResult untested(const PlannerCase& one, const std::string& status,
                           const std::string& message);

/// Returns the evaluation of a case without a planner: its status and, with OK, whether it is
/// strict and avoidable, and the careful drivers; no rows. A case that checkScenario() rejects is
/// kUnfit. Does not modify the case; may run on any thread.
PlannerTestResult evaluateCase(const PlannerCase& one, const AnswerOptions& options,
                               const TrialOptions& trials);

/// Returns the attacker's policy for a case, starting with its attack; null for PolicyKind::kFixed,
/// and for an attacker that reverses, which keeps to its plan.
/// `models`: used by an adaptive attacker, without anything learned from the case's scene.
std::unique_ptr<AttackerPolicy> makeAttacker(const PlannerCase& one, PolicyKind policy,
                                             const PredictionModels& models,
                                             const AnswerOptions& options);

/// Returns the result of the planner of a row in a case that evaluateCase() found OK: rollout(),
/// after a hit by the attacker findEvasion() and fairness, and for a clip the published protocol.
/// `models`: of adaptive attackers. `options`: verification, crash definition, adaptive attackers,
/// fairness; `trials`: planners, traffic and rollouts. Throws std::invalid_argument for an unknown
/// planner, PlannerFileError if the file of a planner or of a traffic model cannot be used, and
/// std::runtime_error, naming the file, for a failure of a traffic model; failures of the planner
/// are in the outcome.
PlannerRow testPlanner(const PlannerCase& one, const RowKey& key, const PredictionModels& models,
                       const AnswerOptions& options, const TrialOptions& trials);

/// Removes the motions from the rows to save memory: `driven`, `others`, `attacker` and
/// `attacker_plans` of the outcome, and `evasion_drive`. Tables do not need them.
void dropMotions(PlannerTestResult& result);

/// Runs evaluateCase(), then every planner of the plan with each policy and background; rows as
/// in PlannerTestResult. Throws as testPlanner().
PlannerTestResult testPlanners(const PlannerCase& one, const TestPlan& plan,
                               const AnswerOptions& options, const TrialOptions& trials);

}  // namespace forge
