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

/// Runs a planner in another node, in lock step: publishes planning_state and waits for a
/// planned_trajectory with the same `test` and stamp. Simulation time stands still meanwhile.
/// Ignores trajectories with another `test`. The first state of a test is repeated until a
/// trajectory arrives, because the connection may not be established yet. One object serves
/// consecutive rollouts; each initialize() starts a new test. Not thread-safe.
class ExternalPlanner : public Planner {
 public:
  ExternalPlanner(ros::NodeHandle node, const ExternalOptions& options, const InputLimits& limits);

  /// Sets the options for the following tests.
  void setOptions(const ExternalOptions& options) { options_ = options; }

  /// Waits for a node that subscribes to planning_state and publishes planned_trajectory. Throws
  /// PlannerTimeout if there is none within the time-out.
  void initialize(const DrivingTask& task) override;
  /// Returns the trajectory planned for `observation`. Throws PlannerTimeout if none arrives within
  /// the time-out, or immediately if the node disconnects; LatePlan if its stamp is not that tick;
  /// MessageError as fromMessage(); InputError as checkPlan().
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

 private:
  bool isConnected() const;
  void awaitAnswer(const collision_forge::PlanningState& state);
  void receive(const collision_forge::PlannedTrajectoryConstPtr& answer);

  ExternalOptions options_;
  InputLimits limits_;
  DrivingTask task_;
  std::uint32_t test_ = 0;
  ros::Time first_;                                                 // first tick of the test
  ros::Time current_;                                               // current tick of the test
  std::deque<collision_forge::PlannedTrajectoryConstPtr> answers_;  // of this test
  ros::CallbackQueue queue_;                                        // served inside plan()
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace forge
