#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Input of Planner::initialize(): what stays the same throughout a rollout.
struct DrivingTask {
  std::shared_ptr<const LaneIndex> lanes;  ///< the map; not null in a rollout
  /// Path that the ego should follow (from its recording), m, global map frame; at least two
  /// distinct points.
  std::vector<Vector2> route;
  EgoVehicle ego;          ///< size of the ego's box and its place on the rear axle
  double wheelbase = 0.0;  ///< m, of the ego, KinematicBicycleOptions::wheelbase
};

/// Input of Planner::plan(): the state of the scene at the time of the call, without future states.
struct Observation {
  TrajectoryPoint ego;  ///< current state, middle of the box, global map frame; its time (s, scene
                        ///< clock) is the time of the call
  /// Agents in sight now, the attacker included and without the ego, each with its states of the
  /// last PlanningOptions::history seconds, the newest last and at the time of the call; global map
  /// frame.
  std::vector<Track> agents;
  /// Lane::id of the lanes whose traffic light is red now.
  std::vector<std::string> red_lanes = {};
};

/// Thrown by a planner whose external process or node does not respond in time.
struct PlannerTimeout : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Thrown by a planner that receives a response to an earlier call than the current one.
struct LatePlan : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Extension point: drives the ego in a rollout. One object serves one rollout, whose thread makes
/// all calls in sequence; other rollouts run in parallel with objects of their own, so
/// implementations must not share mutable state. A planner must be deterministic: the same task and
/// observations give the same trajectories. Exceptions from initialize() and plan() end the rollout
/// as a failure of the planner.
class Planner {
 public:
  virtual ~Planner() = default;

  /// Called once, by the rollout's thread, before the first plan(). Copy what plan() needs: `task`
  /// need not outlive the call. Throws std::invalid_argument for a task that the planner cannot
  /// drive.
  virtual void initialize(const DrivingTask& task) = 0;

  /// Called every Driving::interval seconds of scene time. Returns the ego's trajectory (middle of
  /// the box, global map frame): points at strictly increasing times, the first at the
  /// observation's time, the last not before the next call or the end of the rollout, whichever is
  /// sooner. The caller checks the result (PlannerFailure). Must use only this and earlier
  /// observations. May throw PlannerTimeout, LatePlan or any std::exception. The scene waits for
  /// the result, so a slow planner slows the test down but does not change it.
  virtual std::vector<TrajectoryPoint> plan(const Observation& observation) = 0;

  /// Called after plan(), for figures; for one trial after every plan(). Returns the motions that
  /// the last plan() chose from, as poses of the middle of the ego's box in the global map frame,
  /// from the time of that plan on; empty if the planner does not choose or before plan(). Must not
  /// throw.
  virtual std::vector<std::vector<Pose2>> proposals() const { return {}; }
};

}  // namespace forge
