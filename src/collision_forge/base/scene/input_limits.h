#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Limits of values in files, messages and services. Values beyond them are damage, and would cost
/// unbounded time and memory. Fields with the default 0 are read from config/input_limits.yaml; the
/// others are fixed.
struct InputLimits {
  double max_coordinate = 0.0;  ///< m; largest |x| and |y| in the map frame
  double min_box = 0.1;    ///< m; smallest length and width of a box; nuScenes' smallest are 0.2 m
  double max_box = 50.0;   ///< m; largest length and width of a box: twice the longest road train
  double max_speed = 0.0;  ///< m/s; of agents, and of speed limits
  /// s on a recording's clock, where times start at 0; the largest ROS time.
  double max_time = 4294967295.0;
  double max_past = 3600.0;      ///< s from a state of a vehicle's past to t0
  double max_trajectory = 60.0;  ///< s from t0 to the last point of a trajectory
  int max_points = 5000;         ///< points of a trajectory, a past or a centreline
  /// m; smallest radius of arcs of a map; the tightest of data/embedded is 0.5 m.
  double min_radius = 0.1;
  int max_agents = 0;       ///< agents of a recording
  int max_lanes = 0;        ///< lanes of a map
  int max_map_points = 0;   ///< points of all lanes and areas of a map together
  int max_line = 16000000;  ///< bytes of a line of a file; 16 attackers, each with a past of 5000
                            ///< states, are 8 MB
};

/// Thrown for input beyond the limits. The message names source, field, value and limit.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns true if |x| and |y| are at most max_coordinate; false for NaN.
bool isWithin(const Vector2& position, const InputLimits& limits);
/// As above, and the yaw is finite.
bool isWithin(const Pose2& pose, const InputLimits& limits);
/// Returns true if length and width are within [min_box, max_box].
bool isWithin(const BoxSize& size, const InputLimits& limits);

// Every reader of input calls the function for its kind. `where` names the file or message in the
// error. All throw InputError.

/// Checks the numbers of lanes and points, the coordinates of every point, and the speed limits of
/// lanes.
void checkMap(const LaneMap& map, const InputLimits& limits, const std::string& where);

/// Removes agents whose box, or the position, speed or time of any state, is beyond the limits; a
/// yaw that is not finite counts as beyond. Keeps agents without states. Appends to `warnings`,
/// if given, one line per kind of problem with the number of agents and the first id.
void keepWithin(std::vector<Track>& agents, const InputLimits& limits,
                std::vector<std::string>* warnings = nullptr);

// The next three throw for the ego, the times and the number of agents, and remove other agents as
// keepWithin() does.

/// Also checks the map, if any; that the median interval of the ego's states is at most kMaxGap and
/// not below 0.2 ms, as it would be if the stamps had another unit; and that the times of ego and
/// frames overlap or are at most 10 s apart, as they have one clock.
void checkScene(Scene& scene, const InputLimits& limits, const std::string& where,
                std::vector<std::string>* warnings = nullptr);
/// Checks `now` and the ego's track, which may be without states.
void checkSnapshot(Snapshot& snapshot, const InputLimits& limits, const std::string& where);
/// The ego and each of `ego_samples` must have a state; agents without states are removed.
void checkFuture(Future& future, const InputLimits& limits, const std::string& where);

/// Checks size, points (at least one) and past, each with positions and speeds. Times must
/// increase, within max_past and max_trajectory of t0, the time of the first point.
void checkTrajectory(const AttackerTrajectory& trajectory, const InputLimits& limits,
                     const std::string& where);

/// Checks number and positions of a planner's points; `plan` may be empty. Skips points whose pose
/// is not finite: the code that judges the plan handles them.
void checkPlan(const std::vector<TrajectoryPoint>& plan, const InputLimits& limits,
               const std::string& where);

/// Checks time, poses, size, speed and tolerance.
void checkPattern(const CollisionPattern& pattern, const InputLimits& limits,
                  const std::string& where);

}  // namespace forge
