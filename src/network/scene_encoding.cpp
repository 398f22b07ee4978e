#include "network/scene_encoding.h"

#include <torch/torch.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace forge {
namespace {

constexpr int kAgentFeatures = 8;
constexpr int kLaneFeatures = 6;
constexpr double kTimeEpsilon = 1e-6;  // s

DenseTensor toDense(const torch::Tensor& tensor) {
  const torch::Tensor flat = tensor.to(torch::kFloat32).contiguous();
  DenseTensor dense;
  for (const auto size : flat.sizes()) dense.shape.push_back(static_cast<std::uint32_t>(size));
  dense.data.assign(flat.data_ptr<float>(), flat.data_ptr<float>() + flat.numel());
  return dense;
}

/// Turns the map-frame columns [x, y, cos, sin, ...] of `features` into the frame of `ego`, where
/// `mask` is set; elsewhere everything becomes 0. Columns `vectors` hold further free vectors.
torch::Tensor inFrameOf(const Pose2& ego, torch::Tensor features, const torch::Tensor& mask,
                        const std::vector<int>& vectors) {
  const torch::Tensor origin = torch::tensor({ego.x, ego.y}, torch::kFloat64);
  const double c = std::cos(ego.yaw);
  const double s = std::sin(ego.yaw);
  const torch::Tensor rotation = torch::tensor({c, -s, s, c}, torch::kFloat64).view({2, 2});
  const auto columns = [&](int first) { return features.slice(-1, first, first + 2); };
  columns(0).sub_(origin);
  for (const int first : vectors) {
    columns(first).copy_(torch::matmul(columns(first).clone(), rotation));
  }
  return features * mask.unsqueeze(-1);
}

/// The times of the newest `frames` frames, oldest first.
std::vector<double> frameTimes(const Track& ego, int frames) {
  std::vector<double> times;
  const std::size_t count = std::min(ego.states.size(), static_cast<std::size_t>(frames));
  for (std::size_t i = ego.states.size() - count; i < ego.states.size(); ++i) {
    times.push_back(ego.states[i].time);
  }
  return times;
}

void encodeAgents(const Snapshot& snapshot, int frames, SceneEncoding& encoding) {
  const std::vector<double> times = frameTimes(snapshot.ego, frames);
  const auto rows = static_cast<std::int64_t>(snapshot.agents.size()) + 1;
  torch::Tensor features = torch::zeros({rows, frames, kAgentFeatures}, torch::kFloat64);
  torch::Tensor mask = torch::zeros({rows, frames}, torch::kFloat64);
  auto feature = features.accessor<double, 3>();
  auto seen = mask.accessor<double, 2>();
  const auto fill = [&](std::int64_t row, const Track& track) {
    for (const AgentState& state : track.states) {
      const auto frame = std::lower_bound(times.begin(), times.end(), state.time - kTimeEpsilon);
      if (frame == times.end() || std::abs(*frame - state.time) > kTimeEpsilon) continue;
      const auto column = frames - static_cast<std::int64_t>(std::distance(frame, times.end()));
      const double values[kAgentFeatures] = {state.pose.x,
                                             state.pose.y,
                                             std::cos(state.pose.yaw),
                                             std::sin(state.pose.yaw),
                                             state.velocity.x(),
                                             state.velocity.y(),
                                             track.size.length,
                                             track.size.width};
      for (int i = 0; i < kAgentFeatures; ++i) feature[row][column][i] = values[i];
      seen[row][column] = 1.0;
    }
  };
  fill(0, snapshot.ego);
  for (std::size_t i = 0; i < snapshot.agents.size(); ++i) {
    fill(static_cast<std::int64_t>(i) + 1, snapshot.agents[i]);
  }
  encoding.agent_features =
      toDense(inFrameOf(snapshot.ego.states.back().pose, features, mask, {0, 2, 4}));
  encoding.agent_mask = toDense(mask);
}

void encodeLanes(const Snapshot& snapshot, const LaneIndex& lanes, const EncodingOptions& options,
                 SceneEncoding& encoding) {
  const Pose2& ego = snapshot.ego.states.back().pose;
  std::vector<std::size_t> near = lanes.lanesWithin(ego.position(), options.lane_radius);
  near.resize(std::min(near.size(), static_cast<std::size_t>(options.max_lanes)));
  const auto rows = static_cast<std::int64_t>(near.size());
  torch::Tensor features =
      torch::zeros({rows, options.lane_points, kLaneFeatures}, torch::kFloat64);
  torch::Tensor mask = torch::zeros({rows, options.lane_points}, torch::kFloat64);
  auto feature = features.accessor<double, 3>();
  auto present = mask.accessor<double, 2>();
  for (std::int64_t row = 0; row < rows; ++row) {
    const Lane& lane = lanes.map().lanes[near[static_cast<std::size_t>(row)]];
    const Polyline& line = *lanes.centerline(near[static_cast<std::size_t>(row)]);
    encoding.lane_ids.push_back(lane.id);
    for (int point = 0; point < options.lane_points; ++point) {
      const double arc_length = point * options.lane_point_spacing;
      if (arc_length > line.length()) break;
      const Pose2 pose = line.poseAt(arc_length);
      const double values[kLaneFeatures] = {pose.x,
                                            pose.y,
                                            std::cos(pose.yaw),
                                            std::sin(pose.yaw),
                                            lane.is_connector ? 1.0 : 0.0,
                                            lane.is_intersection ? 1.0 : 0.0};
      for (int i = 0; i < kLaneFeatures; ++i) feature[row][point][i] = values[i];
      present[row][point] = 1.0;
    }
  }
  encoding.lane_features = toDense(inFrameOf(ego, features, mask, {0, 2}));
  encoding.lane_mask = toDense(mask);
}

}  // namespace

SceneEncoding encodeScene(const Snapshot& snapshot, const LaneIndex& lanes, int frames,
                          const EncodingOptions& options) {
  if (!newestAt(snapshot.ego, snapshot.now)) {
    throw std::invalid_argument("the snapshot has no ego at its time");
  }
  const torch::NoGradGuard no_gradients;
  SceneEncoding encoding;
  encodeAgents(snapshot, frames, encoding);
  encodeLanes(snapshot, lanes, options, encoding);
  return encoding;
}

}  // namespace forge
