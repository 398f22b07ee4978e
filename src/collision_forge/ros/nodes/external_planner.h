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

/// A planner in another node: publishes planning_state and waits for the planned_trajectory with
/// the same test and stamp, in lock step; no time of the rollout passes meanwhile. Answers to
/// another test are left out. The first state of a test is published again until it is answered, as
/// the two nodes may only just be connecting. One object serves many rollouts, one after the other:
/// initialize() begins a new test.
class ExternalPlanner : public Planner {
 public:
  ExternalPlanner(ros::NodeHandle node, const ExternalOptions& options, const InputLimits& limits);

  /// Of the tests that follow.
  void setOptions(const ExternalOptions& options) { options_ = options; }

  /// Throws PlannerTimeout when nobody hears planning_state and publishes
  /// planned_trajectory within the time-out.
  void initialize(const DrivingTask& task) override;
  /// Throws PlannerTimeout when no answer comes within the time-out, at once when whoever would
  /// give it is gone; LatePlan for an answer to another tick; MessageError as fromMessage();
  /// InputError as checkPlan().
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

 private:
  bool isConnected() const;
  void awaitAnswer(const collision_forge::PlanningState& state);
  void receive(const collision_forge::PlannedTrajectoryConstPtr& answer);

  ExternalOptions options_;
  InputLimits limits_;
  DrivingTask task_;
  std::uint32_t test_ = 0;
  ros::Time first_;                                                 // tick of the test
  ros::Time current_;                                               // tick of the test
  std::deque<collision_forge::PlannedTrajectoryConstPtr> answers_;  // of this test
  ros::CallbackQueue queue_;  // served by whoever waits in plan()
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace forge
