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
  double interval = 0.0;              ///< s between two start times that are tried
  double step = 0.1;                  ///< s; must equal RolloutOptions::step
  std::vector<double> accelerations;  ///< m/s2
  std::vector<double> offsets = {0.0,  1.0, -1.0, 2.0,
                                 -2.0, 3.5, -3.5};   ///< m to the left of the ego's path
  std::vector<double> durations = {1.0, 2.0, 20.0};  ///< s of the first phase
  double return_time = 0.4;          ///< s in which an offset is reached at the current speed ...
  double min_return_distance = 3.0;  ///< m; ... but over at least this distance
  double margin = 0.1;  ///< m kept to all agents at the points of a motion, before it is verified
  int draws = 0;        ///< number of random motions, after the grid
  std::uint64_t seed = 1;  ///< of the random motions
  int tries = 0;  ///< motions per start time that are simulated against an adaptive attacker
};

/// Kind of evasive manoeuvre.
enum class EvasiveManoeuvre {
  kKeeping,       ///< none: drives as recorded
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
  double acceleration = 0.0;  ///< m/s2
  double offset = 0.0;        ///< m to the left of its lateral position on its path
};

/// Two phases: `first` for `duration` seconds, then `second`.
struct EvasivePlan {
  EvasiveDemand first;
  double duration = 0.0;  ///< s
  EvasiveDemand second;
};

/// Returns the kind of a plan by its accelerations and offsets.
EvasiveManoeuvre kindOf(const EvasivePlan& plan);

/// Returns the speed along the heading, m/s; 0 if the ego reverses.
double speedOf(const AgentState& state);

/// Boxes of all agents except the ego, every `step` seconds.
class Obstacles {
 public:
  /// `others` as in EvasiveDrives::verify(); samples from `start` to `end` (s, scene clock).
  Obstacles(const Future& others, double start, double end, double step);

  /// Returns whether a box of `size` at the points touches no agent. The points must be at the
  /// times of the constructor.
  bool areClearOf(const std::vector<TrajectoryPoint>& points, const BoxSize& size) const;

 private:
  struct Course {
    BoxSize size;
    double reach = 0.0;
    std::vector<std::optional<Pose2>> poses;
  };

  void add(const Track& other, double start, double end, double step);

  std::vector<Course> courses_;
};

/// Simulates and verifies evasive motions of a crash's ego along its path (routeOf() its recording)
/// or parallel to it. Keeps references to `scenario` and `options`.
class EvasiveDrives {
 public:
  /// Throws as routeOf().
  EvasiveDrives(const CrashScenario& scenario, const AvoidabilityOptions& options,
                const RouteOptions& route, const AttackOptions& attack);

  /// Returns all plans to try, gentler ones first: the grid of the options, then random ones.
  const std::vector<EvasivePlan>& plans() const { return plans_; }

  /// Simulates `plan` from a state of the ego to the scenario's end; writes a point every step and
  /// one at the end into `points`.
  void drive(const AgentState& from, const EvasivePlan& plan,
             std::vector<TrajectoryPoint>& points) const;

  /// Returns the ego's box enlarged by `options.margin`.
  BoxSize wideBox() const;

  /// Returns whether the ego is off the road at any point.
  bool leavesRoad(const std::vector<TrajectoryPoint>& points) const;

  /// Runs verifyDrive() on the ego's motion with the strict limits. `others.ego` must be the
  /// attacker; the report's `contact` is the one with it.
  CollisionReport verify(const std::vector<TrajectoryPoint>& points, const Future& others) const;

  /// Returns whether the report has no contact and no violated limit.
  static bool isEvasion(const CollisionReport& report);

  /// Returns the mean share (0..1) of the ego's box off the drivable area.
  double shareOff(const std::vector<TrajectoryPoint>& points, const CollisionReport& report) const;

 private:
  bool isOnRoad(const Pose2& pose) const;

  const CrashScenario& scenario_;
  const AvoidabilityOptions& options_;
  AttackOptions attack_;  // an ego that was recorded beyond max_speed may go on so
  ReferencePath path_;
  std::vector<EvasivePlan> plans_;
};

}  // namespace forge
