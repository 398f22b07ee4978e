#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/planner_test/planners/route.h"
#include "collision_forge/planner_test/trials/crash_scenario.h"

namespace forge {

/// Options of findAvoidability() and findEvasion(): config/planners.yaml, section avoidability,
/// where each number's source stands.
struct AvoidabilityOptions {
  double interval = 0.0;  ///< s between two start times of manoeuvres that are tried
  double step = 0.1;      ///< s between points of a motion; must equal RolloutOptions::step
  std::vector<double> accelerations;  ///< m/s2 along the heading in the first phase, tried with
                                      ///< each of `offsets` and `durations`
  /// m to the left of the ego's lateral position at the start.
  std::vector<double> offsets = {0.0, 1.0, -1.0, 2.0, -2.0, 3.5, -3.5};
  std::vector<double> durations = {1.0, 2.0, 20.0};  ///< s of the first phase
  double return_time = 0.4;          ///< s in which an offset is reached at the current speed ...
  double min_return_distance = 3.0;  ///< m; ... but over at least this distance
  /// m kept to all agents on each side at the points of a motion, before it is verified.
  double margin = 0.1;
  int draws = 0;           ///< number of random plans in addition to the grid: all demands uniform,
                           ///< accelerations within the strict limits, offsets up to the largest of
                           ///< `offsets` to either side, `duration` up to the longest
  std::uint64_t seed = 1;  ///< of the random plans
  int tries = 0;  ///< greatest number of motions per start time that are simulated against an
                  ///< adaptive attacker
};

/// Kind of evasive manoeuvre.
enum class EvasiveManoeuvre {
  kKeeping,       ///< none: drives as recorded (Avoidability), or keeps its speed (Evasion)
  kBraking,       ///< along its path
  kAccelerating,  ///< along its path
  kSteering,      ///< to a parallel path, at constant speed
  kBoth,          ///< braking or accelerating, and steering
};
/// Returns "keeping", "braking", "accelerating", "steering" or "both".
const char* toString(EvasiveManoeuvre manoeuvre);
/// Returns the value of a name as toString() spells it; nullopt for another name.
std::optional<EvasiveManoeuvre> evasiveManoeuvreFromString(const std::string& name);

/// Control targets of the ego during one phase of an evasive plan.
struct EvasiveDemand {
  double acceleration = 0.0;  ///< m/s2 along the heading, clamped to the limits
  double offset = 0.0;  ///< m to the left of the ego's lateral position at the start of the plan
};

/// Two phases: `first` for `duration` seconds, then `second`.
struct EvasivePlan {
  EvasiveDemand first;    ///< for `duration`
  double duration = 0.0;  ///< s from the start of the plan
  EvasiveDemand second;   ///< from then on
};

/// Returns the kind of a plan: steering if any offset is not 0; braking or accelerating by the
/// first acceleration that is not 0.
EvasiveManoeuvre kindOf(const EvasivePlan& plan);

/// Returns the state's speed along its heading, m/s; 0 if the ego reverses.
double speedOf(const AgentState& state);

/// Boxes of all agents except the ego, every `step` seconds.
class Obstacles {
 public:
  /// `others` as in EvasiveDrives::verify(): `ego` is an agent, too. Samples all tracks every
  /// `step` seconds from `start` to `end` (s, scene clock), both included; the last interval may be
  /// shorter.
  Obstacles(const Future& others, double start, double end, double step);

  /// Returns whether a box of `size` (m) at the points (its middle) touches no agent. Point i must
  /// be at sample i of the constructor; agents that are not in sight there do not count, nor do
  /// points beyond the last sample.
  bool areClearOf(const std::vector<TrajectoryPoint>& points, const BoxSize& size) const;

 private:
  /// The sampled motion of one agent.
  struct Course {
    BoxSize size;
    double reach = 0.0;                       ///< m, circumradius of the box
    std::vector<std::optional<Pose2>> poses;  ///< per sample; empty if the agent is not in sight
  };

  /// Samples one track; arguments as in the constructor.
  void add(const Track& other, double start, double end, double step);

  std::vector<Course> courses_;
};

/// Simulates and verifies evasive motions of a crash's ego along its path (routeOf() its recording)
/// or parallel to it. Keeps references to `scenario` and `options`.
class EvasiveDrives {
 public:
  /// `route`: of routeOf(). `attack`: strict limits and tolerances (copied); the speed limit is
  /// raised to the recorded ego's top speed. Throws as routeOf().
  EvasiveDrives(const CrashScenario& scenario, const AvoidabilityOptions& options,
                const RouteOptions& route, const AttackOptions& attack);

  /// Returns all plans to try, gentler ones first: the grid of the options (second phase at
  /// constant speed and the same offset) and the random plans together, sorted by the sum of both
  /// absolute accelerations (share of the total limit) and the first absolute offset (share of the
  /// widest).
  const std::vector<EvasivePlan>& plans() const { return plans_; }

  /// Simulates `plan` from a state of the ego (middle of the box) to the scenario's end within the
  /// limits, without reversing; replaces the content of `points` by a point every step from
  /// `from.time` on and one at the end.
  void drive(const AgentState& from, const EvasivePlan& plan,
             std::vector<TrajectoryPoint>& points) const;

  /// Returns the size of the ego's box enlarged by `options.margin` on each side.
  BoxSize wideBox() const;

  /// Returns whether the ego's box is on the road at the first point and has a corner off the
  /// drivable area at a later one; false if the map has no drivable area, and if the ego starts off
  /// the road. `points` must not be empty.
  bool leavesRoad(const std::vector<TrajectoryPoint>& points) const;

  /// Runs verifyDrive() on the ego's motion with the strict limits. The roles are exchanged:
  /// `others.ego` must be the attacker, `others.agents` the other agents, and the report's
  /// `contact` is the contact with the attacker.
  CollisionReport verify(const std::vector<TrajectoryPoint>& points, const Future& others) const;

  /// Returns whether the report of verify() has no contact with any agent and no violated limit.
  static bool isEvasion(const CollisionReport& report);

  /// Returns the mean share (0..1) of the ego's box off the drivable area. `report`: of verify()
  /// for these points.
  double shareOff(const std::vector<TrajectoryPoint>& points, const CollisionReport& report) const;

 private:
  /// Returns whether all corners of the ego's box are on the drivable area.
  bool isOnRoad(const Pose2& pose) const;

  const CrashScenario& scenario_;
  const AvoidabilityOptions& options_;
  AttackOptions attack_;  // an ego that was recorded beyond max_speed may go on so
  ReferencePath path_;
  std::vector<EvasivePlan> plans_;
};

}  // namespace forge
