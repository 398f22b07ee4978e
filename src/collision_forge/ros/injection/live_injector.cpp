#include "collision_forge/ros/injection/live_injector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_forge/base/scene/scene_history.h"
#include "collision_forge/ros/injection/frame_between.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

constexpr std::size_t kMostWait = 10000;  // frames waiting for the ego's poses at most

double secondsFrom(const collision_forge::AgentArray::ConstPtr& from, const ros::Time& to) {
  return (to - from->header.stamp).toSec();
}

}  // namespace

LiveInjector::LiveInjector(const Config& config, AfterContact after_contact, Publish publish)
    : step_(1.0 / config.attacked_bag.frame_rate),
      limits_(config.input_limits),
      after_contact_(after_contact),
      drivable_(config.attack.verification.drivable),
      publish_(std::move(publish)),
      watch_(config.ego_vehicle.size, config.live.maxAttackAge(), config.attack.verification) {}

void LiveInjector::setAttack(const collision_forge::Attack& attack) {
  if (attack.trajectory.attacker_id.empty()) {
    injector_.reset();
    supports_.clear();
    watch_.stop();
    return send();
  }
  const AttackerTrajectory trajectory = fromMessage(attack.trajectory);
  checkTrajectory(trajectory, limits_, "attack");
  for (const collision_forge::SupportVehicle& support : attack.supports) {
    checkTrajectory(fromMessage(support.motion), limits_, "attack.supports");
  }
  now_ = trajectory.points.front().time;
  if (injector_ && injector_->change(attack.trajectory)) return watch_.change(trajectory);
  injector_.emplace(attack.trajectory, drivable_);
  supports_.clear();
  for (const auto& support : attack.supports) {
    supports_.emplace_back(support.motion, drivable_, AfterEnd::kLeave);
  }
  if (last_) {
    injector_->remember(*last_);
    for (AttackerInjector& support : supports_) support.remember(*last_);
  }
  const auto& poses = watch_.ego().states;
  if (!poses.empty()) begun_at_ = poses.back().time;
  watch_.start(trajectory);
  showCrash();
  send();
}

void LiveInjector::addFrame(const collision_forge::AgentArray::ConstPtr& recorded) {
  const auto newest = waiting_.empty() ? last_ : waiting_.back();
  if (newest && secondsFrom(newest, recorded->header.stamp) < -kRestart) {
    waiting_.clear();
    last_ = before_last_ = nullptr;
    published_ = ros::Time();
    begun_at_ = 0.0;
  }
  waiting_.push_back(recorded);
  if (waiting_.size() > kMostWait) waiting_.pop_front();
  send();
}

void LiveInjector::addEgo(const AgentState& ego) {
  watch_.addEgo(ego);
  showCrash();
  send();
}

void LiveInjector::showCrash() {
  if (injector_ && after_contact_ != AfterContact::kDriveOn) injector_->setCrash(watch_.crash());
}

void LiveInjector::send() {
  while (sendInBetween() || sendRecorded()) {
  }
}

/// Returns false if no additional frame is due.
bool LiveInjector::sendInBetween() {
  if (!injector_ || !last_) return false;
  const double since = std::max({published_.toSec(), begun_at_, now_});
  const double steps = std::floor((since - last_->header.stamp.toSec() + kSameTime) / step_) + 1.0;
  const double ahead = step_ * std::max(steps, 1.0);
  const ros::Time stamp = last_->header.stamp + ros::Duration(ahead);
  if (ahead > lastAhead() + kSameTime || !isEgoKnown(stamp)) return false;
  publish(frameAfter(before_last_.get(), *last_, stamp));
  return true;
}

/// Returns the time after the last recorded frame during which additional frames are allowed, s.
double LiveInjector::lastAhead() const {
  if (!waiting_.empty()) {
    const double gap = secondsFrom(last_, waiting_.front()->header.stamp);
    return gap > kMaxGap ? 0.0 : gap - step_ / 2.0;
  }
  const double gap = before_last_ ? secondsFrom(before_last_, last_->header.stamp) : kMaxGap;
  return (gap < kMaxGap ? gap : kFrameInterval) - step_;
}

/// Returns false if the first waiting frame must wait further, or if none is waiting.
bool LiveInjector::sendRecorded() {
  if (waiting_.empty()) return false;
  const auto frame = waiting_.front();
  const bool is_after_now = isAfterNow(frame->header.stamp);
  if (is_after_now && !isEgoKnown(frame->header.stamp)) return false;
  waiting_.pop_front();
  if (!is_after_now || frame->header.stamp > published_) publish(*frame);
  keep(frame);
  return true;
}

void LiveInjector::publish(const collision_forge::AgentArray& frame) {
  published_ = std::max(published_, frame.header.stamp);
  collision_forge::AgentArray injected = frame;
  for (AttackerInjector& support : supports_) injected = support.inject(std::move(injected));
  publish_(injector_ ? injector_->inject(std::move(injected)) : injected);
}

void LiveInjector::keep(const collision_forge::AgentArray::ConstPtr& recorded) {
  if (last_ && recorded->header.stamp <= last_->header.stamp) return;
  before_last_ = std::exchange(last_, recorded);
}

bool LiveInjector::isAfterNow(const ros::Time& stamp) const {
  return injector_ && stamp.toSec() > now_;
}

bool LiveInjector::isEgoKnown(const ros::Time& stamp) const {
  const auto& poses = watch_.ego().states;
  return !poses.empty() && stamp.toSec() <= poses.back().time + kSameTime;
}

}  // namespace forge
