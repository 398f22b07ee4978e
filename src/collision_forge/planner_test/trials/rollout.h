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

/// Everything that a rollout depends on, beside scenario and planner.
struct RolloutSetup {
  const TrialOptions& planners;
  const AttackOptions& attack;   ///< of contacts: tolerance; of the start's motion
  const TypeDefinitions& types;  ///< what contacts are told to be of
  Background background = Background::kReplay;
  /// Otherwise the ego drives on to the end, through whom it touches.
  bool ends_at_contact = true;
  /// Who drives the attacker, from the scenario's trajectory on; null: that trajectory as it is. A
  /// copy of it does.
  const AttackerPolicy* attacker = nullptr;
};

/// What a planner did that ended its rollout.
enum class PlannerFailure {
  kNone,
  kError,      ///< threw, at the start or when called
  kEmpty,      ///< a trajectory without points
  kNotFinite,  ///< a number that is none
  kUnordered,  ///< times that do not increase
  kLate,       ///< a trajectory that does not span from now to the next call, or LatePlan
  kTimedOut,   ///< threw PlannerTimeout: who should have planned did not answer
  kOffMap,     ///< the whole car left the drivable area
};
/// "none", "error", "empty", "not_finite", "unordered", "late", "timed_out", "off_map".
const char* toString(PlannerFailure failure);
std::optional<PlannerFailure> plannerFailureFromString(const std::string& name);

/// The ego's first contact.
struct PlannerContact {
  std::string other_id;
  bool is_attacker = false;
  double time = 0.0;                              ///< s, the scene's clock
  ContactPlace place = ContactPlace::kElsewhere;  ///< of the ego
  std::optional<CollisionType> type;              ///< see typeOf(); empty when it is of none
  double relative_heading = 0.0;   ///< rad (-pi, pi], the other's yaw minus the ego's
  Side ego_side = Side::kFront;    ///< of the ego's box, where the other's touches it
  Side other_side = Side::kFront;  ///< of the other's box
  double impact_speed = 0.0;       ///< m/s, norm of the relative velocity
  double ego_speed = 0.0;          ///< m/s
  ContactCause cause = ContactCause::kLateral;
  bool at_fault = false;
};

struct RolloutOutcome {
  PlannerFailure failure = PlannerFailure::kNone;
  std::string failure_message;  ///< for people: what the planner returned; empty without failure
  std::optional<PlannerContact> contact;
  double duration = 0.0;           ///< s from now to the contact, the failure or the attacker's end
  double max_braking = 0.0;        ///< m/s2, hardest braking of the ego, not negative
  double hard_braking = 0.0;       ///< s that it braked harder than `hard_braking`
  double off_road_share = 0.0;     ///< mean share of the box off the drivable area
  double progress = 0.0;           ///< m along the route
  double recorded_progress = 0.0;  ///< m along the route, of the recorded ego over the same time
  NuplanScore nuplan;
  std::vector<TrajectoryPoint> driven;  ///< the ego every step, the last at the end
  std::vector<Track> others;    ///< those who react (Background::kIdm), as they drove, every step
  AttackerTrajectory attacker;  ///< as it drove up to the end, and meant to after it
  AttackerPhase phase = AttackerPhase::kCommitted;  ///< of the attacker at the end
  std::vector<AttackerPlan> attacker_plans;         ///< AttackerPolicy::plans()
  int plans = 0;                                    ///< calls of the planner
  double planning_seconds = 0.0;  ///< of computing in these calls; the one thing that is measured
};

/// Who drives the attacker of a rollout, as it sets out.
std::unique_ptr<AttackerPolicy> attackerOf(const CrashScenario& scenario,
                                           const RolloutSetup& setup);

/// Drives the ego by the planner from now on until its first contact (unless the setup says
/// otherwise), a failure of the planner or the end of the attacker's trajectory. Whoever drives the
/// attacker is shown every step as it comes. The start is the recorded state now, its speed told
/// from the past (estimateMotion()). Within a step ego and others move linearly, so contacts are
/// found to `overlap_tolerance`. Who overlaps the ego already now, the attacker aside, is not
/// looked at. Same input, same outcome (planning_seconds aside). Throws as checkScenario() and
/// routeOf().
RolloutOutcome rollout(Planner& planner, const Driving& driving, const CrashScenario& scenario,
                       const RolloutSetup& setup);

}  // namespace forge
