#include "collision_forge/planner_test/planners/planner_inputs.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "collision_forge/planner_test/planners/planner_contract.h"

namespace forge {
namespace {

constexpr double kTimeSlack = 1e-3;  // s that a frame may lie outside the known states

const DrivingTask& checked(const DrivingTask& task) {
  if (!task.lanes) throw std::invalid_argument("the driving task has no lanes");
  return task;
}

/// Returns the time of a frame, s; the last frame is the current one.
double timeOfFrame(double now, std::size_t frame) {
  return now - static_cast<double>(kContractFrames - 1 - frame) * kContractFrameStep;
}

/// Returns `time`, clamped to the known interval if it is within kTimeSlack of its ends.
double within(double time, double first, double last) {
  const double clamped = std::clamp(time, first, last);
  return std::abs(clamped - time) <= kTimeSlack ? clamped : time;
}

void write(float* numbers, std::initializer_list<double> values) {
  for (const double value : values) *numbers++ = static_cast<float>(value);
}

/// Interpolates linearly between the points; empty before the first.
std::optional<TrajectoryPoint> pastPointAt(const std::vector<TrajectoryPoint>& history,
                                           double time) {
  time = within(time, history.front().time, history.back().time);
  if (time < history.front().time) return std::nullopt;
  const auto after = std::find_if(history.begin(), history.end(),
                                  [&](const TrajectoryPoint& point) { return point.time >= time; });
  if (after->time == time) return *after;
  const TrajectoryPoint& before = *std::prev(after);
  const double ratio = (time - before.time) / (after->time - before.time);
  TrajectoryPoint point = before;
  point.pose = interpolate(before.pose, after->pose, ratio);
  point.speed += ratio * (after->speed - before.speed);
  point.acceleration += ratio * (after->acceleration - before.acceleration);
  return point;
}

void writeEgo(const std::vector<TrajectoryPoint>& history, float* numbers) {
  const TrajectoryPoint& now = history.back();
  for (std::size_t frame = 0; frame < kContractFrames; ++frame, numbers += kContractEgoNumbers) {
    const auto point = pastPointAt(history, timeOfFrame(now.time, frame));
    if (!point) continue;
    const Pose2 local = relativeTo(now.pose, point->pose);
    write(numbers, {local.x, local.y, local.yaw, point->speed, point->acceleration, 1.0});
  }
}

/// Returns 0 for a vehicle, 1 for a two-wheeler, 2 for a person on foot or an animal, 3 for a
/// static object.
double kindOf(AgentClass agent_class) {
  switch (agent_class) {
    case AgentClass::kMotorcycle:
    case AgentClass::kBicycle:
    case AgentClass::kScooter:
      return 1.0;
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
    case AgentClass::kAnimal:
      return 2.0;
    case AgentClass::kStaticObject:
      return 3.0;
    default:
      return 0.0;
  }
}

void writeAgents(const std::vector<Track>& agents, const TrajectoryPoint& ego, float* numbers,
                 float* mask) {
  const std::vector<const Track*> nearest = nearestAgents(agents, ego.pose);
  const Eigen::Rotation2Dd turned(-ego.pose.yaw);
  for (std::size_t i = 0; i < std::min(nearest.size(), kContractAgents); ++i) {
    const Track& agent = *nearest[i];
    for (std::size_t frame = 0; frame < kContractFrames; ++frame) {
      const double time =
          within(timeOfFrame(ego.time, frame), agent.states.front().time, agent.states.back().time);
      const auto state = stateAt(agent, time);
      if (!state) continue;
      const Pose2 local = relativeTo(ego.pose, state->pose);
      const Vector2 velocity = turned * state->velocity;
      const std::size_t row = i * kContractFrames + frame;
      write(numbers + row * kContractAgentNumbers,
            {local.x, local.y, local.yaw, velocity.x(), velocity.y(), agent.size.length,
             agent.size.width, kindOf(agent.agent_class)});
      mask[row] = 1.0f;
    }
  }
}

/// Returns the part of each lane around its point nearest to the ego.
void writeLanes(const LaneIndex& lanes, const Pose2& ego, float* numbers, float* mask) {
  const std::vector<std::size_t> near = lanes.lanesWithin(ego.position(), kContractLaneRadius);
  for (std::size_t i = 0; i < std::min(near.size(), kContractLanes); ++i) {
    const Polyline& line = *lanes.centerline(near[i]);
    const double behind = 0.5 * static_cast<double>(kContractLanePoints) * kContractLaneSpacing;
    const double start = std::max(line.project(ego.position()).arc_length - behind, 0.0);
    for (std::size_t point = 0; point < kContractLanePoints; ++point) {
      const double along = start + static_cast<double>(point) * kContractLaneSpacing;
      if (along > line.length()) break;
      const Pose2 local = relativeTo(ego, line.poseAt(along));
      const std::size_t row = i * kContractLanePoints + point;
      write(numbers + row * kContractLaneNumbers,
            {local.x, local.y, local.yaw, lanes.map().lanes[near[i]].is_intersection ? 1.0 : 0.0});
      mask[row] = 1.0f;
    }
  }
}

}  // namespace

std::vector<const Track*> nearestAgents(const std::vector<Track>& agents, const Pose2& ego) {
  std::vector<std::pair<double, const Track*>> found;
  for (const Track& agent : agents) {
    if (agent.states.empty()) continue;
    const Vector2 away = agent.states.back().pose.position() - ego.position();
    found.emplace_back(away.norm(), &agent);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const Track*> nearest;
  for (const auto& [distance, agent] : found) nearest.push_back(agent);
  return nearest;
}

std::vector<float> sharedInputs(const LaneIndex& lanes,
                                const std::vector<TrajectoryPoint>& ego_history,
                                const std::vector<Track>& agents) {
  const TrajectoryPoint& ego = ego_history.back();
  std::vector<float> numbers(contractStart(kRoute), 0.0f);
  const auto input = [&](ContractInput which) { return numbers.data() + contractStart(which); };
  writeEgo(ego_history, input(kEgoHistory));
  writeAgents(agents, ego, input(kAgents), input(kAgentsMask));
  writeLanes(lanes, ego.pose, input(kLanes), input(kLanesMask));
  return numbers;
}

PlannerInputs::PlannerInputs(const DrivingTask& task, const RouteCenterlineOptions& options)
    : lanes_(checked(task).lanes), way_(routeCenterline(*task.lanes, task.route, options)) {}

std::vector<float> PlannerInputs::at(const std::vector<TrajectoryPoint>& ego_history,
                                     const std::vector<Track>& agents) const {
  std::vector<float> numbers = sharedInputs(*lanes_, ego_history, agents);
  numbers.resize(kContractNumbers, 0.0f);
  writeRoute(ego_history.back().pose, numbers.data() + contractStart(kRoute));
  return numbers;
}

void PlannerInputs::writeRoute(const Pose2& ego, float* route) const {
  const double start = way_.project(ego.position());
  for (std::size_t i = 0; i < kContractRoutePoints; ++i, route += kContractPoseNumbers) {
    const double along = start + static_cast<double>(i) * kContractRouteSpacing;
    const Pose2 local = relativeTo(ego, way_.at(along).pose);
    write(route, {local.x, local.y, local.yaw});
  }
}

}  // namespace forge
