#pragma once

#include <optional>
#include <string>

#include "collision_forge/base/scene/gravity.h"

namespace forge {

/// Models of a careful driver or system that brakes and does not steer.
enum class DriverModel {
  kCcDriver,    ///< competent and careful human driver of UN R157, annex 4, appendix 3
  kR157System,  ///< least performance of a system, UN R157 5.2.5.2
  kRss,         ///< Responsibility-Sensitive Safety, arXiv 1708.06374
  kFsm,         ///< Fuzzy Safety Model, Mattas 2020, Accident Analysis and Prevention 148:105794
};
inline constexpr DriverModel kDriverModels[] = {DriverModel::kCcDriver, DriverModel::kR157System,
                                                DriverModel::kRss, DriverModel::kFsm};
/// Returns "cc_driver", "r157_system", "rss" or "fsm".
const char* toString(DriverModel model);
/// Returns the model of a name as toString() spells it; nullopt for another name.
std::optional<DriverModel> driverModelFromString(const std::string& name);

/// Parameters of the models. The defaults have the values of the publications, as ec-jrc/JRC-FSM
/// and esmini's ControllerALKS_R157SM code them; tests use others.
struct DriverOptions {
  // Competent and careful driver
  double wandering_zone = 0.375;  ///< m from the middle of its lane; farther, an agent cuts in
  double risk_evaluation = 0.4;   ///< s from the start of a cut-in or of hard braking until the
                                  ///< driver perceives the risk
  double cc_delay = 0.75;         ///< s from perceiving the risk until the driver brakes
  double release = 0.4;           ///< m/s2, deceleration during cc_delay: accelerator released
  double full_braking = 0.774 * kGravity;  ///< m/s2, also of RSS; no model brakes harder
  double jerk = 12.65;                     ///< m/s3 at which braking builds up, also of RSS and FSM
  double critical_ttc = 2.0;      ///< s; a cut-in with a larger time to collision is no risk
  double critical_headway = 2.0;  ///< s; hard braking ahead is a risk at smaller time headways
  double hard_braking = 5.0;      ///< m/s2; the vehicle ahead brakes hard from this deceleration on
  // System
  double system_lateral_gap = 0.5;  ///< m beside the ego's box; a nearer agent has cut in
  double system_delay = 0.35;       ///< s from the cut-in to the start of braking
  double system_braking = 6.0;      ///< m/s2, deceleration
  double system_margin = 0.1;       ///< s that JRC-FSM adds to the time of the regulation
  // RSS
  double rss_delay = 0.75;  ///< s, response time
  /// m/s2, acceleration of the ego assumed during the response time
  double rss_acceleration = 3.0;
  double rss_braking = 6.0;      ///< m/s2, deceleration assumed of both vehicles
  double rss_lateral_gap = 0.3;  ///< m, lateral gap that must remain
  double rss_lateral = 1.0;  ///< m/s2, lateral acceleration assumed during the response time, and
                             ///< lateral deceleration after it
  // FSM
  double fsm_delay = 0.75;          ///< s, reaction time
  double fsm_comfortable = 4.0;     ///< m/s2, comfortable deceleration of the ego
  double fsm_hardest = 6.0;         ///< m/s2, hardest deceleration of the ego
  double fsm_leader = 7.0;          ///< m/s2, deceleration assumed of the vehicle ahead
  double fsm_margin = 2.0;          ///< m, kept when both stand, and once more in the safe distance
  double fsm_passing_margin = 0.1;  ///< s by which the ego must have passed before the other
                                    ///< vehicle reaches its path
  // Choices of this project, for what the models leave open
  /// rad between the headings of agent and path, up to which the agent drives the same way
  double same_direction = 0.785;
  /// s to a contact with crossing or oncoming agents; see Approach::is_conflict
  double conflict_horizon = 3.0;
};

/// Observation of one other agent by a driver, along and across the ego's path. Boxes are projected
/// on the path; "ego" is the vehicle that the driver drives.
struct Approach {
  double gap = 0.0;      ///< m between the boxes along the path, < 0 side by side
  double lengths = 0.0;  ///< m, sum of the lengths of both boxes along the path
  /// true: the centre of its box is ahead of the ego's box centre along the path
  bool is_ahead = true;
  double lateral_gap = 0.0;    ///< m between the boxes across the path, <= 0 if it is in the way
  double lateral_speed = 0.0;  ///< m/s towards the path, < 0 away from it
  /// m by which it is nearer to the path than at its farthest so far: stands for its distance from
  /// the middle of its own lane
  double deviation = 0.0;
  double speed = 0.0;    ///< m/s along the path, negative if oncoming
  double braking = 0.0;  ///< m/s2, deceleration along the path
  /// true: not a person on foot, and its heading is within DriverOptions::same_direction of the
  /// path's
  bool is_same_direction = true;
  /// For agents of other directions: at constant velocities there is a contact within
  /// `conflict_horizon`. All models react to it, with their own delay and full braking.
  bool is_conflict = false;
};

/// Returns the proactive fuzzy safety metric (PFS) of FSM, 0 (safe) to 1 (unsafe), linear between
/// the gaps at which comfortable and hardest braking suffice, from the gap (m) between ego and
/// vehicle ahead and the speeds of both (m/s): whether the ego could still brake if the vehicle
/// ahead brakes with `fsm_leader`.
double proactiveFuzzy(double gap, double ego_speed, double leader_speed,
                      const DriverOptions& options);

/// Returns the critical fuzzy safety metric of FSM, 0 (safe) to 1 (unsafe), for a vehicle ahead
/// that keeps its speed. `gap` in m, speeds in m/s, `acceleration` of the ego in m/s2, negative:
/// braking, counted as at least -fsm_comfortable; 0 if the ego is not faster.
double criticalFuzzy(double gap, double ego_speed, double leader_speed, double acceleration,
                     const DriverOptions& options);

/// One driver, step by step. The driver keeps its speed until the model reacts; the CC driver then
/// brakes to a stop, the other models brake while the situation is unsafe. Not thread-safe.
class CarefulDriver {
 public:
  /// A driver of `model` that has not reacted; `options` are copied.
  explicit CarefulDriver(DriverModel model, const DriverOptions& options = {})
      : model_(model), options_(options) {}

  /// Advances the driver by `step` seconds and returns the deceleration (m/s2, >= 0) for them;
  /// empty until the driver reacts, 0 when a driver that has reacted does not brake. During the
  /// delay of its model the CC driver decelerates by DriverOptions::release, the others by 0; it
  /// is waited for once, and for the others it counts unsafe steps only. Call it once per step.
  /// `approach`: the agent that matters at the start of the step; empty if there is none. `speed`
  /// (m/s) is the ego's then.
  std::optional<double> decelerate(const std::optional<Approach>& approach, double speed,
                                   double step);

  /// Returns true once the driver has braked, after its delay; it stays true.
  bool isBraking() const { return is_braking_; }

 private:
  bool isUnsafe(const Approach& approach, double speed, double step);
  bool seesRisk(const Approach& approach, double speed, double step);
  bool isRssUnsafe(const Approach& approach, double speed) const;
  bool isFuzzyUnsafe(const Approach& approach, double speed);
  double delay() const;
  double brakingOf(double step) const;

  DriverModel model_;
  DriverOptions options_;
  std::optional<double> last_speed_;  ///< m/s
  double acceleration_ = 0.0;         ///< m/s2 of the last step
  double evaluated_ = 0.0;            ///< s that the CC driver has evaluated the risk
  double waited_ = 0.0;               ///< s of the delay
  double fuzzy_braking_ = 0.0;        ///< m/s2 that FSM wants
  double deceleration_ = 0.0;         ///< m/s2
  bool has_reacted_ = false;
  bool is_braking_ = false;
};

}  // namespace forge
