#include "collision_forge/io/drawing/scenario_motion.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/geometry/touch_point.h"
#include "collision_forge/base/scene/find_track.h"

namespace forge {
namespace {

constexpr double kSampleStep = 0.1;  // s

std::optional<OrientedBox> boxOf(const Track& track, double time) {
  const std::optional<AgentState> state = stateAt(track, time);
  if (!state) return std::nullopt;
  return boxAt(track, state->pose);
}

template <typename BoxAtTime>
std::vector<OrientedBox> sample(double from, double to, const BoxAtTime& box_at) {
  std::vector<OrientedBox> boxes;
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from) / kSampleStep - 1e-9)));
  for (int i = 0; i <= steps; ++i) {
    const std::optional<OrientedBox> box = box_at(i == steps ? to : from + i * kSampleStep);
    if (box) boxes.push_back(*box);
  }
  return boxes;
}

}  // namespace

double ScenarioMotion::keyTime() const {
  if (view_.report.contact) return view_.report.contact_time;
  return view_.avoided_hit.value_or(view_.pattern.time);
}

double ScenarioMotion::standTime() const {
  return hasRest(view_) ? view_.crash->standTime() : keyTime();
}

double ScenarioMotion::endTime() const {
  return std::max(standTime(), std::min(standTime() + view_.seconds_after_stand, lastKnownTime()));
}

/// Without a contact, the end of the motion of ego and attacker; with one, of the recording.
double ScenarioMotion::lastKnownTime() const {
  double last = view_.future.ego.states.back().time;
  if (!view_.report.contact) {
    const auto& points = view_.trajectory.points;
    return points.empty() ? last : std::min(last, points.back().time);
  }
  for (const Track& track : view_.future.agents) {
    if (!track.states.empty()) last = std::max(last, track.states.back().time);
  }
  return last;
}

bool ScenarioMotion::isAfterContact(double time) const {
  return view_.report.contact && time >= view_.report.contact_time;
}

std::optional<OrientedBox> ScenarioMotion::egoAt(double time) const {
  if (isAfterContact(time)) {
    return boxAt(view_.snapshot.ego,
                 view_.crash ? view_.crash->egoAt(time).pose : view_.report.ego_at_contact);
  }
  return boxOf(time <= now() ? view_.snapshot.ego : view_.future.ego, time);
}

std::optional<OrientedBox> ScenarioMotion::attackerAt(double time) const {
  const AttackerTrajectory& trajectory = view_.trajectory;
  if (isAfterContact(time)) {
    return OrientedBox{
        view_.crash ? view_.crash->attackerAt(time).pose : view_.report.attacker_at_contact,
        trajectory.size};
  }
  if (time > now()) {
    const auto& points = trajectory.points;
    if (points.empty() || time < points.front().time || time > points.back().time) {
      return std::nullopt;
    }
    return OrientedBox{poseAt(trajectory, time), trajectory.size};
  }
  if (trajectory.isAdded()) {
    return boxOf({trajectory.attacker_id, trajectory.agent_class, trajectory.size, trajectory.past},
                 time);
  }
  const Track* past = findTrack(view_.snapshot.agents, trajectory.attacker_id);
  return past == nullptr ? std::nullopt : boxOf(*past, time);
}

bool ScenarioMotion::isSupport(const std::string& id) const {
  return std::find(view_.supports.begin(), view_.supports.end(), id) != view_.supports.end();
}

std::vector<AgentBox> ScenarioMotion::otherAgentsAt(double time) const {
  std::vector<AgentBox> boxes;
  for (const Track& track : time <= now() ? view_.snapshot.agents : view_.future.agents) {
    if (track.id == view_.trajectory.attacker_id) continue;
    const std::optional<OrientedBox> box = boxOf(track, time);
    if (box) boxes.push_back({track.agent_class, *box, isSupport(track.id)});
  }
  return boxes;
}

std::optional<double> ScenarioMotion::egoSpeedAt(double time) const {
  const auto state = stateAt(time <= now() ? view_.snapshot.ego : view_.future.ego, time);
  if (!state) return std::nullopt;
  return state->velocity.norm();
}

std::optional<double> ScenarioMotion::attackerSpeedAt(double time) const {
  const Track driven{view_.trajectory.attacker_id, view_.trajectory.agent_class,
                     view_.trajectory.size, toStates(view_.trajectory.points)};
  const auto state = stateAt(driven, time);
  if (!state) return std::nullopt;
  return state->velocity.norm();
}

std::optional<OrientedBox> ScenarioMotion::recordedAttackerAt(double time) const {
  if (time < now() || view_.trajectory.isAdded()) return std::nullopt;
  const Track* track = findTrack(view_.future.agents, view_.trajectory.attacker_id);
  return track == nullptr ? std::nullopt : boxOf(*track, time);
}

std::optional<double> ScenarioMotion::lastPassing(const OrientedBox& box) const {
  const int steps = static_cast<int>(std::ceil((keyTime() - now()) / kSampleStep)) - 1;
  for (int i = steps; i >= 0; --i) {
    const double time = now() + i * kSampleStep;
    for (const auto& mover : {egoAt(time), attackerAt(time)}) {
      if (mover && overlaps(*mover, box)) return time;
    }
  }
  return std::nullopt;
}

std::vector<ScenarioMotion::Passed> ScenarioMotion::passedAgents() const {
  std::vector<Passed> passed;
  for (const Track& track : view_.future.agents) {
    if (track.id == view_.trajectory.attacker_id) continue;
    const auto at_key_time = boxOf(track, keyTime());
    const auto time = at_key_time ? lastPassing(*at_key_time) : std::nullopt;
    const auto then = time ? boxOf(track, *time) : std::nullopt;
    if (then) {
      const bool is_support = isSupport(track.id);
      passed.push_back(
          {{track.agent_class, *then, is_support}, {track.agent_class, *at_key_time, is_support}});
    }
  }
  return passed;
}

std::vector<OrientedBox> ScenarioMotion::egoBoxes(double from, double to) const {
  return sample(from, to, [this](double time) { return egoAt(time); });
}

std::vector<OrientedBox> ScenarioMotion::attackerBoxes(double from, double to) const {
  return sample(from, to, [this](double time) { return attackerAt(time); });
}

std::vector<OrientedBox> ScenarioMotion::recordedAttackerBoxes(double from, double to) const {
  return sample(from, to, [this](double time) { return recordedAttackerAt(time); });
}

Vector2 ScenarioMotion::contactPoint() const {
  if (view_.avoided_hit) {
    const auto ego = egoAt(keyTime());
    const auto attacker = attackerAt(keyTime());
    if (ego && attacker) return (ego->center.position() + attacker->center.position()) / 2;
  }
  if (!view_.report.contact) {
    return (view_.pattern.ego.center.position() + patternAttackerBox(view_).center.position()) / 2;
  }
  return touchPoint(boxAt(view_.snapshot.ego, view_.report.ego_at_contact),
                    {view_.report.attacker_at_contact, view_.trajectory.size});
}

Vector2 ScenarioMotion::closeUpCenter(double time) const {
  if (!isAfterContact(time)) return contactPoint();
  const auto middle = [this](double instant) -> Vector2 {
    return (egoAt(instant)->center.position() + attackerAt(instant)->center.position()) / 2.0;
  };
  return contactPoint() + (middle(time) - middle(keyTime()));
}

OrientedBox patternAttackerBox(const ScenarioView& view) {
  return {compose(view.pattern.ego.center, view.pattern.attacker_offset), view.trajectory.size};
}

}  // namespace forge
