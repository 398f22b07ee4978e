#include "collision_forge/study/generators/published_patterns.h"

#include <algorithm>
#include <cmath>

namespace forge {

using torch::Tensor;
using torch::indexing::None;
using torch::indexing::Slice;
namespace nn = torch::nn;

namespace {

constexpr int kVectorNumbers = 7;  // of vectorsOf()

/// Returns a linear layer with Kaiming initialisation, as in the released code.
nn::Linear linear(long from, long to) {
  nn::Linear layer(from, to);
  nn::init::kaiming_normal_(layer->weight);
  return layer;
}

nn::LayerNorm norm(long width) { return nn::LayerNorm(nn::LayerNormOptions({width})); }

/// Applies a layer to the concatenation [own, shared]. `shared` has a dimension of size 1, along
/// which its part is computed only once.
Tensor onBoth(nn::Linear& layer, const Tensor& own, const Tensor& shared) {
  const long width = own.size(-1);
  return nn::functional::linear(own, layer->weight.slice(1, 0, width), layer->bias) +
         nn::functional::linear(shared, layer->weight.slice(1, width));
}

}  // namespace

/// A residual block of two layers.
struct PublishedBlock : nn::Module {
  PublishedBlock(long from, long to) {
    layer_1 = register_module("layer_1", linear(from, to));
    norm_1 = register_module("norm_1", norm(to));
    layer_2 = register_module("layer_2", linear(to, to));
    norm_2 = register_module("norm_2", norm(to));
    if (from == to) return;
    shortcut = register_module("shortcut", linear(from, to));
    shortcut_norm = register_module("shortcut_norm", norm(to));
  }

  Tensor forward(const Tensor& input) {
    return finished(layer_1(input), shortcut ? shortcut_norm(shortcut(input)) : input);
  }
  /// Applies the block to [own, shared]; see onBoth().
  Tensor forward(const Tensor& own, const Tensor& shared) {
    return finished(onBoth(layer_1, own, shared), shortcut_norm(onBoth(shortcut, own, shared)));
  }

  Tensor finished(const Tensor& first, const Tensor& around) {
    return torch::relu(norm_2(layer_2(torch::relu(norm_1(first)))) + around);
  }

  nn::Linear layer_1{nullptr}, layer_2{nullptr}, shortcut{nullptr};
  nn::LayerNorm norm_1{nullptr}, norm_2{nullptr}, shortcut_norm{nullptr};
};

/// VectorNet's polyline subgraph: three blocks, each joined with the maximum over all vectors.
struct PublishedSubGraph : nn::Module {
  explicit PublishedSubGraph(long width) {
    block_1 = register_module("block_1", std::make_shared<PublishedBlock>(kVectorNumbers, width));
    block_2 = register_module("block_2", std::make_shared<PublishedBlock>(2 * width, width));
    block_3 = register_module("block_3", std::make_shared<PublishedBlock>(2 * width, width));
    output = register_module("output", linear(2 * width, width));
  }

  /// Maps vectors [N, V, kVectorNumbers] to polyline features [N, width] of norm 1.
  Tensor forward(const Tensor& vectors) {
    const Tensor first = block_1->forward(vectors);
    const Tensor second = block_2->forward(first, first.amax(1, true));
    const Tensor third = block_3->forward(second, second.amax(1, true));
    const Tensor most = onBoth(output, third, third.amax(1, true)).amax(1);
    return nn::functional::normalize(most, nn::functional::NormalizeFuncOptions().dim(1));
  }

  std::shared_ptr<PublishedBlock> block_1, block_2, block_3;
  nn::Linear output{nullptr};
};

PublishedPieces piecesOf(const TrafficBatch& batch, double reach) {
  const Tensor far = batch.lanes.slice(3, 0, 2).norm(2, 3);
  const Tensor near = ((far <= reach) * (batch.lane_seen > 0)).any(2);
  const Tensor which = near.nonzero();
  const Tensor clip = which.select(1, 0), piece = which.select(1, 1);
  return {batch.lanes.index({clip, piece}), batch.lane_seen.index({clip, piece}), clip,
          near.cumsum(1).index({clip, piece})};
}

Tensor PublishedAnchors::inRows(const Tensor& numbers, long clips, double none) const {
  std::vector<std::int64_t> shape = numbers.sizes().vec();
  shape.front() = most;
  shape.insert(shape.begin(), clips);
  return torch::full(shape, none, numbers.options()).index_put({clip, column}, numbers);
}

PublishedAnchors anchorsOf(const PublishedPieces& pieces, long clips) {
  const Tensor which = pieces.seen.slice(1, 0, -1).nonzero();
  const Tensor piece = which.select(1, 0), point = which.select(1, 1);
  const Tensor clip = pieces.clip.index({piece});
  const Tensor counts = torch::bincount(clip, {}, clips);
  const Tensor firsts = counts.cumsum(0) - counts;
  const Tensor place = pieces.points.index({piece, point, Slice(None, 2)});
  const Tensor column = torch::arange(clip.size(0), clip.options()) - firsts.index({clip});
  return {place, clip, piece, point, column, std::max(1L, counts.max().item<long>())};
}

PublishedPatterns::PublishedPatterns(const PublishedNetworkOptions& options,
                                     const TrafficOptions& traffic)
    : options(options), traffic(traffic) {
  const long width = options.width;
  subgraph = register_module("subgraph", std::make_shared<PublishedSubGraph>(width));
  query = register_module("query", linear(width + 2, width));
  key = register_module("key", linear(width + 2, width));
  value = register_module("value", linear(width + 2, width));
  type_1 = register_module(
      "type_1", nn::Linear(nn::LinearOptions(kConditionTypes, kConditionTypes).bias(false)));
  type_2 = register_module("type_2", linear(kConditionTypes, options.condition));
  time = register_module("time", linear(1, options.condition));
  join_1 = register_module("join_1", linear(width + 2 * options.condition, width));
  join_2 = register_module("join_2", linear(width, width));
  dropout = register_module("dropout", nn::Dropout(options.dropout));
  ego_yaw_1 = register_module("ego_yaw_1", std::make_shared<PublishedBlock>(width, width));
  ego_yaw_2 = register_module("ego_yaw_2", linear(width, 1));
  offset = register_module("offset", linear(width, 2));
  attacker_yaw = register_module("attacker_yaw", linear(width, 1));
  selector_1 = register_module("selector_1", linear(2, options.selector));
  selector_2 = register_module("selector_2",
                               std::make_shared<PublishedBlock>(width + options.selector, width));
  selector_3 = register_module("selector_3", linear(width, 1));
  addAnchorLayers();
}

void PublishedPatterns::addAnchorLayers() {
  const long width = options.width;
  anchor_1 = register_module("anchor_1", linear(2, options.anchor_1));
  anchor_2 = register_module("anchor_2", linear(options.anchor_1, options.anchor_2));
  anchor_3 = register_module("anchor_3", linear(options.anchor_2, options.anchor_3));
  anchor_norm_1 = register_module("anchor_norm_1", norm(options.anchor_1));
  anchor_norm_2 = register_module("anchor_norm_2", norm(options.anchor_2));
  anchor_norm_3 = register_module("anchor_norm_3", norm(options.anchor_3));
  anchor_4 = register_module("anchor_4", std::make_shared<PublishedBlock>(options.anchor_3, width));
  anchor_5 = register_module("anchor_5", linear(width, width));
  scene = register_module("scene", linear(width, width));
  score_1 = register_module("score_1", std::make_shared<PublishedBlock>(3 * width, width));
  score_2 = register_module("score_2", linear(width, 1));
  shift_1 = register_module("shift_1", std::make_shared<PublishedBlock>(width + 2, width));
  shift_2 = register_module("shift_2", linear(width, 2));
}

Tensor PublishedPatterns::vectorsOf(const Tensor& at, const Tensor& steps, const Tensor& yaw,
                                    const Tensor& frame, const Tensor& intersection) const {
  return torch::cat({at / traffic.lanes.reach, steps / traffic.lanes.spacing, yaw.unsqueeze(2),
                     frame.unsqueeze(2), intersection.unsqueeze(2)},
                    2);
}

Tensor PublishedPatterns::polylinesOf(const Tensor& vectors) {
  return torch::cat({subgraph->forward(vectors), vectors.slice(2, 0, 2).amin(1)}, 1);
}

Tensor PublishedPatterns::egoPolylines(const TrafficBatch& batch) {
  const Tensor ego =
      batch.poses.select(1, static_cast<long>(kEgoAgent)).slice(1, 0, traffic.history_frames);
  const Tensor places = ego.slice(2, 0, 2);
  const Tensor yaw = ego.select(2, 2).slice(1, 1);
  const Tensor frame =
      torch::arange(1, traffic.history_frames, places.options()) / (traffic.history_frames - 1);
  const Tensor vectors = vectorsOf(places.slice(1, 1), places.diff(1, 1), yaw, frame.expand_as(yaw),
                                   torch::zeros_like(yaw));
  return polylinesOf(vectors);
}

Tensor PublishedPatterns::lanePolylines(const PublishedPieces& pieces) {
  const Tensor places = pieces.points.slice(2, 0, 2);
  const Tensor centers = 0.5 * (places.slice(1, 0, -1) + places.slice(1, 1));
  const Tensor none = torch::zeros_like(centers.select(2, 0));
  const Tensor vectors =
      vectorsOf(centers, places.diff(1, 1), none, none, pieces.points.select(2, 4).slice(1, 1));
  // Pads shorter pieces with copies of the first vector, which do not change the maximum.
  const Tensor seen = pieces.seen.slice(1, 1).unsqueeze(2) > 0;
  return polylinesOf(torch::where(seen, vectors, vectors.slice(1, 0, 1)));
}

Tensor PublishedPatterns::graphOf(const TrafficBatch& batch, const PublishedPieces& pieces) {
  const Tensor egos = egoPolylines(batch);
  const Tensor lanes = lanePolylines(pieces);
  const long clips = egos.size(0);
  const long most = pieces.polyline.numel() ? pieces.polyline.max().item<long>() : 0;
  const Tensor clip = torch::cat({torch::arange(clips, pieces.clip.options()), pieces.clip});
  const Tensor row = torch::cat({torch::zeros({clips}, pieces.clip.options()), pieces.polyline});
  const Tensor all = torch::zeros({clips, 1 + most, egos.size(1)}, egos.options())
                         .index_put({clip, row}, torch::cat({egos, lanes}));
  const Tensor there = torch::zeros({clips, 1 + most}, egos.options())
                           .index_put({clip, row}, torch::ones({row.size(0)}, egos.options()));
  const double scale = std::sqrt(static_cast<double>(options.width));
  const Tensor alike = torch::matmul(query(all), key(all).transpose(1, 2)) / scale;
  const Tensor weights = alike.masked_fill(there.unsqueeze(1) == 0, kAbsentLogit).softmax(2);
  return torch::matmul(weights, value(all));
}

Tensor PublishedPatterns::joined(const Tensor& ego, const Tensor& condition) {
  const Tensor type =
      torch::relu(type_2(torch::relu(type_1(condition.slice(1, 0, kConditionTypes)))));
  const Tensor left = torch::relu(time(condition.slice(1, kConditionTypes)));
  const Tensor all = torch::cat({torch::relu(ego), type, left}, 1);
  return torch::relu(join_2(torch::relu(join_1(all))));
}

Tensor PublishedPatterns::placesOf(const PublishedAnchors& anchors) {
  const Tensor x = anchors.place.select(1, 0), y = anchors.place.select(1, 1);
  const Tensor polar =
      torch::stack({anchors.place.norm(2, 1) / options.anchor_scale, torch::atan2(y, x)}, 1);
  const Tensor first = torch::relu(anchor_norm_1(anchor_1(polar)));
  const Tensor second = torch::relu(anchor_norm_2(anchor_2(first)));
  return anchor_5(anchor_4->forward(anchor_norm_3(anchor_3(second))));
}

Tensor PublishedPatterns::scores(const PublishedAnchors& anchors, const Tensor& polylines,
                                 const Tensor& seen) {
  const Tensor places = placesOf(anchors);
  const Tensor shared = torch::cat({polylines, scene(seen)}, 1).unsqueeze(1);
  const Tensor grid =
      torch::zeros({polylines.size(0), traffic.lanes.points - 1, options.width}, places.options())
          .index_put({anchors.piece, anchors.point}, places);
  return score_2(score_1->forward(grid, shared)).squeeze(2).index({anchors.piece, anchors.point});
}

Tensor PublishedPatterns::anchorOffsets(const Tensor& places, const Tensor& seen) {
  const Tensor all = torch::cat({seen, places / traffic.lanes.reach}, 1);
  return shift_2(dropout(shift_1->forward(all)));
}

Tensor PublishedPatterns::egoYawOf(const Tensor& seen) {
  return ego_yaw_2(dropout(ego_yaw_1->forward(seen))).squeeze(1);
}

Tensor PublishedPatterns::offsetOf(const Tensor& seen) { return offset(dropout(seen)); }

Tensor PublishedPatterns::attackerYawOf(const Tensor& seen) {
  return attacker_yaw(dropout(seen)).squeeze(1);
}

Tensor PublishedPatterns::selection(const TrafficBatch& batch, const Tensor& seen) {
  const long now = traffic.history_frames - 1;
  const Tensor places = batch.poses.select(2, now).slice(2, 0, 2) / traffic.lanes.reach;
  const Tensor agents = torch::relu(selector_1(places));
  const Tensor all = torch::cat({agents, seen.unsqueeze(1).expand({-1, agents.size(1), -1})}, 2);
  const Tensor logits = selector_3(dropout(selector_2->forward(all))).squeeze(2);
  Tensor absent = batch.seen.select(2, now) == 0;
  absent.select(1, static_cast<long>(kEgoAgent)).fill_(true);
  return logits.masked_fill(absent, kAbsentLogit);
}

}  // namespace forge
