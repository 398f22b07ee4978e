#include "collision_forge/ros/injection/live_attacker.h"

#include <ros/console.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/io/batch/printable.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

bool isSame(const AttackerTrajectory& one, const AttackerTrajectory& other) {
  return std::equal(one.points.begin(), one.points.end(), other.points.begin(), other.points.end(),
                    [](const TrajectoryPoint& a, const TrajectoryPoint& b) {
                      return a.pose.x == b.pose.x && a.pose.y == b.pose.y &&
                             a.pose.yaw == b.pose.yaw && a.speed == b.speed;
                    });
}

}  // namespace

void LiveAttacker::start(const collision_forge::Attack& attack) {
  const std::lock_guard<std::mutex> lock(mutex_);
  driven_.reset();
  publish(attack);
}

void LiveAttacker::publish(const collision_forge::Attack& attack) {
  now_ = attack.header.stamp.toSec();
  publish_(attack);
}

bool LiveAttacker::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool was_there = now_.has_value();
  forgetLocked();
  return was_there;
}

void LiveAttacker::forgetLocked() {
  driven_.reset();
  now_.reset();
  publish_({});
}

collision_forge::Attack LiveAttacker::start(collision_forge::Attack attack, AttackerTask task,
                                            const AttackerSetup& setup) {
  const AdaptiveAttacker start(task, setup);
  setPlans(start.plans(), attack);
  const std::lock_guard<std::mutex> lock(mutex_);
  driven_ = Driven{attack, std::move(task), setup, start, start};
  publish(attack);
  for (const Frame& frame : frames_) show(frame);
  return attack;
}

void LiveAttacker::addFrame(const Frame& frame, double clock) {
  const std::lock_guard<std::mutex> lock(mutex_);
  came_ = clock;
  is_watched_ = false;
  if (!frames_.empty() && frame.time < frames_.back().time) goBackTo(frame.time);
  frames_.push_back(frame);
  keepNewest(frames_, kept_for_);
  show(frame);
}

void LiveAttacker::checkForLostFrames(double clock) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!std::exchange(is_watched_, true) || frames_.empty()) return;
  if (!driven_ || !driven_->policy || driven_->policy->phase() == AttackerPhase::kDrivingOn) return;
  const double gone = clock - came_;
  if (gone > driven_->setup.adaptive.lost_after) {
    show({frames_.back().time + gone, {kUnknown, kUnknown, kUnknown}, {}});
  }
}

void LiveAttacker::goBackTo(double time) {
  frames_.clear();
  const bool is_before = now_ && time <= *now_;
  if (is_before && !keeps_attack_) forgetLocked();
  if (!driven_) return;
  if (is_before) {
    driven_->policy = driven_->start;
    publish(driven_->first);
  } else if (driven_->policy) {
    ROS_WARN_STREAM("the replay stepped back during the attack by "
                    << printable(driven_->first.trajectory.attacker_id)
                    << ": the attacker stops replanning; request the attack again");
    driven_->policy.reset();
  }
}

void LiveAttacker::show(const Frame& frame) {
  if (!driven_ || !driven_->policy || frame.time <= driven_->task.snapshot.now) return;
  AdaptiveAttacker& policy = *driven_->policy;
  const AttackerTrajectory before = policy.trajectory();
  const std::size_t plans = policy.plans().size();
  policy.observe(frame);
  if (policy.plans().size() == plans && isSame(policy.trajectory(), before)) return;
  publish(attackNow());
}

collision_forge::Attack LiveAttacker::attackNow() const {
  const auto& [first, task, setup, start, policy] = *driven_;
  const CollisionReport report =
      verify(policy->trajectory(), {task.snapshot, policy->outlook(), task.request, *task.lanes},
             setup.attack.verification);
  collision_forge::Attack attack = first;
  attack.trajectory = toMessage(policy->trajectory());
  attack.report = toMessage(report, task.plan.attacker_id, task.snapshot.now);
  attack.report.confidence = first.report.confidence;
  if (report.contact) {
    const PatternMiss miss =
        missBetween(task.pattern.attacker_offset,
                    relativeTo(report.ego_at_contact, report.attacker_at_contact));
    attack.miss_distance = miss.distance;
    attack.miss_heading = miss.heading;
  }
  setPlans(policy->plans(), attack);
  return attack;
}

}  // namespace forge
