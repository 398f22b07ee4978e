#include "collision_forge/ros/nodes/planner_playback.h"

#include <geometry_msgs/PolygonStamped.h>
#include <std_msgs/Bool.h>
#include <visualization_msgs/MarkerArray.h>

#include "collision_forge/ros/markers/markers.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr double kPictureRate = 20.0;  // Hz, of the wall clock
constexpr double kEndShown = 3.0;      // s for which the last frame is held
constexpr double kStill = 0.5;         // s without a new time on /clock: the replay is paused

std_msgs::Header mapHeader() {
  std_msgs::Header header;
  header.frame_id = names::kMapFrame;
  return header;
}

}  // namespace

PlannerPlayback::PlannerPlayback(ros::NodeHandle node, const SeverityOptions& severity)
    : severity_(severity),
      ways_(node, names::kPlannerMarkers),
      scenes_(node.advertise<visualization_msgs::MarkerArray>(names::kPlannerSceneMarkers, 1)),
      areas_(node.advertise<geometry_msgs::PolygonStamped>(names::kShownArea, 1)),
      is_shown_(node.advertise<std_msgs::Bool>(names::kPlannerTestShown, 1, true)) {
  publishShownState();
  timer_ =
      node.createWallTimer(ros::WallDuration(1.0 / kPictureRate), &PlannerPlayback::show, this);
  repeat_timer_ = node.createWallTimer(ros::WallDuration(RepeatedMarkers::kInterval),
                                       &PlannerPlayback::repeat, this);
}

void PlannerPlayback::play(const PlannerTrial& trial, const CrashScenario& scenario,
                           const std::string& planner) {
  const std::lock_guard<std::mutex> lock(mutex_);
  shown_ = shownRollout(trial, scenario, planner, severity_);
  begin_ = moved_ = ros::WallTime::now();
  clock_ = ros::Time::now();
  was_still_ = false;
  ways_.publish(plannerMarkers(trial, scenario));
  publishShownState();
}

void PlannerPlayback::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (shown_) clear();
}

void PlannerPlayback::show(const ros::WallTimerEvent& /*event*/) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!shown_) return;
  const ros::WallTime now = ros::WallTime::now();
  const double duration = shown_->standTime() - shown_->now();
  const double since = (now - begin_).toSec();
  if (ros::Time::isSimTime() && isReplaceable(since, duration)) return clear();
  if (since > duration + kEndShown) begin_ = now;
  const double time = shown_->now() + (now - begin_).toSec();
  scenes_.publish(rolloutMarkers(*shown_, time));
  areas_.publish(toMessage(rolloutArea(*shown_, time), mapHeader()));
}

void PlannerPlayback::repeat(const ros::WallTimerEvent& /*event*/) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ways_.repeat();
}

/// Returns true if the replay is running and has resumed from a pause, or the animation, `duration`
/// s long, has ended.
bool PlannerPlayback::isReplaceable(double since, double duration) {
  const ros::Time clock = ros::Time::now();
  const ros::WallTime now = ros::WallTime::now();
  const bool moves = clock != clock_;
  if (moves) {
    clock_ = clock;
    moved_ = now;
  } else if ((now - moved_).toSec() > kStill) {
    was_still_ = true;
  }
  return moves && (was_still_ || since > duration + kEndShown);
}

void PlannerPlayback::clear() {
  shown_.reset();
  ways_.publish(noMarkers(mapHeader()));
  scenes_.publish(noMarkers(mapHeader()));
  publishShownState();
}

void PlannerPlayback::publishShownState() {
  std_msgs::Bool message;
  message.data = shown_.has_value();
  is_shown_.publish(message);
}

}  // namespace forge
