#pragma once

#include <collision_forge/PlannedTrajectory.h>
#include <collision_forge/PlanningState.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <cstdint>
#include <deque>

#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/planner_test/planners/options.h"
#include "collision_forge/planner_test/planners/planner.h"

namespace forge {

/// A planner in another node. Publishes planning_state and waits for the planned_trajectory with
/// the same test and stamp; the rollout's time stands still meanwhile. Ignores plans for another
/// test. Publishes the first state of a test repeatedly until a plan arrives, because the nodes may
/// still be connecting. One object serves many rollouts in sequence; initialize() begins a new
/// test. Not thread-safe.
class ExternalPlanner : public Planner {
 public:
  /// Advertises and subscribes; plans are received inside plan() alone, whatever the queue of
  /// `node`. `limits`: for checkPlan().
  ExternalPlanner(ros::NodeHandle node, const ExternalOptions& options, const InputLimits& limits);

  /// Sets the options of the following tests.
  void setOptions(const ExternalOptions& options) { options_ = options; }

  /// Returns true if a node subscribes to planning_state and publishes planned_trajectory.
  bool isConnected() const;

  /// Begins a new test. Blocks until a node subscribes to planning_state and publishes
  /// planned_trajectory; throws PlannerTimeout if none does within ExternalOptions::timeout.
  void initialize(const DrivingTask& task) override;
  /// Publishes the observation and blocks until the plan arrives; returns its points as
  /// Planner::plan() (an empty plan is valid). initialize() must have been called. Throws
  /// PlannerTimeout if none arrives within ExternalOptions::timeout (s, wall clock) or the
  /// planner's node disconnects after the first tick, LatePlan for a plan of another tick,
  /// MessageError like fromMessage(), InputError like checkPlan().
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

 private:
  /// Publishes `state` and waits until `answers_` has a plan; throws PlannerTimeout.
  void awaitAnswer(const collision_forge::PlanningState& state);
  void receive(const collision_forge::PlannedTrajectoryConstPtr& answer);

  ExternalOptions options_;
  InputLimits limits_;
  DrivingTask task_;
  std::uint32_t test_ = 0;  // number of the test, from 1
  ros::Time first_;         // stamp of the first tick of the test; zero before it
  ros::Time current_;       // stamp of the current tick, the time of its observation
  std::deque<collision_forge::PlannedTrajectoryConstPtr> answers_;  // plans for `test_`, unread
  ros::CallbackQueue queue_;                                        // served inside plan()
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace forge
