#pragma once

#include <memory>
#include <stdexcept>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// What a planner is told once, before it drives.
struct DrivingTask {
  std::shared_ptr<const LaneIndex> lanes;
  /// The way that the ego is meant to take (the recorded one), global map frame, metres; at least
  /// two distinct points.
  std::vector<Vector2> route;
  EgoVehicle ego;
  double wheelbase = 0.0;  ///< m
};

/// What is known at a tick; nothing of it lies in the future.
struct Observation {
  TrajectoryPoint ego;        ///< now, middle of the box
  std::vector<Track> agents;  ///< those in sight now, each with its newest states up to now
};

/// Thrown by a planner that asks somebody else, in vain.
struct PlannerTimeout : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Thrown by a planner that is given the answer to another tick than it asked for.
struct LatePlan : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Drives the ego. One object drives one rollout; a planner is deterministic: the same task and
/// observations give the same trajectories.
class Planner {
 public:
  virtual ~Planner() = default;

  /// Called once, before the first plan(). Throws std::invalid_argument for a task that the planner
  /// cannot drive.
  virtual void initialize(const DrivingTask& task) = 0;

  /// The motion of the ego from now on: points at increasing times, the first at the observation's
  /// time, middle of the box, global map frame. The caller checks what comes back.
  virtual std::vector<TrajectoryPoint> plan(const Observation& observation) = 0;

  /// What the last plan() chose from, for pictures: the middle of the ego's box over time. Empty
  /// for a planner that does not choose.
  virtual std::vector<std::vector<Pose2>> proposals() const { return {}; }

  /// s of the processor that other processes have used for this planner.
  virtual double otherProcessorTime() const { return 0.0; }
};

}  // namespace forge
