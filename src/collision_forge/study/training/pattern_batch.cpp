#include "collision_forge/study/training/pattern_batch.h"

#include <cmath>
#include <cstring>

#include "collision_forge/attack/network/pattern_weights.h"
#include "collision_forge/study/training/mirrored_sample.h"

namespace forge {
namespace {

/// Copies `values` to row `row` of a tensor on the CPU.
template <typename Values>
void put(torch::Tensor& tensor, std::int64_t row, const Values& values) {
  const auto count = tensor.numel() / tensor.size(0);
  TORCH_CHECK(count == values.size(), "the samples of a batch have different sizes");
  std::memcpy(tensor.data_ptr<float>() + row * count, values.data(),
              static_cast<std::size_t>(count) * sizeof(float));
}

void putNumbers(torch::Tensor& tensor, std::int64_t row, std::initializer_list<double> values) {
  float* target = tensor.data_ptr<float>() + row * static_cast<std::int64_t>(values.size());
  for (const double value : values) *target++ = static_cast<float>(value);
}

template <typename Value>
Value asDrawn(const TrainingDraw& draw, const Value& value) {
  return draw.is_mirrored ? mirrored(value) : value;
}

void hideHistories(torch::Tensor& agents, torch::Tensor& mask, std::int64_t row) {
  const auto now = agents.size(2) - 1;
  agents[row].slice(0, 1).slice(1, 0, now).zero_();
  mask[row].slice(0, 1).slice(1, 0, now).zero_();
}

void putScene(const TrainingDraw& draw, std::int64_t row, PatternBatch& batch) {
  const SceneFeatures features = asDrawn(draw, draw.sample->features);
  put(batch.agents, row, features.agents);
  put(batch.agent_mask, row, features.agent_mask);
  put(batch.lanes, row, features.lanes);
  put(batch.lane_mask, row, features.lane_mask);
  put(batch.ego, row, features.ego);
  if (draw.hides_history) hideHistories(batch.agents, batch.agent_mask, row);
}

void putTime(const TrainingDraw& draw, const TimedSample& drawn, std::int64_t row,
             const TrainingOptions& options, PatternBatch& batch) {
  const bool impact = draw.sample->attack && &drawn == &draw.sample->times.back();
  const TimedSample time = asDrawn(draw, drawn);
  const auto type = impact ? std::optional<CollisionType>(draw.sample->attack->type) : std::nullopt;
  const auto view = [](torch::Tensor& tensor) { return tensor.flatten(0, 1); };
  torch::Tensor requests = view(batch.requests);
  torch::Tensor groups = view(batch.groups);
  torch::Tensor anchors = view(batch.anchors);
  torch::Tensor prior = view(batch.prior);
  torch::Tensor poses = view(batch.poses);
  torch::Tensor scales = view(batch.scales);
  torch::Tensor truth = view(batch.ego_truth);
  torch::Tensor weight = view(batch.time_weight);
  put(requests, row, requestFeatures(type, time.tta));
  put(groups, row, time.anchors.groups);
  put(anchors, row, time.anchors.anchors);
  put(prior, row, time.anchors.prior);
  put(poses, row, time.anchors.poses);
  putNumbers(scales, row, {time.anchors.along_scale, time.anchors.across_scale});
  putNumbers(truth, row, {time.ego.x, time.ego.y, std::cos(time.ego.yaw), std::sin(time.ego.yaw)});
  putNumbers(weight, row, {impact ? options.clip_weight : 1.0});
}

void putAttacks(const std::vector<TrainingDraw>& draws, PatternBatch& batch) {
  std::vector<std::int64_t> rows;
  std::size_t most = 1;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    if (!draws[i].sample->attack) continue;
    rows.push_back(static_cast<std::int64_t>(i));
    most = std::max(most, draws[i].sample->attack->candidates.size());
  }
  const auto count = static_cast<std::int64_t>(rows.size());
  const auto width = static_cast<std::int64_t>(most);
  batch.attack_rows = torch::tensor(rows, torch::kInt64);
  batch.attacker = torch::zeros({count}, torch::kInt64);
  batch.attack_requests = torch::zeros({count, kRequestFeatures});
  batch.candidates = torch::zeros({count, width, kCandidateFeatures});
  batch.candidate_mask = torch::zeros({count, width});
  batch.attacker_features = torch::zeros({count, 1, kCandidateFeatures});
  batch.offset_truth = torch::zeros({count, 4});
  for (std::int64_t row = 0; row < count; ++row) {
    const TrainingDraw& draw = draws[static_cast<std::size_t>(rows[static_cast<std::size_t>(row)])];
    const AttackSample attack = asDrawn(draw, *draw.sample->attack);
    const Pose2 expected_ego = asDrawn(draw, draw.expected_ego);
    const double speed = draw.sample->ego_speed;
    torch::Tensor of_row = batch.candidates[row];
    for (std::size_t i = 0; i < attack.candidates.size(); ++i) {
      put(of_row, static_cast<std::int64_t>(i),
          candidateFeatures(attack.candidates[i], speed, expected_ego, attack.tta, attack.type));
      batch.candidate_mask[row][static_cast<std::int64_t>(i)] = 1.0;
    }
    batch.attacker[row] = static_cast<std::int64_t>(attack.attacker);
    put(batch.attack_requests, row, requestFeatures(attack.type, attack.tta));
    put(batch.attacker_features, row,
        candidateFeatures(attack.candidates[attack.attacker], speed, attack.ego, attack.tta,
                          attack.type));
    putNumbers(batch.offset_truth, row,
               {attack.offset.x / kOffsetScale, attack.offset.y / kOffsetScale,
                std::cos(attack.offset.yaw), std::sin(attack.offset.yaw)});
  }
}

}  // namespace

PatternBatch batchOf(const std::vector<TrainingDraw>& draws, const PatternFeatureOptions& features,
                     const TrainingOptions& options) {
  const auto count = static_cast<std::int64_t>(draws.size());
  const auto times = static_cast<std::int64_t>(draws.front().times.size());
  const AnchorFeatures& anchors = draws.front().times.front()->anchors;
  const std::int64_t groups = anchors.groups.rows();
  const std::int64_t size = anchors.group_size;
  const std::int64_t agents = 1 + features.max_agents;
  PatternBatch batch;
  batch.agents = torch::empty({count, agents, features.history_frames, kAgentVector});
  batch.agent_mask = torch::empty({count, agents, features.history_frames});
  batch.lanes = torch::empty(
      {count, features.encoding.max_lanes, features.encoding.lane_points, kLaneVector});
  batch.lane_mask =
      torch::empty({count, features.encoding.max_lanes, features.encoding.lane_points});
  batch.ego = torch::empty({count, kEgoFeatures});
  batch.requests = torch::empty({count, times, kRequestFeatures});
  batch.groups = torch::empty({count, times, groups, kGroupFeatures});
  batch.anchors = torch::empty({count, times, groups, size, kAnchorFeatures});
  batch.prior = torch::empty({count, times, groups * size});
  batch.poses = torch::empty({count, times, groups * size, 4});
  batch.scales = torch::empty({count, times, 2});
  batch.ego_truth = torch::empty({count, times, 4});
  batch.time_weight = torch::empty({count, times});
  for (std::int64_t row = 0; row < count; ++row) {
    const TrainingDraw& draw = draws[static_cast<std::size_t>(row)];
    putScene(draw, row, batch);
    for (std::int64_t time = 0; time < times; ++time) {
      putTime(draw, *draw.times[static_cast<std::size_t>(time)], row * times + time, options,
              batch);
    }
  }
  putAttacks(draws, batch);
  return batch;
}

PatternBatch movedTo(const PatternBatch& batch, const torch::Device& device, torch::Dtype type) {
  PatternBatch moved = batch;
  for (torch::Tensor* tensor : {&moved.agents,
                                &moved.agent_mask,
                                &moved.lanes,
                                &moved.lane_mask,
                                &moved.ego,
                                &moved.requests,
                                &moved.groups,
                                &moved.anchors,
                                &moved.prior,
                                &moved.poses,
                                &moved.scales,
                                &moved.ego_truth,
                                &moved.time_weight,
                                &moved.attack_requests,
                                &moved.attack_rows,
                                &moved.candidates,
                                &moved.candidate_mask,
                                &moved.attacker,
                                &moved.attacker_features,
                                &moved.offset_truth}) {
    *tensor = tensor->is_floating_point() ? tensor->to(device, type) : tensor->to(device);
  }
  return moved;
}

}  // namespace forge
