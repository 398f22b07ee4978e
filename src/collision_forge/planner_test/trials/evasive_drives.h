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

/// config/planners.yaml, section avoidability, where each number's unit and source stand.
struct AvoidabilityOptions {
  double interval = 0.0;
  double step = 0.1;  ///< s; that of RolloutOptions
  std::vector<double> accelerations;
  std::vector<double> offsets = {0.0,  1.0, -1.0, 2.0,
                                 -2.0, 3.5, -3.5};   ///< m to the left of the ego's way
  std::vector<double> durations = {1.0, 2.0, 20.0};  ///< s that the acceleration lasts
  double return_time = 0.4;  ///< s in which an offset is steered to at the speed of then ...
  double min_return_distance = 3.0;  ///< m, at least
  double margin = 0.1;  ///< m kept to everybody at the points of a motion, before it is verified
  int draws = 0;
  std::uint64_t seed = 1;  ///< of the draws
  int tries = 0;
};

/// What an ego does to avoid a crash.
enum class EvasiveManoeuvre {
  kKeeping,       ///< nothing: it drives on as recorded
  kBraking,       ///< along its way
  kAccelerating,  ///< along its way
  kSteering,      ///< to a way beside, at its speed
  kBoth,          ///< braking or accelerating, and steering
};
/// "keeping", "braking", "accelerating", "steering", "both".
const char* toString(EvasiveManoeuvre manoeuvre);
std::optional<EvasiveManoeuvre> evasiveManoeuvreFromString(const std::string& name);

/// What the ego is asked to do for a while: an acceleration, and a way beside its own.
struct EvasiveDemand {
  double acceleration = 0.0;  ///< m/s2
  double offset = 0.0;        ///< m to the left of where it is on its way
};

/// The first demand for `duration` seconds, then the second.
struct EvasivePlan {
  EvasiveDemand first;
  double duration = 0.0;
  EvasiveDemand second;
};

EvasiveManoeuvre kindOf(const EvasivePlan& plan);

/// m/s along the heading; an ego that reverses stands.
double speedOf(const AgentState& state);

/// Where everybody but the ego is at instants `step` seconds apart.
class Obstacles {
 public:
  /// As of EvasiveDrives::verify().
  Obstacles(const Future& others, double start, double end, double step);

  /// At the instants of the points, which are those of the constructor.
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

/// What the ego of a crash could drive to avoid it, along its way (routeOf() its recording) or a
/// way beside it, and whether it touches somebody then. Keeps references to scenario and options.
class EvasiveDrives {
 public:
  /// Throws as routeOf().
  EvasiveDrives(const CrashScenario& scenario, const AvoidabilityOptions& options,
                const RouteOptions& route, const AttackOptions& attack);

  /// Every plan that is tried, the gentler ones first: the grid of the options, then draws.
  const std::vector<EvasivePlan>& plans() const { return plans_; }

  /// From a state of the ego to the scenario's end, a point every step and one at the end.
  void drive(const AgentState& from, const EvasivePlan& plan,
             std::vector<TrajectoryPoint>& points) const;

  /// The ego's box with the options' margin around it.
  BoxSize wideBox() const;

  bool leavesRoad(const std::vector<TrajectoryPoint>& points) const;

  /// verifyDrive() with the ego in the attacker's place, by the strict limits: `contact` is that
  /// with the attacker, who is `others.ego`.
  CollisionReport verify(const std::vector<TrajectoryPoint>& points, const Future& others) const;

  /// True where nobody is touched and every limit kept.
  static bool isEvasion(const CollisionReport& report);

  /// Mean share of the ego's box off the drivable area.
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
