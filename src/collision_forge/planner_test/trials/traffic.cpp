#include "collision_forge/planner_test/trials/traffic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "collision_forge/base/geometry/enum_words.h"
#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

constexpr EnumWord<Background> kBackgroundWords[] = {
    {Background::kReplay, "replay"},
    {Background::kIdm, "idm"},
    {Background::kModel, "model"},
};

/// Interpolates linearly between the states; constant beyond them.
double arcLengthAt(const std::vector<AgentState>& states, const std::vector<double>& arc_lengths,
                   double time) {
  const auto after =
      std::lower_bound(states.begin(), states.end(), time,
                       [](const AgentState& state, double value) { return state.time < value; });
  if (after == states.begin()) return arc_lengths.front();
  if (after == states.end()) return arc_lengths.back();
  const auto i = static_cast<std::size_t>(after - states.begin());
  const double ratio = (time - states[i - 1].time) / (states[i].time - states[i - 1].time);
  return arc_lengths[i - 1] + ratio * (arc_lengths[i] - arc_lengths[i - 1]);
}

/// Returns the latest time, at most `latest`, at which the recording had driven no farther.
double timeAt(const std::vector<AgentState>& states, const std::vector<double>& arc_lengths,
              double arc_length, double latest) {
  const auto after = std::upper_bound(arc_lengths.begin(), arc_lengths.end(), arc_length);
  if (after == arc_lengths.end()) return latest;
  const auto i = static_cast<std::size_t>(after - arc_lengths.begin());
  const double ratio = (arc_length - arc_lengths[i - 1]) / (arc_lengths[i] - arc_lengths[i - 1]);
  return std::min(states[i - 1].time + ratio * (states[i].time - states[i - 1].time), latest);
}

}  // namespace

const char* toString(Background background) { return wordOf(kBackgroundWords, background); }

std::optional<Background> backgroundFromString(const std::string& name) {
  return valueOf(kBackgroundWords, name);
}

Traffic::Traffic(const CrashScenario& scenario, std::unique_ptr<AttackerPolicy> attacker,
                 Background background, const IdmOptions& idm, double history,
                 std::shared_ptr<BackgroundModel> model)
    : attacker_(std::move(attacker)),
      idm_(idm),
      history_(history),
      time_(scenario.snapshot.now),
      model_(std::move(model)) {
  for (Track& track : agentsFromT0(scenario)) {
    Driver driver;
    driver.shown = Track{track.id, track.agent_class, track.size, {}, track.height};
    driver.is_attacker = drivers_.empty();
    driver.clock = time_;
    driver.recorded = std::move(track);
    for (const Track& agent : scenario.snapshot.agents) {
      if (agent.id == driver.recorded.id) driver.shown.states = agent.states;
    }
    const bool reacts = background == Background::kIdm && !driver.is_attacker &&
                        isMotorVehicle(driver.recorded.agent_class);
    if (reacts) prepareToReact(driver);
    driver.is_modelled = background == Background::kModel && !driver.is_attacker &&
                         driver.recorded.agent_class != AgentClass::kStaticObject;
    drivers_.push_back(std::move(driver));
  }
  for (Driver& driver : drivers_) {
    if (!endsAt(driver.shown, time_)) show(driver, 0.0);
  }
  collect();
}

Traffic::Traffic(const Traffic& other)
    : attacker_(other.attacker_->clone()),
      idm_(other.idm_),
      history_(other.history_),
      time_(other.time_),
      model_(other.model_),
      ego_history_(other.ego_history_),
      drivers_(other.drivers_),
      agents_(other.agents_) {}

/// Prepares a vehicle to react; one that hardly moves in the recording has no path and keeps
/// replaying.
void Traffic::prepareToReact(Driver& driver) {
  constexpr double kShortest = 2.0;  // m
  std::vector<Vector2> points;
  const auto& states = driver.recorded.states;
  for (const AgentState& state : states) {
    const double step = points.empty() ? 0.0 : (state.pose.position() - points.back()).norm();
    const double before = points.empty() ? 0.0 : driver.arc_lengths.back();
    if (!points.empty()) {
      const double duration = state.time - states[points.size() - 1].time;
      driver.top_speed = std::max(driver.top_speed, step / duration);
    }
    driver.arc_lengths.push_back(before + step);
    points.push_back(state.pose.position());
  }
  if (driver.arc_lengths.back() < kShortest) return;
  driver.way.emplace(points);
  driver.speed = states.front().velocity.norm();
}

void Traffic::advance(double time, const Track& ego) {
  attacker_->observe({time_, ego.states.back().pose, agentsAt(agents_, time_)});
  drivers_.front().recorded.states = toStates(attacker_->trajectory().points);
  std::vector<Track> in_sight = agents_;
  in_sight.push_back(ego);
  const double step = time - time_;
  for (Driver& driver : drivers_) drive(driver, time, in_sight);
  if (model_) {
    remember(ego.states.back());
    moveModelled(time);
  }
  time_ = time;
  for (Driver& driver : drivers_) show(driver, step);
  collect();
}

void Traffic::drive(Driver& driver, double time, const std::vector<Track>& in_sight) const {
  const auto& states = driver.recorded.states;
  if (!driver.way || time_ < states.front().time) {
    driver.clock = time;
    return;
  }
  const double step = time - time_;
  const double here = arcLengthAt(states, driver.arc_lengths, driver.clock);
  double next = std::max(arcLengthAt(states, driver.arc_lengths, time) - here, 0.0) / step;
  IdmParameters law = idm_.law;
  law.desired_speed = std::max(driver.top_speed, kTimeEpsilon);
  if (driver.clock < time_ - kTimeEpsilon) {
    next = std::min({next, driver.top_speed, driver.speed + law.max_acceleration * step});
  }
  const auto lead =
      findLead({*driver.way, here, driver.recorded.size}, driver.recorded.id, in_sight, idm_.lead);
  if (lead) {
    const double demanded =
        idmAcceleration(law, driver.speed, lead->speed, std::max(lead->gap, kTouchingGap));
    next = std::min(next, std::max(driver.speed + demanded * step, 0.0));
  }
  driver.speed = next;
  driver.clock = timeAt(states, driver.arc_lengths, here + next * step, time);
}

void Traffic::remember(const AgentState& ego) {
  TrajectoryPoint point{ego.time, ego.pose, ego.velocity.dot(ego.pose.heading()), 0.0, 0.0};
  if (!ego_history_.empty()) {
    const TrajectoryPoint& before = ego_history_.back();
    point.acceleration = (point.speed - before.speed) / (point.time - before.time);
  }
  ego_history_.push_back(point);
  const auto kept = std::find_if(
      ego_history_.begin(), ego_history_.end(),
      [&](const TrajectoryPoint& past) { return past.time >= ego.time - history_ - kTimeEpsilon; });
  ego_history_.erase(ego_history_.begin(), kept);
}

/// Sets the poses of the modelled agents at `time`.
void Traffic::moveModelled(double time) {
  const std::map<std::string, Pose2> poses = model_->next(ego_history_, agents_, time - time_);
  for (Driver& driver : drivers_) {
    if (!driver.is_modelled || !endsAt(driver.shown, time_)) continue;
    const AgentState& here = driver.shown.states.back();
    const auto found = poses.find(driver.shown.id);
    if (found != poses.end()) {
      driver.pose = found->second;
    } else {
      const Vector2 place = here.pose.position() + (time - time_) * here.velocity;
      driver.pose = Pose2{place.x(), place.y(), here.pose.yaw};
    }
  }
}

/// Appends the driver's current state, if it is in sight, with the velocity over the last step.
void Traffic::show(Driver& driver, double step) const {
  // A delayed vehicle may wait at a place where the recording has lost it.
  auto state = stateAt(driver.recorded, driver.clock,
                       driver.way ? std::numeric_limits<double>::infinity() : kMaxGap);
  if (driver.pose) state = AgentState{time_, *driver.pose, Vector2::Zero()};
  if (!state) return;
  state->time = time_;
  auto& states = driver.shown.states;
  if (!driver.is_attacker) {
    const bool was_there = !states.empty() && states.back().time >= time_ - step - kTimeEpsilon;
    state->velocity = Vector2::Zero();
    if (was_there && step > 0.0) {
      state->velocity = (state->pose.position() - states.back().pose.position()) / step;
    }
  }
  states.push_back(*state);
  const auto kept = std::find_if(states.begin(), states.end(), [&](const AgentState& shown) {
    return shown.time >= time_ - history_;
  });
  states.erase(states.begin(), kept);
}

void Traffic::collect() {
  agents_.clear();
  for (const Driver& driver : drivers_) {
    if (endsAt(driver.shown, time_)) agents_.push_back(driver.shown);
  }
}

}  // namespace forge
