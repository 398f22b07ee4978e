#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/planner_test/planners/planner.h"
#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/planner_test/trials/crash_scenario.h"
#include "collision_forge/planner_test/trials/nuplan_score.h"
#include "collision_forge/planner_test/trials/options.h"
#include "collision_forge/planner_test/trials/traffic.h"

namespace forge {

/// Settings of a rollout, apart from scenario and planner.
struct RolloutSetup {
  const TrialOptions& planners;
  const AttackOptions& attack;   ///< contact tolerance; motion estimation at the start
  const CrashDefinition& crash;  ///< to classify contacts
  Background background = Background::kReplay;
  /// If false, the ego continues through contacts until the end.
  bool ends_at_contact = true;
  /// Policy that drives the attacker, starting with the scenario's trajectory; the rollout uses a
  /// copy. Null: the attacker follows that trajectory unchanged.
  const AttackerPolicy* attacker = nullptr;
};

/// Failure of a planner that ends its rollout.
enum class PlannerFailure {
  kNone,
  kError,      ///< initialize() or plan() threw an exception
  kEmpty,      ///< a trajectory without points
  kNotFinite,  ///< a number is not finite
  kUnordered,  ///< times do not increase
  kLate,       ///< a trajectory that does not span from the call to the next call, or LatePlan
  kTimedOut,   ///< threw PlannerTimeout: an external planner did not respond
  kOffMap,     ///< the whole box left the drivable area
};
/// Returns "none", "error", "empty", "not_finite", "unordered", "late", "timed_out" or "off_map".
const char* toString(PlannerFailure failure);
/// Returns the value of a name as toString() spells it; nullopt for another name.
std::optional<PlannerFailure> plannerFailureFromString(const std::string& name);

/// The ego's first contact.
struct PlannerContact {
  std::string other_id;                           ///< id of the touched agent
  bool is_attacker = false;                       ///< the touched agent is the attacker
  double time = 0.0;                              ///< s, scene clock
  ContactPlace place = ContactPlace::kElsewhere;  ///< of the ego
  std::optional<CollisionType> type;              ///< see typeOf(); empty if no type applies
  double relative_heading = 0.0;   ///< rad (-pi, pi], the other agent's yaw minus the ego's
  Side ego_side = Side::kFront;    ///< side of the ego's box that is touched
  Side other_side = Side::kFront;  ///< side of the other box
  double impact_speed = 0.0;       ///< m/s, norm of the relative velocity
  CrashSeverity severity;          ///< of ego and other agent
  double ego_speed = 0.0;          ///< m/s, speed of the ego at contact
  ContactCause cause = ContactCause::kLateral;
  bool at_fault = false;  ///< of the ego; see isAtFault()
};

/// Returns whether `a` has the larger probability of an injury of MAIS 3 or more; at equal
/// probabilities, the larger impact speed.
bool isMoreSevere(const PlannerContact& a, const PlannerContact& b);

/// Result of rollout().
struct RolloutOutcome {
  PlannerFailure failure = PlannerFailure::kNone;
  std::string failure_message;  ///< for users; empty without failure
  std::optional<PlannerContact> contact;
  /// driveCarefully() on the ego's path as driven; empty unless the attacker hit the ego.
  std::vector<CarefulDrive> careful_drivers;
  double duration = 0.0;           ///< s from t0 to the contact, the failure or the attacker's end
  double max_braking = 0.0;        ///< m/s2, hardest braking of the ego, >= 0
  double hard_braking = 0.0;       ///< s of braking harder than RolloutOptions::hard_braking
  double off_road_share = 0.0;     ///< share 0..1 of the box off the drivable area, mean
  double progress = 0.0;           ///< m along the route
  double recorded_progress = 0.0;  ///< m along the route, of the recorded ego in the same time
  NuplanScore nuplan;
  std::vector<TrajectoryPoint> driven;  ///< the ego at every step; the last point is at the end
  std::vector<Track> others;            ///< other agents unless they replay their recording
  AttackerTrajectory attacker;          ///< as driven up to the end, and as planned after it
  AttackerPhase phase = AttackerPhase::kCommitted;  ///< of the attacker at the end
  std::vector<AttackerPlan> attacker_plans;         ///< AttackerPolicy::plans()
  int plans = 0;                                    ///< number of calls of the planner
  double planning_seconds =
      0.0;  ///< s of computing time in these calls; the only non-deterministic field
};

/// Creates the traffic of a rollout at t0. Throws PlannerFileError if the file of a traffic model
/// cannot be used.
Traffic makeRolloutTraffic(const CrashScenario& scenario, const RolloutSetup& setup);

/// Creates the attacker's policy for a rollout: a copy of the setup's, or one that follows the
/// scenario's trajectory.
std::unique_ptr<AttackerPolicy> makeRolloutAttacker(const CrashScenario& scenario,
                                                    const RolloutSetup& setup);

/// Simulates the planner's ego from t0 until its first contact (unless the setup says otherwise), a
/// failure of the planner or the end of the attacker's trajectory.
/// - The start is the recorded state at t0 with the speed from estimateMotion() of the past.
/// - The attacker's policy observes every step before it moves.
/// - Within a step all boxes move linearly; contacts are found to `overlap_tolerance`. Agents that
///   overlap the ego at t0, except the attacker, are ignored.
/// Deterministic (apart from planning_seconds). Throws as checkScenario() and routeOf(); exceptions
/// of the planner become a PlannerFailure.
RolloutOutcome rollout(Planner& planner, const Driving& driving, const CrashScenario& scenario,
                       const RolloutSetup& setup);

}  // namespace forge
