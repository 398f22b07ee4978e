#include "collision_forge/attack/search/added_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace forge {
namespace {

constexpr int kBranches = 4;            // paths back from a lane that are examined
constexpr double kWayAhead = 40.0;      // m of the path beyond the contact
constexpr double kTrainDistance = 8.0;  // m from the path, within which the ego is followed
constexpr double kSameSpeed = 1.0;      // m/s
constexpr double kHeadsAlong = 0.7;     // rad between the ego and a path on which it is
constexpr std::size_t kFlows = 3;       // per path
constexpr double kFlowLength = 15.0;    // m; shorter recorded motions are not repeated
constexpr std::size_t kOwnSpeeds = 2;   // speeds of recorded vehicles per path

/// Returns true if the box contains a point of the ray from `from` along `direction`.
bool meetsRay(const Eigen::AlignedBox2d& box, const Vector2& from, const Vector2& direction) {
  double first = 0.0;
  double last = std::numeric_limits<double>::infinity();
  for (const Eigen::Index axis : {0, 1}) {
    const double low = box.min()[axis] - from[axis];
    const double high = box.max()[axis] - from[axis];
    if (direction[axis] == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    const auto [near, far] = std::minmax({low / direction[axis], high / direction[axis]});
    first = std::max(first, near);
    last = std::min(last, far);
  }
  return first <= last;
}

/// Returns false only if no position of the track is within AddedPath::kInLane of the path or of
/// its straight continuations.
bool comesNear(const Track& track, const ReferencePath& path) {
  constexpr double kRounding = 1e-3;  // m
  Eigen::AlignedBox2d box;
  for (const AgentState& state : track.states) box.extend(state.pose.position());
  const Vector2 margin = Vector2::Constant(AddedPath::kInLane + kRounding);
  box.extend(Vector2(box.min() - margin));
  box.extend(Vector2(box.max() + margin));
  Eigen::AlignedBox2d hull;  // of the spline
  for (const Vector2& control : path.controls()) hull.extend(control);
  const ReferencePath::PathPoint begin = path.at(0.0);
  const ReferencePath::PathPoint end = path.at(path.length());
  return box.intersects(hull) || meetsRay(box, begin.pose.position(), -begin.heading) ||
         meetsRay(box, end.pose.position(), end.heading);
}

}  // namespace

double AddedFlow::at(double time) const {
  const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, time);
  const auto i = static_cast<std::size_t>(after - times.begin());
  const double ratio = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return alongs[i - 1] + std::clamp(ratio, 0.0, 1.0) * (alongs[i] - alongs[i - 1]);
}

std::optional<double> AddedFlow::passing(double along) const {
  const auto after = std::upper_bound(alongs.begin(), alongs.end(), along);
  if (after == alongs.begin() || after == alongs.end()) return std::nullopt;
  const auto i = static_cast<std::size_t>(after - alongs.begin());
  const double ratio = (along - alongs[i - 1]) / (alongs[i] - alongs[i - 1]);
  return times[i - 1] + ratio * (times[i] - times[i - 1]);
}

double AddedPath::cap(double along) const {
  const double place =
      std::clamp(along / ReferencePath::kBendSpacing, 0.0, static_cast<double>(caps.size() - 1));
  return caps[static_cast<std::size_t>(place)];
}

void addSpeed(double speed, std::vector<double>& speeds) {
  const bool has = std::any_of(speeds.begin(), speeds.end(),
                               [&](double other) { return std::abs(other - speed) < kSameSpeed; });
  if (!has) speeds.push_back(speed);
}

std::size_t stepsBack(const Snapshot& past) {
  const double known = past.now - past.ego.states.front().time;
  return static_cast<std::size_t>(std::ceil(known / AddedPath::kStep - 1e-6));
}

AddedPaths::AddedPaths(const AddedVehicleInput& input, const AddedVehicleOptions& options)
    : input_(input),
      options_(options),
      past_(input.known()),
      steps_back_(stepsBack(past_)),
      ways_to_(input.driven()) {}

const std::vector<std::unique_ptr<AddedPath>>& AddedPaths::to(const FittingLane& fitting) {
  const auto [entry, is_new] = ways_.try_emplace(fitting.lane);
  if (is_new) {
    double fastest = *std::max_element(options_.speeds.begin(), options_.speeds.end());
    fastest = std::max(fastest, past_.ego.states.back().velocity.norm());
    for (const Track& agent : past_.agents) {
      fastest = std::max(fastest, agent.states.back().velocity.norm());
    }
    const double back =
        fastest * (AddedPath::kStep * static_cast<double>(steps_back_) + input_.request.tta);
    for (const Polyline& line : ways_to_.to(fitting.lane, fitting.arc_length, back, kWayAhead,
                                            static_cast<std::size_t>(kBranches))) {
      entry->second.push_back(wayOf(line));
    }
  }
  return entry->second;
}

std::unique_ptr<AddedPath> AddedPaths::wayOf(const Polyline& line) const {
  auto way = std::make_unique<AddedPath>(line);
  addCaps(*way);
  followEgo(*way);
  addSpeeds(*way);
  addFlows(*way);
  return way;
}

void AddedPaths::addCaps(AddedPath& way) const {
  constexpr double kSpacing = ReferencePath::kBendSpacing;
  std::vector<double>& caps = way.caps;
  for (const double bend : way.path.curvatures())
    caps.push_back(std::sqrt(AddedPath::kLateral / bend));
  const auto hold = [&](double& cap, double next) {
    cap = std::min(cap, std::sqrt(next * next + 2.0 * AddedPath::kBraking * kSpacing));
  };
  for (std::size_t i = caps.size() - 1; i-- > 0;) hold(caps[i], caps[i + 1]);
  for (std::size_t i = 1; i < caps.size(); ++i) hold(caps[i], caps[i - 1]);
}

void AddedPaths::followEgo(AddedPath& way) const {
  for (std::size_t i = 0; i <= steps_back_; ++i) {
    const double time = past_.now - AddedPath::kStep * static_cast<double>(i);
    const auto state = stateAt(past_.ego, std::max(time, past_.ego.states.front().time));
    if (!state) return;
    const double along = way.path.project(state->pose.position());
    const Pose2 apart = relativeTo(way.path.at(along).pose, state->pose);
    if (i == 0) way.ego_across = apart.y;
    if (std::abs(apart.y) > kTrainDistance || std::abs(apart.yaw) > kHeadsAlong) return;
    way.ego.push_back(along);
  }
}

void AddedPaths::addSpeeds(AddedPath& way) const {
  const double range = options_.sensing_range;
  for (const Track& agent : input_.snapshot.agents) {
    const AgentState& state = agent.states.back();
    const double speed = state.velocity.norm();
    if (way.speeds.size() >= kOwnSpeeds || speed < AddedPath::kMoving ||
        !isMotorVehicle(agent.agent_class) ||
        (state.pose.position() - past_.ego.states.back().pose.position()).norm() > range) {
      continue;
    }
    const Pose2 place = way.path.at(way.path.project(state.pose.position())).pose;
    const Pose2 apart = relativeTo(place, state.pose);
    if (apart.position().norm() < AddedPath::kInLane && std::abs(apart.yaw) < kHeadsAlong) {
      addSpeed(speed, way.speeds);
    }
  }
}

/// Adds the longest motion of each vehicle along the path, before and after t0.
void AddedPaths::addFlows(AddedPath& way) const {
  for (const Track& agent : past_.agents) {
    if (way.flows.size() >= kFlows) return;
    if (!isMotorVehicle(agent.agent_class)) continue;
    const auto later = std::find_if(input_.future.agents.begin(), input_.future.agents.end(),
                                    [&](const Track& track) { return track.id == agent.id; });
    const bool has_later = later != input_.future.agents.end() && !later->states.empty();
    const AgentState& last = has_later ? later->states.back() : agent.states.back();
    const Vector2 from = agent.states.front().pose.position();
    if ((last.pose.position() - from).norm() < kFlowLength) continue;
    AddedFlow flow;
    const bool goes_on = !comesNear(agent, way.path) || follow(agent, way, flow);
    if (goes_on && has_later && comesNear(*later, way.path)) follow(*later, way, flow);
    if (flow.times.size() > 2 && flow.alongs.back() - flow.alongs.front() > kFlowLength) {
      way.flows.push_back(std::move(flow));
    }
  }
}

/// Appends the track's positions along the path; returns false where it leaves the path.
bool AddedPaths::follow(const Track& track, const AddedPath& way, AddedFlow& flow) const {
  for (const AgentState& state : track.states) {
    const double time = state.time - past_.now;
    if (!flow.times.empty() && time <= flow.times.back()) continue;
    const double along = way.path.project(state.pose.position());
    const Pose2 apart = relativeTo(way.path.at(along).pose, state.pose);
    if (apart.position().norm() > AddedPath::kInLane || std::abs(apart.yaw) > kHeadsAlong) {
      if (flow.times.size() > 2) return false;
      flow = {};
      continue;
    }
    flow.times.push_back(time);
    flow.alongs.push_back(flow.alongs.empty() ? along : std::max(along, flow.alongs.back()));
  }
  return true;
}

}  // namespace forge
