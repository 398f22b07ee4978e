#include "collision_forge/base/scene/input_limits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace forge {
namespace {

template <typename... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream message;
  message.precision(12);
  (message << ... << parts);
  throw InputError(message.str());
}

/// Returns false for NaN.
bool isWithin(double value, double min, double max) { return value >= min && value <= max; }

// Keys that several checks name.
constexpr char kMaxCoordinate[] = "max_coordinate";
constexpr char kMaxSpeed[] = "max_speed";
constexpr char kMaxAgents[] = "max_agents";

/// Words that name the key of a limit; "" for a limit that is fixed.
std::string settingWords(const char* key) {
  return *key == '\0' ? "" : ", " + std::string(key) + " in input_limits.yaml";
}

void check(double value, double min, double max, const std::string& field, const char* key = "") {
  if (isWithin(value, min, max)) return;
  refuse(field, " = ", value, " is outside ", min, " to ", max, settingWords(key));
}

void checkCount(std::size_t count, int max, const std::string& what, const char* key = "") {
  if (count <= static_cast<std::size_t>(max)) return;
  refuse(what, ": ", count, " is above the limit of ", max, settingWords(key));
}

void check(const Vector2& position, const InputLimits& limits, const std::string& field) {
  const double most = limits.max_coordinate;
  check(position.x(), -most, most, field + ".x", kMaxCoordinate);
  check(position.y(), -most, most, field + ".y", kMaxCoordinate);
}

void check(const Pose2& pose, const InputLimits& limits, const std::string& field) {
  check(pose.position(), limits, field);
  if (!std::isfinite(pose.yaw)) refuse(field, ".yaw = ", pose.yaw, " is not finite");
}

void check(const BoxSize& size, const InputLimits& limits, const std::string& field) {
  check(size.length, limits.min_box, limits.max_box, field + ".length");
  check(size.width, limits.min_box, limits.max_box, field + ".width");
}

bool isWithin(const AgentState& state, const InputLimits& limits) {
  return isWithin(state.time, 0.0, limits.max_time) && isWithin(state.pose, limits) &&
         isWithin(state.velocity.norm(), 0.0, limits.max_speed);
}

void check(const AgentState& state, const InputLimits& limits, const std::string& field) {
  check(state.time, 0.0, limits.max_time, field + ".time");
  check(state.pose, limits, field);
  check(state.velocity.norm(), 0.0, limits.max_speed, field + ".speed", kMaxSpeed);
}

std::string element(const std::string& list, std::size_t index) {
  return list + "[" + std::to_string(index) + "]";
}

void checkTimes(double before, double time, const std::string& field) {
  if (!(time > before)) refuse(field, ".time = ", time, " is not after ", before);
}

void checkTrack(const Track& track, const InputLimits& limits, const std::string& name) {
  check(track.size, limits, name);
  for (std::size_t i = 0; i < track.states.size(); ++i) {
    const AgentState& state = track.states[i];
    const bool is_later = i == 0 || state.time > track.states[i - 1].time;
    if (isWithin(state, limits) && is_later) continue;  // makes no words for thousands of states
    const std::string field = element(name + ": states", i);
    check(state, limits, field);
    if (i > 0) checkTimes(track.states[i - 1].time, state.time, field);
  }
}

/// Checks that the intervals of the ego's states fit the unit of their clock, s.
void checkIntervals(const Track& ego, const std::string& name) {
  constexpr double kShortest = 2e-4;  // s; nothing records poses at more than 5 kHz
  if (ego.states.size() < 3) return;
  std::vector<double> intervals;
  for (std::size_t i = 1; i < ego.states.size(); ++i) {
    intervals.push_back(ego.states[i].time - ego.states[i - 1].time);
  }
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  if (*middle <= 0.0 || isWithin(*middle, kShortest, kMaxGap)) return;
  refuse(name, ": the median interval of its states, ", *middle, " s, is outside ", kShortest,
         " to ", kMaxGap, " s: check the unit of the stamps");
}

/// Checks that the frames of agents and the states of the ego have one clock.
void checkOneClock(const Scene& scene, const std::string& where) {
  constexpr double kFarthest = 10.0;  // s
  const auto& states = scene.ego.states;
  const auto& frames = scene.frame_times;
  if (states.empty() || frames.empty()) return;
  if (frames.front() <= states.back().time + kFarthest &&
      states.front().time <= frames.back() + kFarthest) {
    return;
  }
  refuse(where, ": stamps of agents (", frames.front(), " to ", frames.back(),
         " s) and of the ego (", states.front().time, " to ", states.back().time,
         " s) do not overlap: both must have one clock");
}

/// Checks a future of the ego, which must have at least one state.
void checkFutureTrack(const Track& track, const InputLimits& limits, const std::string& name) {
  if (track.states.empty()) refuse(name, ": states is empty");
  checkTrack(track, limits, name);
}

/// Returns the reason why an agent cannot be used; null if it can.
const char* problemOf(const Track& agent, const InputLimits& limits) {
  if (!isWithin(agent.size, limits)) return "with a box beyond the input limits";
  const bool is_within =
      std::all_of(agent.states.begin(), agent.states.end(),
                  [&](const AgentState& state) { return isWithin(state, limits); });
  return is_within ? nullptr : "with a motion beyond the input limits";
}

void checkRing(const std::vector<Vector2>& ring, const InputLimits& limits, std::size_t& points,
               const std::string& name) {
  points += ring.size();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!isWithin(ring[i], limits)) check(ring[i], limits, element(name, i));
  }
}

void checkAreas(const std::vector<Polygon>& areas, const InputLimits& limits, std::size_t& points,
                const std::string& name) {
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const std::string area = element(name, i);
    checkRing(areas[i].exterior, limits, points, area + ".exterior");
    for (const auto& hole : areas[i].holes) checkRing(hole, limits, points, area + ".holes");
  }
}

}  // namespace

bool isWithin(const Vector2& position, const InputLimits& limits) {
  return isWithin(position.x(), -limits.max_coordinate, limits.max_coordinate) &&
         isWithin(position.y(), -limits.max_coordinate, limits.max_coordinate);
}

bool isWithin(const Pose2& pose, const InputLimits& limits) {
  return isWithin(pose.position(), limits) && std::isfinite(pose.yaw);
}

bool isWithin(const BoxSize& size, const InputLimits& limits) {
  return isWithin(size.length, limits.min_box, limits.max_box) &&
         isWithin(size.width, limits.min_box, limits.max_box);
}

void checkMap(const LaneMap& map, const InputLimits& limits, const std::string& where) {
  checkCount(map.lanes.size(), limits.max_lanes, where + ": lanes", "max_lanes");
  std::size_t points = 0;
  for (const Lane& lane : map.lanes) {
    const std::string name = where + ": lane \"" + lane.id + "\": ";
    checkCount(lane.centerline.size(), limits.max_points, name + "points of the centreline");
    points += lane.centerline.size();
    for (std::size_t i = 0; i < lane.centerline.size(); ++i) {
      if (isWithin(lane.centerline[i], limits)) continue;
      check(lane.centerline[i], limits, element(name + "centerline", i));
    }
    checkRing(lane.polygon, limits, points, name + "polygon");
    if (lane.speed_limit) {
      check(*lane.speed_limit, 0.0, limits.max_speed, name + "speed_limit", kMaxSpeed);
    }
  }
  checkAreas(map.drivable_area, limits, points, where + ": drivable_area");
  checkAreas(map.walkways, limits, points, where + ": walkways");
  for (std::size_t i = 0; i < map.features.size(); ++i) {
    checkRing(map.features[i].points, limits, points, element(where + ": features", i));
  }
  checkCount(points, limits.max_map_points, where + ": points of the map", "max_map_points");
}

void keepWithin(std::vector<Track>& agents, const InputLimits& limits,
                std::vector<std::string>* warnings) {
  std::map<std::string, std::vector<std::string>> left_out;
  const auto is_unusable = [&](const Track& agent) {
    const char* const problem = problemOf(agent, limits);
    if (problem) left_out[problem].push_back(agent.id);
    return problem != nullptr;
  };
  agents.erase(std::remove_if(agents.begin(), agents.end(), is_unusable), agents.end());
  if (!warnings) return;
  for (const auto& [problem, ids] : left_out) {
    warnings->push_back(std::to_string(ids.size()) + " agents " + problem +
                        " left out (first: " + ids.front() + ")");
  }
}

void checkScene(Scene& scene, const InputLimits& limits, const std::string& where,
                std::vector<std::string>* warnings) {
  if (scene.map) checkMap(*scene.map, limits, where);
  checkIntervals(scene.ego, where + ": " + kEgoId);
  checkTrack(scene.ego, limits, where + ": " + kEgoId);
  for (std::size_t i = 0; i < scene.frame_times.size(); ++i) {
    const std::string frame = element(where + ": frames", i);
    check(scene.frame_times[i], 0.0, limits.max_time, frame + ".time");
    if (i > 0) checkTimes(scene.frame_times[i - 1], scene.frame_times[i], frame);
  }
  checkOneClock(scene, where);
  checkCount(scene.agents.size(), limits.max_agents, where + ": agents", kMaxAgents);
  keepWithin(scene.agents, limits, warnings);
}

void checkSnapshot(Snapshot& snapshot, const InputLimits& limits, const std::string& where) {
  check(snapshot.now, 0.0, limits.max_time, where + ": now");
  checkTrack(snapshot.ego, limits, where + ": " + kEgoId);
  checkCount(snapshot.agents.size(), limits.max_agents, where + ": agents", kMaxAgents);
  keepWithin(snapshot.agents, limits);
}

void checkFuture(Future& future, const InputLimits& limits, const std::string& where) {
  checkFutureTrack(future.ego, limits, where + ": " + kEgoId);
  checkCount(future.agents.size(), limits.max_agents, where + ": agents", kMaxAgents);
  keepWithin(future.agents, limits);
  future.agents.erase(std::remove_if(future.agents.begin(), future.agents.end(),
                                     [](const Track& agent) { return agent.states.empty(); }),
                      future.agents.end());
  checkCount(future.ego_samples.size(), limits.max_agents, where + ": ego_samples", kMaxAgents);
  for (std::size_t i = 0; i < future.ego_samples.size(); ++i) {
    checkFutureTrack(future.ego_samples[i], limits, element(where + ": ego_samples", i));
  }
}

void checkTrajectory(const AttackerTrajectory& trajectory, const InputLimits& limits,
                     const std::string& where) {
  const std::string name = where + ": attacker \"" + trajectory.attacker_id + "\": ";
  check(trajectory.size, limits, name + "size");
  const std::vector<TrajectoryPoint>& points = trajectory.points;
  if (points.empty()) refuse(name, "points is empty");
  checkCount(points.size(), limits.max_points, name + "points");
  checkCount(trajectory.past.size(), limits.max_points, name + "past");
  const double now = points.front().time;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string field = element(name + "points", i);
    check(points[i].time, 0.0, limits.max_time, field + ".time");
    check(points[i].time - now, 0.0, limits.max_trajectory, field + ".time from the first point");
    check(points[i].pose, limits, field);
    check(points[i].speed, -limits.max_speed, limits.max_speed, field + ".speed", kMaxSpeed);
    for (const double value : {points[i].acceleration, points[i].curvature}) {
      if (!std::isfinite(value)) refuse(field, " is not finite");
    }
    if (i > 0) checkTimes(points[i - 1].time, points[i].time, field);
  }
  for (std::size_t i = 0; i < trajectory.past.size(); ++i) {
    const AgentState& state = trajectory.past[i];
    const std::string field = element(name + "past", i);
    check(state, limits, field);
    check(now - state.time, 0.0, limits.max_past, field + ".time before the first point");
    if (i > 0) checkTimes(trajectory.past[i - 1].time, state.time, field);
  }
}

void checkPlan(const std::vector<TrajectoryPoint>& plan, const InputLimits& limits,
               const std::string& where) {
  checkCount(plan.size(), limits.max_points, where + ": points");
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (plan[i].pose.isFinite()) check(plan[i].pose, limits, element(where + ": points", i));
  }
}

void checkPattern(const CollisionPattern& pattern, const InputLimits& limits,
                  const std::string& where) {
  const std::string name = where + ": pattern ";
  check(pattern.time, 0.0, limits.max_time, name + "time");
  check(pattern.ego.center, limits, name + "ego");
  check(pattern.ego.size, limits, name + "ego");
  check(pattern.attacker_offset, limits, name + "attacker_offset");
  check(pattern.attacker_speed, -limits.max_speed, limits.max_speed, name + "attacker_speed",
        kMaxSpeed);
  check(pattern.tolerance, 0.0, limits.max_coordinate, name + "tolerance", kMaxCoordinate);
}

}  // namespace forge
