#include "collision_forge/study/training/pattern_module.h"

#include <cmath>

namespace forge {
namespace {

torch::Tensor logLogistic(const torch::Tensor& offset, const torch::Tensor& log_scale) {
  const torch::Tensor z = (offset / log_scale.exp()).abs();
  return -z - 2.0 * torch::log1p(torch::exp(-z)) - log_scale;
}

torch::Tensor zeroOf(const torch::Tensor& like) { return torch::zeros({}, like.options()); }

/// Computes the negative log density of the mixture at the true position, and the heading error
/// weighted by the components' posterior there.
void egoLosses(const torch::Tensor& out, const PatternBatch& batch, BatchLosses& losses) {
  const torch::Tensor along_scale = batch.scales.select(-1, 0).unsqueeze(-1);
  const torch::Tensor across_scale = batch.scales.select(-1, 1).unsqueeze(-1);
  const torch::Tensor c = batch.poses.select(-1, 2);
  const torch::Tensor s = batch.poses.select(-1, 3);
  const torch::Tensor turn = out.select(-1, 5);
  const torch::Tensor cos_turn = turn.cos();
  const torch::Tensor sin_turn = turn.sin();
  // The true position in the frame of the anchor, then in the frame of the component's mean pose.
  const torch::Tensor dx = batch.ego_truth.select(-1, 0).unsqueeze(-1) - batch.poses.select(-1, 0);
  const torch::Tensor dy = batch.ego_truth.select(-1, 1).unsqueeze(-1) - batch.poses.select(-1, 1);
  const torch::Tensor ahead = c * dx + s * dy - along_scale * out.select(-1, 1);
  const torch::Tensor left = c * dy - s * dx - across_scale * out.select(-1, 2);
  const torch::Tensor along = cos_turn * ahead + sin_turn * left;
  const torch::Tensor across = cos_turn * left - sin_turn * ahead;
  const torch::Tensor log_along =
      out.select(-1, 3).clamp(-kMaxLogSpread, kMaxLogSpread) + along_scale.log();
  const torch::Tensor log_across =
      out.select(-1, 4).clamp(-kMaxLogSpread, kMaxLogSpread) + across_scale.log();
  const torch::Tensor joint = torch::log_softmax(out.select(-1, 0), -1) +
                              logLogistic(along, log_along) + logLogistic(across, log_across);
  const torch::Tensor weights = batch.time_weight / batch.time_weight.sum();
  losses.ego = -(weights * torch::logsumexp(joint, -1)).sum();
  const torch::Tensor true_cos = batch.ego_truth.select(-1, 2).unsqueeze(-1);
  const torch::Tensor true_sin = batch.ego_truth.select(-1, 3).unsqueeze(-1);
  const torch::Tensor cos_error =
      (c * cos_turn - s * sin_turn) * true_cos + (s * cos_turn + c * sin_turn) * true_sin;
  const torch::Tensor near = torch::softmax(joint, -1).detach();
  losses.heading = (weights * (near * (1.0 - cos_error)).sum(-1)).sum();
}

/// Computes the losses of selection and offset. They train only the candidate layers (detach()),
/// because the scene encoding is for the ego position.
void attackLosses(PatternModule& module, const torch::Tensor& scene, const PatternBatch& batch,
                  BatchLosses& losses) {
  const torch::Tensor with_request =
      module->withRequest(scene.index_select(0, batch.attack_rows), batch.attack_requests).detach();
  const torch::Tensor scores = module->candidates(with_request, batch.candidates).select(-1, 0) +
                               (1.0 - batch.candidate_mask) * kAbsent;
  losses.selection = torch::nll_loss(torch::log_softmax(scores, -1), batch.attacker);
  const torch::Tensor offset =
      module->candidates(with_request, batch.attacker_features).squeeze(1).slice(-1, 1);
  losses.offset = torch::smooth_l1_loss(offset, batch.offset_truth);
}

}  // namespace

PatternModuleImpl::PatternModuleImpl(const PatternNetworkOptions& options, double dropout,
                                     double context_dropout)
    : options_(options),
      context_dropout_(context_dropout),
      dropout_(torch::nn::DropoutOptions(dropout)) {
  for (const auto& [name, shape] : layerShapes(options)) {
    layers_.emplace(name, register_module(name, torch::nn::Linear(shape.inputs, shape.outputs)));
  }
  register_module("dropout", dropout_);
}

torch::Tensor PatternModuleImpl::polylines(const torch::Tensor& vectors, const torch::Tensor& mask,
                                           const std::string& name) {
  const torch::Tensor present = mask.unsqueeze(-1);
  const torch::Tensor inner = torch::relu(layer(name + "_first")->forward(vectors)) * present;
  const torch::Tensor largest = std::get<0>(inner.max(-2, true));
  const auto second = layer(name + "_second");
  const int hidden = options_.hidden;
  const torch::Tensor outer =
      torch::matmul(inner, second->weight.slice(1, 0, hidden).t()) +
      (torch::matmul(largest, second->weight.slice(1, hidden).t()) + second->bias);
  return std::get<0>((torch::relu(outer) * present).max(-2));
}

torch::Tensor PatternModuleImpl::encode(const PatternBatch& batch) {
  const torch::Tensor agents = polylines(batch.agents, batch.agent_mask, "agent");
  const torch::Tensor lanes = polylines(batch.lanes, batch.lane_mask, "lane");
  const torch::Tensor tokens = torch::cat({agents, lanes}, 1);
  const torch::Tensor present =
      torch::cat({std::get<0>(batch.agent_mask.max(-1)), std::get<0>(batch.lane_mask.max(-1))}, 1);
  const torch::Tensor ego = tokens.slice(1, 0, 1);
  const torch::Tensor query = layer("query")->forward(ego);
  const torch::Tensor scores =
      torch::matmul(layer("key")->forward(tokens), query.transpose(1, 2)).squeeze(-1) /
          std::sqrt(static_cast<double>(options_.hidden)) +
      (1.0 - present) * kAbsent;
  const torch::Tensor attention = torch::softmax(scores, -1).unsqueeze(1);
  const torch::Tensor mixed = torch::matmul(attention, layer("value")->forward(tokens)).squeeze(1);
  torch::Tensor context = dropout_->forward(mixed);
  if (is_training() && context_dropout_ > 0.0) {
    context = context * torch::bernoulli(torch::full({context.size(0), 1}, 1.0 - context_dropout_,
                                                     context.options()));
  }
  const torch::Tensor input =
      torch::cat({dropout_->forward(ego.squeeze(1)), context, batch.ego}, -1);
  return dropout_->forward(torch::relu(layer("scene")->forward(input)));
}

torch::Tensor PatternModuleImpl::withRequest(const torch::Tensor& scene,
                                             const torch::Tensor& requests) {
  return dropout_->forward(
      torch::relu(layer("request")->forward(torch::cat({scene, requests}, -1))));
}

torch::Tensor PatternModuleImpl::ego(const torch::Tensor& with_request, const PatternBatch& batch) {
  const auto group = layer("group");
  const auto first = layer("anchor_first");
  const int scene = options_.scene;
  const auto group_count = batch.groups.size(2);
  const auto group_size = batch.anchors.size(3);
  const torch::Tensor prior = batch.prior.view({-1, group_size});
  // Skips groups without an anchor, which are frequent.
  const torch::Tensor rows = (std::get<0>(prior.max(-1)) > kAbsent).nonzero().squeeze(-1);
  const torch::Tensor requests =
      (torch::matmul(with_request, group->weight.slice(1, 0, scene).t()) + group->bias)
          .flatten(0, 1)
          .index_select(0, rows.div(group_count, "floor"));
  const torch::Tensor groups =
      dropout_->forward(torch::relu(torch::matmul(batch.groups.flatten(0, 2).index_select(0, rows),
                                                  group->weight.slice(1, scene).t()) +
                                    requests));
  const torch::Tensor of_groups =
      torch::matmul(groups, first->weight.slice(1, 0, scene).t()) + first->bias;
  const torch::Tensor hidden =
      torch::relu(torch::matmul(batch.anchors.flatten(0, 2).index_select(0, rows),
                                first->weight.slice(1, scene).t()) +
                  of_groups.unsqueeze(1));
  const torch::Tensor second = torch::relu(layer("anchor_second")->forward(hidden));
  const torch::Tensor present = layer("anchor_last")->forward(second);
  const torch::Tensor out =
      torch::zeros({prior.size(0), group_size, present.size(2)}, present.options())
          .index_copy(0, rows, present)
          .view({batch.prior.size(0), batch.prior.size(1), batch.prior.size(2), -1});
  return torch::cat({(out.select(-1, 0) + batch.prior).unsqueeze(-1), out.slice(-1, 1)}, -1);
}

torch::Tensor PatternModuleImpl::candidates(const torch::Tensor& with_request,
                                            const torch::Tensor& features) {
  const auto first = layer("candidate_first");
  const int scene = options_.scene;
  const torch::Tensor hidden =
      torch::relu(torch::matmul(features, first->weight.slice(1, scene).t()) +
                  (torch::matmul(with_request, first->weight.slice(1, 0, scene).t()) + first->bias)
                      .unsqueeze(1));
  return layer("candidate_last")
      ->forward(torch::relu(layer("candidate_second")->forward(dropout_->forward(hidden))));
}

BatchLosses lossesOf(PatternModule& module, const PatternBatch& batch) {
  const torch::Tensor scene = module->encode(batch);
  const torch::Tensor times = batch.requests;
  const torch::Tensor with_request = module->withRequest(
      scene.unsqueeze(1).expand({scene.size(0), times.size(1), scene.size(1)}), times);
  BatchLosses losses;
  losses.selection = losses.offset = zeroOf(scene);
  egoLosses(module->ego(with_request, batch), batch, losses);
  if (batch.attack_rows.size(0) > 0) attackLosses(module, scene, batch, losses);
  return losses;
}

}  // namespace forge
