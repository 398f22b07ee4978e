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
  std::vector<EvasiveManoeuvre> from_now;  ///< kinds that work from t0; not set for findEvasion()
  EvasiveManoeuvre last = EvasiveManoeuvre::kKeeping;  ///< of the witness with the latest start
  double last_after = 0.0;                             ///< s after t0, start of this witness
  double off_road_share = 0.0;  ///< share 0..1 of the box off the drivable area, mean
};

/// Configuration of a test: planners, background traffic and attacker policies.
struct TestPlan {
  std::vector<std::string> planners;
  std::vector<Background> backgrounds = {Background::kReplay};
  std::vector<PolicyKind> policies = {PolicyKind::kFixed};
  PredictionModels models = {};  ///< of adaptive attackers
};

/// Identifies a row of a test: the planner, its attacker, and the motion of the other agents.
struct RowKey {
  std::string planner;
  PolicyKind policy = PolicyKind::kFixed;
  Background background = Background::kReplay;
};

/// Returns the title of a row: the planner's own name for a fixed attacker in replayed traffic.
std::string rowName(const RowKey& key);
/// Returns the rows of a plan, in order; the rows of each planner are adjacent.
std::vector<RowKey> rowKeys(const TestPlan& plan);
/// Returns the titles of rowKeys().
std::vector<std::string> rowNames(const TestPlan& plan);
/// Returns the name, without an ending, of the rank-th picture of a row, from 1 on.
std::string pictureName(const RowKey& key, int rank);

/// State of an attacker at the end of a rollout.
struct AttackerSummary {
  PolicyKind policy = PolicyKind::kFixed;
  AttackerPhase phase = AttackerPhase::kCommitted;  ///< at the end
  int plans = 0;                                    ///< number of its plans, including the first
  std::string broken_limit;  ///< limit that its motion violated; empty if none
  /// Id of the agent that it touched before the end, the ego excluded; empty if none, and if the
  /// other agents are reactive.
  std::string touched;
  /// It hit the ego with the requested type, within the tolerance of the requested time.
  bool as_asked = false;
};

/// Result of one planner in one case. dropMotions() removes the motions of the outcome and
/// `evasion_drive`.
struct PlannerRow {
  std::string planner;
  RolloutOutcome outcome;
  AttackerSummary attacker;
  /// Result of findEvasion(); set if the attacker hit the ego.
  std::optional<AvoidabilitySummary> evasion = {};
  std::optional<Evasion> evasion_drive = {};  ///< set if `evasion` is avoidable
  /// False for a hit without a known evasive manoeuvre that starts at least
  /// FairnessOptions::avoidable_for after t0, or that FairnessOptions::avoidable_by does not avoid.
  bool is_fair = true;
  /// For a clip of COLLIDE: whether the attacker hits the planner's ego by the published protocol
  /// (PublishedProtocol). The ego drives to the last frame, even through contacts.
  std::optional<bool> published_hit = {};
  Background background = Background::kReplay;  ///< motion of the other agents
};

RowKey keyOf(const PlannerRow& row);
/// Returns rowName() of keyOf().
std::string rowName(const PlannerRow& row);

/// Status of a case that cannot be read; only its name is known.
inline constexpr const char* kUnreadable = "UNREADABLE";

/// Status of a case that checkScenario() rejects.
inline constexpr const char* kUnfit = "UNFIT";

/// Results of all planners in one case.
struct PlannerTestResult {
  std::string name;
  // Valid with isRead():
  std::string source;  ///< PlannerCase::source
  std::string scene;   ///< name
  CollisionType type = CollisionType::kRearEnd;
  double tta = 0.0;  ///< s, requested
  double now = 0.0;  ///< s, scene clock; t0
  // Valid for all results:
  std::string status;      ///< "OK", or why there is no test: a StatusCode, kUnreadable or kUnfit
  std::string message;     ///< for users; empty with OK
  bool is_strict = false;  ///< with OK: meets the strict protocol against the recording
  AvoidabilitySummary avoidability;  ///< valid with OK, like the next two fields
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

/// Returns a result without rows.
PlannerTestResult untested(const PlannerCase& one, const std::string& status,
                           const std::string& message);

/// Evaluates a case without a planner: its status and, with OK, whether it is strict and avoidable.
/// A case that checkScenario() rejects is kUnfit.
PlannerTestResult evaluateCase(const PlannerCase& one, const AnswerOptions& options,
                               const TrialOptions& trials);

/// Creates the attacker's policy for a case; null for PolicyKind::kFixed.
std::unique_ptr<AttackerPolicy> makeAttacker(const PlannerCase& one, PolicyKind policy,
                                             const PredictionModels& models,
                                             const AnswerOptions& options);

/// Runs the planner of a row through a case that evaluateCase() found OK. `models`: of adaptive
/// attackers. Throws std::invalid_argument for an unknown planner, and std::runtime_error, naming
/// the file, for a failure of a traffic model.
PlannerRow testPlanner(const PlannerCase& one, const RowKey& key, const PredictionModels& models,
                       const AnswerOptions& options, const TrialOptions& trials);

/// Removes the motions from the rows to save memory; tables do not need them.
void dropMotions(PlannerTestResult& result);

/// Runs evaluateCase(), then every planner of the plan with each policy and background; rows as
/// in PlannerTestResult. Throws as testPlanner().
PlannerTestResult testPlanners(const PlannerCase& one, const TestPlan& plan,
                               const AnswerOptions& options, const TrialOptions& trials);

}  // namespace forge
