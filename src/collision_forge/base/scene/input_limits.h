#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// What input may hold: config/input_limits.yaml, where the unit of each of its keys stands. What
/// is beyond is damaged, and would cost time and memory without bound.
struct InputLimits {
  double max_coordinate = 0.0;
  double min_box = 0.1;   ///< m; length and width of a box; the smallest of nuScenes are 0.2 m
  double max_box = 50.0;  ///< m; twice the longest road train
  double max_speed = 0.0;
  double max_time = 4294967295.0;  ///< s on the clock of a recording; the last that ROS can say
  double max_past = 3600.0;        ///< s from a state of a vehicle's past to now
  double max_trajectory = 60.0;    ///< s from now to the last point of a trajectory
  int max_points = 5000;           ///< of a trajectory, a past or a centreline
  double min_radius = 0.1;         ///< m of a map's arcs; the tightest of data/embedded is 0.5 m
  int max_agents = 0;
  int max_lanes = 0;
  int max_map_points = 0;
  int max_line = 16000000;  ///< bytes; 16 attackers, each with a past of 5000 states, are 8 MB
};

/// Input beyond the limits. The message names where it is, the field, its value and the limit.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Not NaN, and no farther than max_coordinate.
bool isWithin(const Vector2& position, const InputLimits& limits);
/// The heading is finite, too.
bool isWithin(const Pose2& pose, const InputLimits& limits);
bool isWithin(const BoxSize& size, const InputLimits& limits);

// Every reader of a kind of input has it checked here. `where` names the file or the message; all
// throw InputError.

/// Numbers of lanes and points, and every point.
void checkMap(const LaneMap& map, const InputLimits& limits, const std::string& where);

/// Leaves out agents whose box, position, speed or time is beyond the limits; `warnings`, if given,
/// gets one line a kind with the number of them and the first.
void keepWithin(std::vector<Track>& agents, const InputLimits& limits,
                std::vector<std::string>* warnings = nullptr);

// The ego, all times, and the number of agents; keepWithin() of the agents.

/// And the map, if there is one.
void checkScene(Scene& scene, const InputLimits& limits, const std::string& where,
                std::vector<std::string>* warnings = nullptr);
void checkSnapshot(Snapshot& snapshot, const InputLimits& limits, const std::string& where);
/// The ego and every one of `ego_samples` must have at least one state; agents without states are
/// left out.
void checkFuture(Future& future, const InputLimits& limits, const std::string& where);

/// Box, points and past; times increase, and are near those of the first point.
void checkTrajectory(const AttackerTrajectory& trajectory, const InputLimits& limits,
                     const std::string& where);

/// A planner's plan: number and places of its points. Whether they are finite is left to whoever
/// judges the plan.
void checkPlan(const std::vector<TrajectoryPoint>& plan, const InputLimits& limits,
               const std::string& where);

void checkPattern(const CollisionPattern& pattern, const InputLimits& limits,
                  const std::string& where);

}  // namespace forge
