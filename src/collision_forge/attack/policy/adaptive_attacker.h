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

/// What an adaptive attacker is told at the attack's now.
struct AttackerTask {
  Snapshot snapshot;  ///< known at now
  std::shared_ptr<const LaneIndex> lanes;
  EgoVehicle ego;
  CollisionRequest request;  ///< with what counts as the crash
  CollisionPattern aim;      ///< that the first plan came from
  AttackerTrajectory plan;   ///< the first one, from now on; at least two points
  double effort = 0.0;       ///< of the first plan, Realization::effort
};

/// What adaptive attackers know and are tuned by.
struct AttackerSetup {
  std::shared_ptr<const EgoFutureSampler> ego_futures;
  AttackOptions attack;
  AdaptiveOptions adaptive;
};

/// What attackers that see and react drive by, whatever limits a request names.
inline constexpr LimitSet kAdaptiveLimits = LimitSet::kDrivable;

/// An attacker that sees and reacts: at every frame it asks how the ego may drive on from there,
/// and where its plan does not meet most of these futures as asked, it plans the rest anew
/// (searchManoeuvres()), to the same type at the same instant. What it sees changes what it drives
/// FairnessOptions::reaction_time later; until then it drives what it had planned, and goes on from
/// the state that this leads to. So the whole drive keeps kAdaptiveLimits, if its first plan does.
/// It commits shortly before the contact. Where no plan comes near the crash any more, or the ego
/// is out of sight or jumps, it gives up and drives on (driveOn()). A frame without ego and agents
/// says that nobody was seen: forecasts go on from the frame before.
class AdaptiveAttacker : public AttackerPolicy {
 public:
  AdaptiveAttacker(AttackerTask task, AttackerSetup setup);

  std::unique_ptr<AttackerPolicy> clone() const override {
    return std::make_unique<AdaptiveAttacker>(*this);
  }
  void observe(const Frame& seen) override;
  const AttackerTrajectory& trajectory() const override { return task_.plan; }
  AttackerPhase phase() const override { return phase_; }
  const std::vector<AttackerPlan>& plans() const override { return plans_; }

  /// The ego since now as it was seen, then its likeliest future; the others' from the newest frame
  /// on.
  Future outlook() const;

 private:
  double timeOf(std::size_t index) const { return task_.plan.points[index].time; }
  std::size_t firstAfter(double time) const;
  bool hasJumped(const Frame& seen) const;
  Future foresee(const Snapshot& snapshot) const;
  void replan(const Frame& seen, std::size_t from);
  bool touchesOthers(const Future& future, std::size_t from) const;
  void giveUp(double seen, std::size_t from, const std::string& reason);
  void driveOnFrom(double seen, std::size_t from, const std::string& reason);
  void take(double seen, std::size_t from, std::vector<TrajectoryPoint> points,
            const std::string& reason);
  bool isBelievable(std::size_t from, const std::vector<TrajectoryPoint>& points,
                    double contact) const;
  Snapshot asOf(std::size_t from, Snapshot snapshot) const;
  ReferencePath ownWay() const;
  Underway underwayFrom(std::size_t from) const;

  AttackerTask task_;  // its plan: driven so far, then planned
  AttackerSetup setup_;
  AttackOptions planning_;  // of new plans
  Track vehicle_;           // without states
  DriveLimits limits_;
  SceneHistory scene_;
  double impact_;                     // s, the scene's clock; asked for
  double last_look_;                  // s
  double last_ego_;                   // s, when the ego was seen last
  std::vector<AgentState> seen_ego_;  // from the attack's now on, before the newest look
  AttackerPhase phase_ = AttackerPhase::kAttacking;
  /// Of the plan; contact and wait are instants on the scene's clock.
  std::optional<DraftedWay> drafted_;
  std::vector<AttackerPlan> plans_;
};

}  // namespace forge
