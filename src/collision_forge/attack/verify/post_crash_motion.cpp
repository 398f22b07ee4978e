#include "collision_forge/attack/verify/post_crash_motion.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/attack/severity/sliding_body.h"
#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

constexpr double kStep = 0.01;           // s, of the integration
constexpr double kLongestMotion = 30.0;  // s, a bound; 50 m/s end after about 11 s

/// Returns the vehicle at `time`, empty if the track has no state then. Times in messages and files
/// are rounded, so `time` may be up to kTimeEpsilon beyond an end of the track.
std::optional<CrashedVehicle> crashedAt(double time, const Track& track) {
  if (track.states.empty()) return std::nullopt;
  const double within = std::clamp(time, track.states.front().time, track.states.back().time);
  auto state = stateAt(track, within);
  if (!state || std::abs(within - time) > kTimeEpsilon) return std::nullopt;
  state->time = time;
  return CrashedVehicle{track.agent_class, track.size, *state};
}

AgentState stateOf(const SlidingBody& body, double time) {
  return {time, body.pose(), body.body().velocity};
}

/// The two bodies after the impact.
class CrashedPair {
 public:
  CrashedPair(const CrashedVehicle& ego, const CrashedVehicle& attacker,
              const SeverityOptions& options)
      : ego_party_(ego),
        attacker_party_(attacker),
        options_(options),
        ego_(engaged(ego, options), options),
        attacker_(engaged(attacker, options), options) {
    apply(impactOf(ego, attacker, options), meetingPoint());
  }

  void move(double duration, bool is_braking) {
    ego_.move(duration, is_braking);
    attacker_.move(duration, is_braking);
    press();
  }

  bool stand() const { return ego_.stands() && attacker_.stands(); }
  const SlidingBody& ego() const { return ego_; }
  const SlidingBody& attacker() const { return attacker_; }

 private:
  static CrashedVehicle engaged(CrashedVehicle party, const SeverityOptions& options) {
    party.state.pose.x += options.engagement * party.state.velocity.x();
    party.state.pose.y += options.engagement * party.state.velocity.y();
    return party;
  }

  OrientedBox egoBox() const { return {ego_.pose(), ego_party_.size}; }
  OrientedBox attackerBox() const { return {attacker_.pose(), attacker_party_.size}; }

  Vector2 meetingPoint() const {
    const auto middle = intersectionCentroid(egoBox(), attackerBox());
    return middle ? *middle : 0.5 * (ego_.body().center + attacker_.body().center);
  }

  void apply(const Impact& impact, const Vector2& point) {
    ego_.hit(impact.first, point);
    attacker_.hit(impact.second, point);
  }

  /// Ends a motion of the bodies into each other.
  void press() {
    const auto middle = intersectionCentroid(egoBox(), attackerBox());
    if (!middle) return;
    ImpactContact contact;
    contact.point = *middle;
    contact.normal = contactNormal(egoBox(), attackerBox());
    contact.friction = options_.friction;
    apply(planarImpact(ego_.body(), attacker_.body(), contact), *middle);
  }

  const CrashedVehicle& ego_party_;
  const CrashedVehicle& attacker_party_;
  const SeverityOptions& options_;
  SlidingBody ego_;
  SlidingBody attacker_;
};

}  // namespace

PostCrashMotion::PostCrashMotion(const CrashedVehicle& ego, const CrashedVehicle& attacker,
                                 const SeverityOptions& options)
    : ego_size_(ego.size), attacker_size_(attacker.size) {
  const double contact = ego.state.time;
  std::vector<Step> steps = {{contact, ego.state, attacker.state}};
  CrashedPair pair(ego, attacker, options);
  const auto add = [&](double time) {
    steps.push_back({time, stateOf(pair.ego(), time), stateOf(pair.attacker(), time)});
  };
  if (options.engagement > 0.0) add(contact + options.engagement);
  const double brakes_from = contact + options.after_impact.braking_delay;
  while (!pair.stand() && steps.back().time < contact + kLongestMotion) {
    const double time = steps.back().time + kStep;
    pair.move(kStep, time > brakes_from);
    add(time);
  }
  steps.back().ego.velocity = steps.back().attacker.velocity = {0.0, 0.0};
  steps_ = std::make_shared<const std::vector<Step>>(std::move(steps));
}

AgentState PostCrashMotion::stateAt(double time, AgentState Step::*of) const {
  const auto next = std::upper_bound(steps_->begin(), steps_->end(), time,
                                     [](double at, const Step& step) { return at < step.time; });
  if (next == steps_->begin() || next == steps_->end()) {
    AgentState state = (next == steps_->begin() ? steps_->front() : steps_->back()).*of;
    state.pose.yaw = wrapAngle(state.pose.yaw);
    state.time = time;
    return state;
  }
  const Step& before = *std::prev(next);
  const double ratio = (time - before.time) / (next->time - before.time);
  const AgentState& from = before.*of;
  const AgentState& to = (*next).*of;
  const auto between = [&](double a, double b) { return a + ratio * (b - a); };
  return {time,
          {between(from.pose.x, to.pose.x), between(from.pose.y, to.pose.y),
           wrapAngle(between(from.pose.yaw, to.pose.yaw))},
          from.velocity + ratio * (to.velocity - from.velocity)};
}

AgentState PostCrashMotion::egoAt(double time) const { return stateAt(time, &Step::ego); }

AgentState PostCrashMotion::attackerAt(double time) const { return stateAt(time, &Step::attacker); }

std::optional<PostCrashMotion> motionAfterContact(double contact_time, const Track& other,
                                                  const Track& ego,
                                                  const SeverityOptions& options) {
  const auto crashed_ego = crashedAt(contact_time, ego);
  const auto crashed_other = crashedAt(contact_time, other);
  if (!crashed_ego || !crashed_other) return std::nullopt;
  return PostCrashMotion(*crashed_ego, *crashed_other, options);
}

std::optional<PostCrashMotion> motionAfterContact(double contact_time,
                                                  const AttackerTrajectory& trajectory,
                                                  const Track& ego,
                                                  const SeverityOptions& options) {
  const Track attacker{trajectory.attacker_id, trajectory.agent_class, trajectory.size,
                       toStates(trajectory.points)};
  return motionAfterContact(contact_time, attacker, ego, options);
}

std::optional<PostCrashMotion> motionAfterContact(const CollisionReport& report,
                                                  const AttackerTrajectory& trajectory,
                                                  const Track& ego,
                                                  const SeverityOptions& options) {
  if (!report.contact) return std::nullopt;
  return motionAfterContact(report.contact_time, trajectory, ego, options);
}

std::vector<SecondaryContact> secondaryContacts(const PostCrashMotion& motion,
                                                const std::string& other_id,
                                                const std::vector<Track>& agents) {
  constexpr double kInterval = 0.05;  // s
  const double begin = motion.contactTime();
  const auto touches = [&](bool is_ego, const Track& agent, double time) {
    const auto state = stateAt(agent, time);
    if (!state) return false;
    const OrientedBox box = is_ego
                                ? OrientedBox{motion.egoAt(time).pose, motion.egoSize()}
                                : OrientedBox{motion.attackerAt(time).pose, motion.attackerSize()};
    return overlaps(box, {state->pose, agent.size});
  };
  std::vector<SecondaryContact> contacts;
  for (const Track& agent : agents) {
    if (agent.id == other_id) continue;
    for (const bool is_ego : {true, false}) {
      if (touches(is_ego, agent, begin)) continue;
      for (double time = begin; time <= motion.standTime(); time += kInterval) {
        if (!touches(is_ego, agent, time)) continue;
        contacts.push_back({time, is_ego, agent.id});
        break;
      }
    }
  }
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const auto& a, const auto& b) { return a.time < b.time; });
  return contacts;
}

}  // namespace forge
