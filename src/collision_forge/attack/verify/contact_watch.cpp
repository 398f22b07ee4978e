#include "collision_forge/attack/verify/contact_watch.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "collision_forge/base/scene/scene_history.h"

namespace forge {

ContactWatch::ContactWatch(const BoxSize& ego_size, double kept_for,
                           const VerificationOptions& options)
    : options_(options), kept_for_(kept_for), ego_{kEgoId, AgentClass::kCar, ego_size, {}} {}

void ContactWatch::start(AttackerTrajectory trajectory) {
  trajectory_ = std::move(trajectory);
  crash_.reset();
  find(ego_);
}

void ContactWatch::change(AttackerTrajectory trajectory) { trajectory_ = std::move(trajectory); }

void ContactWatch::stop() {
  trajectory_ = {};
  crash_.reset();
}

void ContactWatch::addEgo(const AgentState& ego) {
  auto& states = ego_.states;
  if (!states.empty() && ego.time <= states.back().time) {
    states.clear();
    if (crash_ && ego.time < crash_->contactTime()) crash_.reset();
  }
  states.push_back(ego);
  keepNewest(states, kept_for_);
  deriveVelocities(ego_);
  if (states.size() < 2) return;
  if (crash_) {
    if (!is_complete_) setCrash(crash_->contactTime());
  } else {
    find(between(*std::prev(states.end(), 2), states.back()));
  }
}

void ContactWatch::find(const Track& ego) {
  const auto contact = contactWith(ego);
  if (!contact) return;
  crashed_ = trajectory_;
  setCrash(*contact);
}

std::optional<PostCrashMotion> ContactWatch::crashBefore(const AgentState& ego) const {
  if (crash_ || ego_.states.empty() || ego.time <= ego_.states.back().time) return std::nullopt;
  const auto contact = contactWith(between(ego_.states.back(), ego));
  if (!contact) return std::nullopt;
  Track predicted = ego_;
  predicted.states.push_back(ego);
  deriveVelocities(predicted);
  return motionAfterContact(*contact, trajectory_, predicted, options_.severity);
}

Track ContactWatch::between(const AgentState& from, const AgentState& to) const {
  return {ego_.id, ego_.agent_class, ego_.size, {from, to}};
}

/// Returns the first contact of the attack with `ego` after the attack's start, s.
std::optional<double> ContactWatch::contactWith(const Track& ego) const {
  if (trajectory_.points.empty() || ego.states.empty()) return std::nullopt;
  const double end = std::min(ego.states.back().time, trajectory_.points.back().time);
  const auto time = firstContactTime(trajectory_, ego, end, options_.overlap_tolerance);
  return time && *time > trajectory_.points.front().time ? time : std::nullopt;
}

/// Keeps the earlier crash if the poses around the contact are gone, after a replay went back.
void ContactWatch::setCrash(double contact_time) {
  const auto crash = motionAfterContact(contact_time, crashed_, ego_, options_.severity);
  if (crash) crash_ = crash;
  const auto& states = ego_.states;
  is_complete_ = states.size() > 1 && std::prev(states.end(), 2)->time >= contact_time;
}

}  // namespace forge
