#include "collision_forge/attack/network/scene_encoding.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

constexpr std::size_t kAgentFeatures = 8;
constexpr std::size_t kLaneFeatures = 6;

DenseTensor zeros(std::vector<std::size_t> shape) {
  DenseTensor tensor;
  std::size_t size = 1;
  for (const std::size_t extent : shape) {
    tensor.shape.push_back(static_cast<std::uint32_t>(extent));
    size *= extent;
  }
  tensor.data.assign(size, 0.0F);
  return tensor;
}

/// Returns the times of the newest `frames` frames, oldest first.
std::vector<double> frameTimes(const Track& ego, int frames) {
  std::vector<double> times;
  const std::size_t count = std::min(ego.states.size(), static_cast<std::size_t>(frames));
  for (std::size_t i = ego.states.size() - count; i < ego.states.size(); ++i) {
    times.push_back(ego.states[i].time);
  }
  return times;
}

/// Rotates a vector from the map frame into the frame of `ego`.
Vector2 turnedInto(const Pose2& ego, const Vector2& vector) {
  const double c = std::cos(ego.yaw);
  const double s = std::sin(ego.yaw);
  return {c * vector.x() + s * vector.y(), c * vector.y() - s * vector.x()};
}

void encodeAgents(const Snapshot& snapshot, int frames, SceneEncoding& encoding) {
  const auto columns = static_cast<std::size_t>(frames);
  const std::vector<double> times = frameTimes(snapshot.ego, frames);
  const Pose2& ego = snapshot.ego.states.back().pose;
  encoding.agent_features = zeros({snapshot.agents.size() + 1, columns, kAgentFeatures});
  encoding.agent_mask = zeros({snapshot.agents.size() + 1, columns});
  const auto fill = [&](std::size_t row, const Track& track) {
    for (const AgentState& state : track.states) {
      const auto frame = std::lower_bound(times.begin(), times.end(), state.time - kTimeEpsilon);
      if (frame == times.end() || std::abs(*frame - state.time) > kTimeEpsilon) continue;
      const auto from_end = static_cast<std::size_t>(std::distance(frame, times.end()));
      const std::size_t cell = row * columns + columns - from_end;
      const Pose2 pose = relativeTo(ego, state.pose);
      const Vector2 velocity = turnedInto(ego, state.velocity);
      const double values[kAgentFeatures] = {
          pose.x,       pose.y,       std::cos(pose.yaw), std::sin(pose.yaw),
          velocity.x(), velocity.y(), track.size.length,  track.size.width};
      std::transform(
          values, values + kAgentFeatures,
          encoding.agent_features.data.begin() + static_cast<std::ptrdiff_t>(cell * kAgentFeatures),
          [](double value) { return static_cast<float>(value); });
      encoding.agent_mask.data[cell] = 1.0F;
    }
  };
  fill(0, snapshot.ego);
  for (std::size_t i = 0; i < snapshot.agents.size(); ++i) fill(i + 1, snapshot.agents[i]);
}

void encodeLanes(const Snapshot& snapshot, const LaneIndex& lanes, const EncodingOptions& options,
                 SceneEncoding& encoding) {
  const Pose2& ego = snapshot.ego.states.back().pose;
  std::vector<std::size_t> near = lanes.lanesWithin(ego.position(), options.lane_radius);
  near.resize(std::min(near.size(), static_cast<std::size_t>(options.max_lanes)));
  const auto points = static_cast<std::size_t>(options.lane_points);
  encoding.lane_features = zeros({near.size(), points, kLaneFeatures});
  encoding.lane_mask = zeros({near.size(), points});
  for (std::size_t row = 0; row < near.size(); ++row) {
    const Lane& lane = lanes.map().lanes[near[row]];
    const Polyline& line = *lanes.centerline(near[row]);
    encoding.lane_ids.push_back(lane.id);
    encoding.lanes.push_back(near[row]);
    for (std::size_t point = 0; point < points; ++point) {
      const double arc_length = static_cast<double>(point) * options.lane_point_spacing;
      if (arc_length > line.length()) break;
      const Pose2 pose = relativeTo(ego, line.poseAt(arc_length));
      const double values[kLaneFeatures] = {pose.x,
                                            pose.y,
                                            std::cos(pose.yaw),
                                            std::sin(pose.yaw),
                                            lane.is_connector ? 1.0 : 0.0,
                                            lane.is_intersection ? 1.0 : 0.0};
      const std::size_t cell = row * points + point;
      std::transform(
          values, values + kLaneFeatures,
          encoding.lane_features.data.begin() + static_cast<std::ptrdiff_t>(cell * kLaneFeatures),
          [](double value) { return static_cast<float>(value); });
      encoding.lane_mask.data[cell] = 1.0F;
    }
  }
}

}  // namespace

SceneEncoding encodeScene(const Snapshot& snapshot, const LaneIndex& lanes, int frames,
                          const EncodingOptions& options) {
  if (!newestAt(snapshot.ego, snapshot.now)) {
    throw std::invalid_argument("the snapshot has no ego state at its time");
  }
  SceneEncoding encoding;
  encodeAgents(snapshot, frames, encoding);
  encodeLanes(snapshot, lanes, options, encoding);
  return encoding;
}

}  // namespace forge
