#include "collision_forge/ros/live_injector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/frame_between.h"
#include "collision_forge/scene/scene_history.h"
#include "collision_forge/verify/verification.h"

namespace forge {
namespace {

constexpr std::size_t kMostWait = 10000;  // frames that may wait for the ego's poses

double secondsFrom(const collision_forge::AgentArray::ConstPtr& from, const ros::Time& to) {
  return (to - from->header.stamp).toSec();
}

}  // namespace

LiveInjector::LiveInjector(const Config& config, AfterContact after_contact, Publish publish)
    : step_(1.0 / config.attacked_bag.frame_rate),
      kept_for_(config.live.answerAge()),
      limits_(config.input_limits),
      after_contact_(after_contact),
      verification_(config.attack.verification),
      publish_(std::move(publish)),
      ego_{kEgoId, AgentClass::kCar, config.ego_vehicle.size, {}} {}

void LiveInjector::setAttack(const collision_forge::Attack& attack) {
  if (attack.trajectory.attacker_id.empty()) {
    injector_.reset();
    contact_.reset();
    return send();
  }
  const AttackerTrajectory trajectory = fromMessage(attack.trajectory);
  checkTrajectory(trajectory, limits_, "attack");
  message_ = attack.trajectory;
  trajectory_ = trajectory;
  const BrakingSlide slide = slideFromEnd(trajectory, verification_.drivable);
  if (injector_ && injector_->change(message_, slide)) {
    if (contact_) injector_->change(contact_->trajectory, contact_->slide);
    return;
  }
  injector_.emplace(message_, slide);
  contact_.reset();
  if (last_) injector_->remember(*last_);
  if (!ego_.states.empty()) begun_at_ = ego_.states.back().time;
  findContact(ego_);
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
  auto& states = ego_.states;
  if (!states.empty() && ego.time <= states.back().time) {
    states.clear();
    if (contact_ && ego.time < contact_->slide.begin) forgetContact();
  }
  states.push_back(ego);
  keepNewest(states, kept_for_);
  if (states.size() > 1) {
    findContact({ego_.id, ego_.agent_class, ego_.size, {*std::prev(states.end(), 2), ego}});
  }
  send();
}

/// With the poses of `ego`, the newest.
void LiveInjector::findContact(const Track& ego) {
  const bool is_over = contact_ || after_contact_ == AfterContact::kDriveOn;
  if (!injector_ || is_over || ego.states.empty()) return;
  const double end = std::min(ego.states.back().time, trajectory_.points.back().time);
  const auto time = firstContactTime(trajectory_, ego, end, verification_.overlap_tolerance);
  if (!time || *time <= trajectory_.points.front().time) return;
  deriveVelocities(ego_);
  contact_ = Contact{message_, slideFromContact(*time, trajectory_, ego_, verification_.drivable)};
  injector_->change(contact_->trajectory, contact_->slide);
}

void LiveInjector::forgetContact() {
  contact_.reset();
  injector_->change(message_, slideFromEnd(trajectory_, verification_.drivable));
}

void LiveInjector::send() {
  while (sendInBetween() || sendRecorded()) {
  }
}

/// False where none is due.
bool LiveInjector::sendInBetween() {
  if (!injector_ || !last_) return false;
  const double since = std::max({published_.toSec(), begun_at_, trajectory_.points.front().time});
  const double steps = std::floor((since - last_->header.stamp.toSec() + kSameTime) / step_) + 1.0;
  const double ahead = step_ * std::max(steps, 1.0);
  const ros::Time stamp = last_->header.stamp + ros::Duration(ahead);
  if (ahead > lastAhead() + kSameTime || !isEgoKnown(stamp)) return false;
  publish(frameAfter(before_last_.get(), *last_, stamp));
  return true;
}

/// Seconds after the last recorded frame up to which there may be frames in between.
double LiveInjector::lastAhead() const {
  if (!waiting_.empty()) {
    const double gap = secondsFrom(last_, waiting_.front()->header.stamp);
    return gap > kMaxGap ? 0.0 : gap - step_ / 2.0;
  }
  const double gap = before_last_ ? secondsFrom(before_last_, last_->header.stamp) : kMaxGap;
  return (gap < kMaxGap ? gap : kFrameInterval) - step_;
}

/// False where it has to wait, or there is none.
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
  publish_(injector_ ? injector_->inject(frame) : frame);
}

void LiveInjector::keep(const collision_forge::AgentArray::ConstPtr& recorded) {
  if (last_ && recorded->header.stamp <= last_->header.stamp) return;
  before_last_ = std::exchange(last_, recorded);
}

bool LiveInjector::isAfterNow(const ros::Time& stamp) const {
  return injector_ && stamp.toSec() > trajectory_.points.front().time;
}

bool LiveInjector::isEgoKnown(const ros::Time& stamp) const {
  return !ego_.states.empty() && stamp.toSec() <= ego_.states.back().time + kSameTime;
}

}  // namespace forge
