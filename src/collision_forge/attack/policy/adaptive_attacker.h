#pragma once

#include <memory>
#include <vector>

#include "collision_forge/attack/forecast/ego_futures.h"
#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/attack/policy/options.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/crash_definition.h"

namespace forge {

/// Input of an adaptive attacker at t0.
struct AttackerTask {
  Snapshot snapshot;                       ///< frames up to t0; its `now` is t0
  std::shared_ptr<const LaneIndex> lanes;  ///< index of the map; must not be null
  EgoVehicle ego;                          ///< size of the ego's box
  CollisionRequest request;  ///< with the crash definition filled in; its type must not be kAny
  CollisionPattern pattern;  ///< pattern from which `plan` was made
  AttackerTrajectory plan;   ///< first plan, from t0; at least two points
  double effort = 0.0;       ///< of `plan`, see Attack::effort
};

/// Models and options of adaptive attackers; may be shared by many.
struct AttackerSetup {
  /// samples how the ego may continue; must not be null
  std::shared_ptr<const EgoFutureSampler> ego_futures;
  AttackOptions attack;
  AdaptiveOptions adaptive;
};

/// Limits of adaptive attackers, whatever the request says.
inline constexpr LimitSet kAdaptiveLimits = LimitSet::kDrivable;

/// An attacker that observes the scene and replans every AdaptiveOptions::period. Each update step
/// samples how the ego may continue. If its plan hits the ego in less than
/// SearchOptions::good_share of these futures (or is off its lane), it searches a new one
/// (searchManoeuvres()) with the same type and contact time, and takes it if its
/// FoundAttack::objective is greater by more than 0.05 and, if the request requires it, the whole
/// drive is plausible. A new plan takes effect FairnessOptions::reaction_time after the
/// observation; until then the old plan is driven, and the new one continues its state, so the
/// whole drive keeps kAdaptiveLimits if the first plan does. AdaptiveOptions::commit_time before
/// the latest allowed contact the attacker commits to its plan.
///
/// It aborts, and from then on continues as normal traffic (driveOn(), planned anew at each update
/// step), if no plan hits any future or comes close to it (FutureScore::closeness below 0.02), if
/// another agent blocks a plan that hits no future (AdaptiveOptions::evade_time), if the ego is
/// lost or jumps, or once the latest allowed contact time has passed. An aborted attack never
/// resumes. A frame without ego and agents means that nothing was observed: predictions continue
/// from the previous frame.
class AdaptiveAttacker : public AttackerPolicy {
 public:
  /// `task.plan` must have at least two points, `task.snapshot.ego` at least one state. plans()
  /// then has the initial plan alone. Preconditions are not checked.
  AdaptiveAttacker(AttackerTask task, AttackerSetup setup);

  std::unique_ptr<AttackerPolicy> clone() const override {
    return std::make_unique<AdaptiveAttacker>(*this);
  }
  /// Ignores frames earlier than AdaptiveOptions::period after the last update step, and frames so
  /// late that no new motion can start before the end of the plan.
  void observe(const Frame& seen) override;
  /// See AttackerPolicy. Ends at the end of the first plan, or SearchOptions::tail after the
  /// requested contact if that is later; points are SearchOptions::step apart.
  const AttackerTrajectory& trajectory() const override { return task_.plan; }
  AttackerPhase phase() const override { return phase_; }
  /// See AttackerPolicy. Update steps that keep the plan, or continue as normal traffic after the
  /// abort, add no plan; commitment and abort add one each.
  const std::vector<AttackerPlan>& plans() const override { return plans_; }

  /// Returns the ego's observed states since t0 followed by its likeliest prediction, and the other
  /// agents' prediction from the newest frame on, up to the end of trajectory(); `ego_samples` are
  /// predictions of the ego from the newest frame on. Box centres, map frame.
  Future outlook() const;

 private:
  double timeOf(std::size_t index) const { return task_.plan.points[index].time; }
  std::size_t firstAfter(double time) const;
  bool hasJumped(const Frame& seen) const;
  Future predict(const Snapshot& snapshot) const;
  void replan(const Frame& seen, std::size_t from);
  bool touchesOthers(const Future& future, std::size_t from) const;
  void abortAttack(double seen, std::size_t from, const std::string& reason);
  void driveOnFrom(double seen, std::size_t from, const std::string& reason);
  void take(double seen, std::size_t from, std::vector<TrajectoryPoint> points,
            const std::string& reason);
  bool isBelievable(std::size_t from, const std::vector<TrajectoryPoint>& points,
                    double contact) const;
  Snapshot asOf(std::size_t from, Snapshot snapshot) const;
  ReferencePath ownWay() const;
  Underway underwayFrom(std::size_t from) const;

  AttackerTask task_;  // its plan: the part driven so far, then the planned part
  AttackerSetup setup_;
  AttackOptions planning_;  // for new plans
  Track vehicle_;           // without states
  DriveLimits limits_;
  SceneHistory scene_;
  double impact_;                     // s, scene clock; requested contact time
  double last_update_;                // s, time of the last update step
  double last_ego_;                   // s, time at which the ego was last observed
  std::vector<AgentState> seen_ego_;  // from t0 to the last update step
  AttackerPhase phase_ = AttackerPhase::kAttacking;
  /// Draft of the plan; contact and wait are times on the scene clock, s.
  std::optional<DraftedPath> drafted_;
  std::vector<AttackerPlan> plans_;
};

}  // namespace forge
