#include "collision_forge/ros/nodes/external_planner.h"

#include <chrono>

#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/ros/messages/planner_messages.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr std::uint32_t kQueue = 100;  // messages; one per tick is expected
constexpr double kPoll = 0.02;         // s between two checks of the connection
constexpr double kRepeat = 0.2;        // s between two publications of a test's first state

std::string seconds(double value) { return numberText(value) + " s"; }

class Deadline {
 public:
  explicit Deadline(double timeout)
      : end_(std::chrono::steady_clock::now() + std::chrono::duration<double>(timeout)) {}
  bool isPast() const { return !ros::ok() || std::chrono::steady_clock::now() > end_; }

 private:
  std::chrono::time_point<std::chrono::steady_clock, std::chrono::duration<double>> end_;
};

}  // namespace

ExternalPlanner::ExternalPlanner(ros::NodeHandle node, const ExternalOptions& options,
                                 const InputLimits& limits)
    : options_(options), limits_(limits) {
  node.setCallbackQueue(&queue_);
  publisher_ = node.advertise<collision_forge::PlanningState>(names::kPlanningState, 1);
  subscriber_ = node.subscribe(names::kPlannedTrajectory, kQueue, &ExternalPlanner::receive, this,
                               ros::TransportHints().tcpNoDelay());
}

void ExternalPlanner::receive(const collision_forge::PlannedTrajectoryConstPtr& answer) {
  const ros::Time& tick = answer->header.stamp;
  const bool is_repeated = tick == first_ && tick != current_;
  if (answer->test == test_ && !is_repeated) answers_.push_back(answer);
}

bool ExternalPlanner::isConnected() const {
  return publisher_.getNumSubscribers() > 0 && subscriber_.getNumPublishers() > 0;
}

void ExternalPlanner::initialize(const DrivingTask& task) {
  task_ = task;
  ++test_;
  first_ = ros::Time();
  answers_.clear();
  const Deadline deadline(options_.timeout);
  while (!isConnected()) {
    if (deadline.isPast()) {
      throw PlannerTimeout("no node subscribes to " + publisher_.getTopic() + " and publishes " +
                           subscriber_.getTopic());
    }
    ros::WallDuration(kPoll).sleep();
  }
}

void ExternalPlanner::awaitAnswer(const collision_forge::PlanningState& state) {
  const bool is_first = first_ == current_;
  const Deadline deadline(options_.timeout);
  Deadline repetition(kRepeat);
  publisher_.publish(state);
  while (answers_.empty()) {
    const bool is_gone = !is_first && !isConnected();
    queue_.callAvailable(ros::WallDuration(kPoll));
    if (!answers_.empty()) return;
    if (is_gone) throw PlannerTimeout("the node behind " + subscriber_.getTopic() + " is gone");
    if (deadline.isPast()) {
      throw PlannerTimeout("no response on " + subscriber_.getTopic() + " within " +
                           seconds(options_.timeout));
    }
    if (is_first && repetition.isPast()) {
      publisher_.publish(state);
      repetition = Deadline(kRepeat);
    }
  }
}

std::vector<TrajectoryPoint> ExternalPlanner::plan(const Observation& observation) {
  const auto state = toMessage(observation, task_, test_, options_.interval);
  current_ = state.header.stamp;
  if (first_.isZero()) first_ = current_;
  awaitAnswer(state);
  const auto answer = answers_.front();
  answers_.pop_front();
  if (current_ == first_) answers_.clear();  // replies to repeated states
  if (answer->header.stamp != state.header.stamp) {
    throw LatePlan("the stamps of planned_trajectory and planning_state differ by " +
                   seconds((answer->header.stamp - state.header.stamp).toSec()));
  }
  std::vector<TrajectoryPoint> plan = fromMessage(*answer);
  checkPlan(plan, limits_, names::kPlannedTrajectory);
  return plan;
}

}  // namespace forge
