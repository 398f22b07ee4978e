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

/// Settings of a rollout, apart from scenario and planner. References and `attacker` must outlive
/// the rollout.
struct RolloutSetup {
  const TrialOptions& planners;  ///< steps, traffic, score and the car that follows the plans
  const AttackOptions& attack;   ///< contact tolerance, severity, off_road_interval; bound of the
                                 ///< curvature at the start
  const CrashDefinition& crash;  ///< to classify contacts (typeOf())
  Background background = Background::kReplay;  ///< motion of the other agents
  /// If false, the ego continues through contacts until the end; only the first one is reported.
  bool ends_at_contact = true;
  /// Policy that drives the attacker, starting with the scenario's trajectory at t0; the rollout
  /// uses a copy. Null: the attacker follows that trajectory unchanged.
  const AttackerPolicy* attacker = nullptr;
};

/// Failure of a planner that ends its rollout.
enum class PlannerFailure {
  kNone,       ///< no failure
  kError,      ///< initialize() or plan() threw an exception other than PlannerTimeout and LatePlan
  kEmpty,      ///< plan() returned a trajectory without points
  kNotFinite,  ///< a number of a point is not finite
  kUnordered,  ///< times of successive points do not increase strictly
  kLate,  ///< the trajectory does not begin at the call or ends before the next call (to 1e-6 s),
          ///< or LatePlan was thrown
  kTimedOut,  ///< threw PlannerTimeout: an external planner did not respond
  kOffMap,    ///< the whole box is off the drivable area after a part was on it, tested every
              ///< VerificationOptions::off_road_interval
};
/// Returns "none", "error", "empty", "not_finite", "unordered", "late", "timed_out" or "off_map".
const char* toString(PlannerFailure failure);
/// Returns the value of a name as toString() spells it; nullopt for another name.
std::optional<PlannerFailure> plannerFailureFromString(const std::string& name);

/// The ego's first contact.
struct PlannerContact {
  std::string other_id;                           ///< Track::id of the touched agent
  bool is_attacker = false;                       ///< the touched agent is the attacker
  double time = 0.0;                              ///< s, scene clock
  ContactPlace place = ContactPlace::kElsewhere;  ///< kind of road at the middle of the ego's box
  std::optional<CollisionType> type;              ///< see typeOf(); empty if no type applies
  double relative_heading = 0.0;   ///< rad (-pi, pi], the other agent's yaw minus the ego's
  Side ego_side = Side::kFront;    ///< side of the ego's box that is touched
  Side other_side = Side::kFront;  ///< side of the other box
  double impact_speed = 0.0;       ///< m/s, norm of the relative velocity
  CrashSeverity severity;          ///< of ego and other agent
  double ego_speed = 0.0;          ///< m/s, speed of the ego at contact along its heading
  ContactCause cause = ContactCause::kLateral;  ///< see causeOf()
  bool at_fault = false;                        ///< the ego is at fault; see isAtFault()
};

/// Returns whether `a` has the larger probability of an injury of MAIS 3 or more
/// (CrashSeverity::worse()); at equal probabilities, the larger impact speed.
bool isMoreSevere(const PlannerContact& a, const PlannerContact& b);

/// Result of rollout().
struct RolloutOutcome {
  PlannerFailure failure = PlannerFailure::kNone;  ///< that ended the rollout, if any
  std::string failure_message;                     ///< for users; empty without failure
  /// First contact with any agent; nullopt if there is none.
  std::optional<PlannerContact> contact;
  /// driveCarefully() on the ego's path as driven, with the attacker as driven; empty unless the
  /// attacker hit the ego.
  std::vector<CarefulDrive> careful_drivers;
  double duration = 0.0;     ///< s from t0 to the last point of `driven`
  double max_braking = 0.0;  ///< m/s2, hardest braking of the ego, >= 0
  /// s in which the ego brakes harder than RolloutOptions::hard_braking, summed.
  double hard_braking = 0.0;
  /// Share 0..1 of the box off the drivable area, mean over the poses every
  /// VerificationOptions::off_road_interval after t0; 0 without a drivable area.
  double off_road_share = 0.0;
  double progress = 0.0;  ///< m along the route from t0 to the end, between the nearest places of
                          ///< the route; negative for an ego that drove back
  /// m along the route, of the recorded ego in the same time (at most to its last state)
  double recorded_progress = 0.0;
  /// Score of the steps up to the end, without the step of a contact that ends the rollout.
  NuplanScore nuplan;
  /// Middle of the ego's box at every RolloutOptions::step from t0 on, scene clock; the last point
  /// is at the contact, the failure or the end.
  std::vector<TrajectoryPoint> driven;
  std::vector<Track> others;  ///< motions of all agents but ego and attacker, one state per step in
                              ///< which the agent is in sight; empty with Background::kReplay
  /// From t0 on: as driven up to the end of the rollout, and as planned after it.
  AttackerTrajectory attacker;
  AttackerPhase phase = AttackerPhase::kCommitted;  ///< of the attacker at the end of the rollout
  /// AttackerPolicy::plans(): all plans, the first included.
  std::vector<AttackerPlan> attacker_plans;
  int plans = 0;                  ///< number of calls of Planner::plan()
  double planning_seconds = 0.0;  ///< s of the wall clock in initialize() and all calls of plan();
                                  ///< the only non-deterministic field
};

/// Returns the traffic of a rollout at t0. `setup` is used only during the call. Throws
/// PlannerFileError if the file of a traffic model cannot be used.
Traffic makeRolloutTraffic(const CrashScenario& scenario, const RolloutSetup& setup);

/// Returns the attacker's policy for a rollout, never null: a copy of the setup's, or one that
/// follows the scenario's trajectory.
std::unique_ptr<AttackerPolicy> makeRolloutAttacker(const CrashScenario& scenario,
                                                    const RolloutSetup& setup);

/// Simulates the planner's ego from t0 until its first contact (unless the setup says otherwise), a
/// failure of the planner or the end of the attacker's trajectory. Deterministic (apart from
/// planning_seconds). Throws as checkScenario(), routeOf(), makeRolloutTraffic() and
/// Traffic::advance(); exceptions of the planner become a PlannerFailure.
/// - Calls planner.initialize() once, then plan() every `driving.interval` seconds from t0 on; the
/// ego follows the plan as `driving` says.
/// - The start is the recorded state at t0 with the speed from estimateMotion() of the past.
/// - The attacker's policy observes every step before it moves. The last step ends with the
/// attacker's trajectory, so it may be shorter than the others (or 1 ms longer).
/// - Within a step all boxes move linearly; contacts are found to
/// VerificationOptions::overlap_tolerance. Agents that overlap the ego at t0, except the attacker,
/// are ignored.
RolloutOutcome rollout(Planner& planner, const Driving& driving, const CrashScenario& scenario,
                       const RolloutSetup& setup);

}  // namespace forge
