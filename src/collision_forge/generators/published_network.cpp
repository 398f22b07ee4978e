#include "collision_forge/generators/published_network.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/baselines.h"
#include "collision_forge/attack/driven_answer.h"
#include "collision_forge/attack/request_check.h"
#include "collision_forge/forecast/kinematic_prediction.h"
#include "collision_forge/forecast/motion_estimate.h"

// Otherwise than in the released code, or chosen where the paper leaves it open:
// - The ego drives along x. Places are told as shares of the lanes' reach and steps in spacings of
//   lane points, not in metres.
// - A polyline is a piece of a lane, not a lane. A vector tells its place, step, yaw, frame and
//   whether it is in an intersection; traffic control, turns and the polyline's number are left
//   out.
// - LayerNorm where the layers of the anchors have BatchNorm there.
// - The polyline that is joined to an anchor is the one that it lies on. There "the nearest" were
//   looked for among learned numbers, and an axis was mixed up where there were several.
// - The score of an anchor is one real logit. There the softmax's probability was taken as one.
// - Offsets are learned at positive anchors. There they were to be 0 at those judged negative.
// - The softmax of the selector is learned by cross entropy.
// - A loss is summed over a clip and averaged over a batch. The weights of the anchors' two losses
//   are others, as these losses are.
// - Which side the attacker's heading comes from is that of its place now, as seen from the ego's
//   predicted box. There it was looked up in the recorded future.

namespace forge {
namespace {

using torch::Tensor;
using torch::indexing::None;
using torch::indexing::Slice;
namespace nn = torch::nn;

constexpr int kVectorNumbers = 7;  // of vectorsOf()
constexpr int kTypes = kConditionNumbers - 1;
constexpr double kNever = -1e9;  // logit of what is not there

/// Kaiming's initial weights, as in the released code.
nn::Linear linear(long from, long to) {
  nn::Linear layer(from, to);
  nn::init::kaiming_normal_(layer->weight);
  return layer;
}

nn::LayerNorm norm(long width) { return nn::LayerNorm(nn::LayerNormOptions({width})); }

/// A layer on [own, shared], where `shared` is the same along a dimension of size 1: what comes of
/// it is computed there once.
Tensor onBoth(nn::Linear& layer, const Tensor& own, const Tensor& shared) {
  const long width = own.size(-1);
  return nn::functional::linear(own, layer->weight.slice(1, 0, width), layer->bias) +
         nn::functional::linear(shared, layer->weight.slice(1, width));
}

/// Two layers with a shortcut.
struct Block : nn::Module {
  Block(long from, long to) {
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
  /// Of [own, shared] as onBoth().
  Tensor forward(const Tensor& own, const Tensor& shared) {
    return finished(onBoth(layer_1, own, shared), shortcut_norm(onBoth(shortcut, own, shared)));
  }

  Tensor finished(const Tensor& first, const Tensor& around) {
    return torch::relu(norm_2(layer_2(torch::relu(norm_1(first)))) + around);
  }

  nn::Linear layer_1{nullptr}, layer_2{nullptr}, shortcut{nullptr};
  nn::LayerNorm norm_1{nullptr}, norm_2{nullptr}, shortcut_norm{nullptr};
};

/// VectorNet's net of a polyline: three blocks, each joined with the most of all its vectors.
struct SubGraph : nn::Module {
  explicit SubGraph(long width) {
    block_1 = register_module("block_1", std::make_shared<Block>(kVectorNumbers, width));
    block_2 = register_module("block_2", std::make_shared<Block>(2 * width, width));
    block_3 = register_module("block_3", std::make_shared<Block>(2 * width, width));
    output = register_module("output", linear(2 * width, width));
  }

  /// Vectors [N, V, kVectorNumbers] to polylines [N, width] of length 1.
  Tensor forward(const Tensor& vectors) {
    const Tensor first = block_1->forward(vectors);
    const Tensor second = block_2->forward(first, first.amax(1, true));
    const Tensor third = block_3->forward(second, second.amax(1, true));
    const Tensor most = onBoth(output, third, third.amax(1, true)).amax(1);
    return nn::functional::normalize(most, nn::functional::NormalizeFuncOptions().dim(1));
  }

  std::shared_ptr<Block> block_1, block_2, block_3;
  nn::Linear output{nullptr};
};

/// The pieces of lanes near the egos of a batch, all clips' in one list.
struct Pieces {
  Tensor points;    ///< [N, P, kLaneNumbers]
  Tensor seen;      ///< [N, P]
  Tensor clip;      ///< [N] whose
  Tensor polyline;  ///< [N] from 1 on within the clip; 0 is the ego
};

/// Those that have a point within `reach` of the ego, wherever its attacker is.
Pieces piecesOf(const TrafficBatch& batch, double reach) {
  const Tensor far = batch.lanes.slice(3, 0, 2).norm(2, 3);
  const Tensor near = ((far <= reach) * (batch.lane_seen > 0)).any(2);
  const Tensor which = near.nonzero();
  const Tensor clip = which.select(1, 0), piece = which.select(1, 1);
  return {batch.lanes.index({clip, piece}), batch.lane_seen.index({clip, piece}), clip,
          near.cumsum(1).index({clip, piece})};
}

/// Points of lanes where the ego may be at the crash, all clips' in one list, in order of the clip.
struct Anchors {
  Tensor place;   ///< [N, 2] m
  Tensor clip;    ///< [N] whose
  Tensor piece;   ///< [N] of Pieces
  Tensor point;   ///< [N] of the piece
  Tensor column;  ///< [N] from 0 on within the clip
  long most = 0;  ///< of one clip, 1 at least

  /// Numbers [N, ...] of each as [B, most, ...], `none` where there is no anchor.
  Tensor inRows(const Tensor& numbers, long clips, double none) const {
    std::vector<std::int64_t> shape = numbers.sizes().vec();
    shape.front() = most;
    shape.insert(shape.begin(), clips);
    return torch::full(shape, none, numbers.options()).index_put({clip, column}, numbers);
  }
};

/// All points but the last one of a full piece, which is the first of the next.
Anchors anchorsOf(const Pieces& pieces, long clips) {
  const Tensor which = pieces.seen.slice(1, 0, -1).nonzero();
  const Tensor piece = which.select(1, 0), point = which.select(1, 1);
  const Tensor clip = pieces.clip.index({piece});
  const Tensor counts = torch::bincount(clip, {}, clips);
  const Tensor firsts = counts.cumsum(0) - counts;
  const Tensor place = pieces.points.index({piece, point, Slice(None, 2)});
  const Tensor column = torch::arange(clip.size(0), clip.options()) - firsts.index({clip});
  return {place, clip, piece, point, column, std::max(1L, counts.max().item<long>())};
}

/// What the network tells of B clips with A agents. Lengths in m, angles in rad; ego's frame at
/// now.
struct Told {
  Tensor placed;        ///< [B] false: there are no anchors, and the place means nothing
  Tensor ego_place;     ///< [B, 2] at the crash
  Tensor ego_yaw;       ///< [B]
  Tensor offset;        ///< [B, 2] of the attacker, in the frame of the ego's box then
  Tensor attacker_yaw;  ///< [B] how far it is turned from the ego's, to whichever side
  Tensor selection;     ///< [B, A] logits; that of nobody and of the ego is kNever
};

/// The parts of the published network.
struct Patterns : nn::Module {
  Patterns(PublishedHead head, const PublishedNetworkOptions& options,
           const TrafficOptions& traffic)
      : head(head), options(options), traffic(traffic) {
    const long width = options.width;
    subgraph = register_module("subgraph", std::make_shared<SubGraph>(width));
    query = register_module("query", linear(width + 2, width));
    key = register_module("key", linear(width + 2, width));
    value = register_module("value", linear(width + 2, width));
    type_1 = register_module("type_1", nn::Linear(nn::LinearOptions(kTypes, kTypes).bias(false)));
    type_2 = register_module("type_2", linear(kTypes, options.condition));
    time = register_module("time", linear(1, options.condition));
    join_1 = register_module("join_1", linear(width + 2 * options.condition, width));
    join_2 = register_module("join_2", linear(width, width));
    dropout = register_module("dropout", nn::Dropout(options.dropout));
    ego_yaw_1 = register_module("ego_yaw_1", std::make_shared<Block>(width, width));
    ego_yaw_2 = register_module("ego_yaw_2", linear(width, 1));
    offset = register_module("offset", linear(width, 2));
    attacker_yaw = register_module("attacker_yaw", linear(width, 1));
    selector_1 = register_module("selector_1", linear(2, options.selector));
    selector_2 =
        register_module("selector_2", std::make_shared<Block>(width + options.selector, width));
    selector_3 = register_module("selector_3", linear(width, 1));
    if (head == PublishedHead::kRegression) {
      place_1 = register_module("place_1", std::make_shared<Block>(width, width));
      place_2 = register_module("place_2", linear(width, 2));
    } else {
      addAnchorLayers();
    }
  }

  void addAnchorLayers() {
    const long width = options.width;
    anchor_1 = register_module("anchor_1", linear(2, options.anchor_1));
    anchor_2 = register_module("anchor_2", linear(options.anchor_1, options.anchor_2));
    anchor_3 = register_module("anchor_3", linear(options.anchor_2, options.anchor_3));
    anchor_norm_1 = register_module("anchor_norm_1", norm(options.anchor_1));
    anchor_norm_2 = register_module("anchor_norm_2", norm(options.anchor_2));
    anchor_norm_3 = register_module("anchor_norm_3", norm(options.anchor_3));
    anchor_4 = register_module("anchor_4", std::make_shared<Block>(options.anchor_3, width));
    anchor_5 = register_module("anchor_5", linear(width, width));
    scene = register_module("scene", linear(width, width));
    score_1 = register_module("score_1", std::make_shared<Block>(3 * width, width));
    score_2 = register_module("score_2", linear(width, 1));
    if (head != PublishedHead::kRegionProposal) return;
    shift_1 = register_module("shift_1", std::make_shared<Block>(width + 2, width));
    shift_2 = register_module("shift_2", linear(width, 2));
  }

  /// [N, V, kVectorNumbers]: where each step is and how long, [N, V, 2], and what else is told.
  Tensor vectorsOf(const Tensor& at, const Tensor& steps, const Tensor& yaw, const Tensor& frame,
                   const Tensor& intersection) const {
    return torch::cat({at / traffic.lanes.reach, steps / traffic.lanes.spacing, yaw.unsqueeze(2),
                       frame.unsqueeze(2), intersection.unsqueeze(2)},
                      2);
  }

  /// [N, width + 2] with the least x and y of each.
  Tensor polylinesOf(const Tensor& vectors) {
    return torch::cat({subgraph->forward(vectors), vectors.slice(2, 0, 2).amin(1)}, 1);
  }

  Tensor egoPolylines(const TrafficBatch& batch) {
    const Tensor ego =
        batch.poses.select(1, static_cast<long>(kEgoAgent)).slice(1, 0, traffic.history_frames);
    const Tensor places = ego.slice(2, 0, 2);
    const Tensor yaw = ego.select(2, 2).slice(1, 1);
    const Tensor frame =
        torch::arange(1, traffic.history_frames, places.options()) / (traffic.history_frames - 1);
    const Tensor vectors = vectorsOf(places.slice(1, 1), places.diff(1, 1), yaw,
                                     frame.expand_as(yaw), torch::zeros_like(yaw));
    return polylinesOf(vectors);
  }

  Tensor lanePolylines(const Pieces& pieces) {
    const Tensor places = pieces.points.slice(2, 0, 2);
    const Tensor centers = 0.5 * (places.slice(1, 0, -1) + places.slice(1, 1));
    const Tensor none = torch::zeros_like(centers.select(2, 0));
    const Tensor vectors =
        vectorsOf(centers, places.diff(1, 1), none, none, pieces.points.select(2, 4).slice(1, 1));
    // A shorter piece has its first vector more often, which changes nothing in the most of all.
    const Tensor seen = pieces.seen.slice(1, 1).unsqueeze(2) > 0;
    return polylinesOf(torch::where(seen, vectors, vectors.slice(1, 0, 1)));
  }

  /// The global graph: [B, 1 + L, width], the ego and its lanes, each with what it sees in all.
  Tensor graphOf(const TrafficBatch& batch, const Pieces& pieces) {
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
    const Tensor weights = alike.masked_fill(there.unsqueeze(1) == 0, kNever).softmax(2);
    return torch::matmul(weights, value(all));
  }

  /// The paper's F_final [B, width]: scene, type and time, for all heads.
  Tensor joined(const Tensor& ego, const Tensor& condition) {
    const Tensor type = torch::relu(type_2(torch::relu(type_1(condition.slice(1, 0, kTypes)))));
    const Tensor left = torch::relu(time(condition.slice(1, kTypes)));
    const Tensor all = torch::cat({torch::relu(ego), type, left}, 1);
    return torch::relu(join_2(torch::relu(join_1(all))));
  }

  /// [N, width] of what an anchor's place says.
  Tensor placesOf(const Anchors& anchors) {
    const Tensor x = anchors.place.select(1, 0), y = anchors.place.select(1, 1);
    const Tensor polar =
        torch::stack({anchors.place.norm(2, 1) / options.anchor_scale, torch::atan2(y, x)}, 1);
    const Tensor first = torch::relu(anchor_norm_1(anchor_1(polar)));
    const Tensor second = torch::relu(anchor_norm_2(anchor_2(first)));
    return anchor_5(anchor_4->forward(anchor_norm_3(anchor_3(second))));
  }

  /// [N] logits of anchors. Of each piece that they lie on `polylines` and its clip's F_final
  /// `seen`, [pieces, width].
  Tensor scores(const Anchors& anchors, const Tensor& polylines, const Tensor& seen) {
    const Tensor places = placesOf(anchors);
    const Tensor shared = torch::cat({polylines, scene(seen)}, 1).unsqueeze(1);
    const Tensor grid =
        torch::zeros({polylines.size(0), traffic.lanes.points - 1, options.width}, places.options())
            .index_put({anchors.piece, anchors.point}, places);
    return score_2(score_1->forward(grid, shared)).squeeze(2).index({anchors.piece, anchors.point});
  }

  /// [N, 2] m from places to where the ego is rather; `seen` F_final of each.
  Tensor shifts(const Tensor& places, const Tensor& seen) {
    const Tensor all = torch::cat({seen, places / traffic.lanes.reach}, 1);
    return shift_2(dropout(shift_1->forward(all)));
  }

  /// [B, 2] m, without a lane.
  Tensor regressed(const Tensor& seen) {
    return options.place_scale * place_2(dropout(place_1->forward(seen)));
  }

  Tensor selection(const TrafficBatch& batch, const Tensor& seen) {
    const long now = traffic.history_frames - 1;
    const Tensor places = batch.poses.select(2, now).slice(2, 0, 2) / traffic.lanes.reach;
    const Tensor agents = torch::relu(selector_1(places));
    const Tensor all = torch::cat({agents, seen.unsqueeze(1).expand({-1, agents.size(1), -1})}, 2);
    const Tensor logits = selector_3(dropout(selector_2->forward(all))).squeeze(2);
    Tensor absent = batch.seen.select(2, now) == 0;
    absent.select(1, static_cast<long>(kEgoAgent)).fill_(true);
    return logits.masked_fill(absent, kNever);
  }

  PublishedHead head;
  PublishedNetworkOptions options;
  TrafficOptions traffic;
  std::shared_ptr<SubGraph> subgraph;
  std::shared_ptr<Block> ego_yaw_1, selector_2, place_1, anchor_4, score_1, shift_1;
  nn::Linear query{nullptr}, key{nullptr}, value{nullptr};
  nn::Linear type_1{nullptr}, type_2{nullptr}, time{nullptr}, join_1{nullptr}, join_2{nullptr};
  nn::Linear ego_yaw_2{nullptr}, offset{nullptr}, attacker_yaw{nullptr}, place_2{nullptr};
  nn::Linear selector_1{nullptr}, selector_3{nullptr};
  nn::Linear anchor_1{nullptr}, anchor_2{nullptr}, anchor_3{nullptr}, anchor_5{nullptr};
  nn::LayerNorm anchor_norm_1{nullptr}, anchor_norm_2{nullptr}, anchor_norm_3{nullptr};
  nn::Linear scene{nullptr}, score_2{nullptr}, shift_2{nullptr};
  nn::Dropout dropout{nullptr};
};

Tensor wrapped(const Tensor& angle) { return torch::atan2(torch::sin(angle), torch::cos(angle)); }

/// Vectors [B, 2] turned by `angle` [B].
Tensor turned(const Tensor& vectors, const Tensor& angle) {
  const Tensor x = vectors.select(1, 0), y = vectors.select(1, 1);
  const Tensor c = torch::cos(angle), s = torch::sin(angle);
  return torch::stack({c * x - s * y, s * x + c * y}, 1);
}

/// Summed over all but the first dimension, then averaged over the clips; an angle's to 0 as well.
Tensor smoothL1(const Tensor& error) {
  return torch::smooth_l1_loss(error, torch::zeros_like(error), torch::Reduction::Sum) /
         error.size(0);
}

/// What came at the crash, as Told has it.
struct Truth {
  Tensor ego;           ///< [B, 3]
  Tensor offset;        ///< [B, 2]
  Tensor attacker_yaw;  ///< [B] with its side
};

Truth truthOf(const TrafficBatch& batch, int history_frames) {
  const Tensor ahead = torch::round(batch.condition.select(1, kTypes) * kTtaFrames);
  const Tensor frame = ahead.to(torch::kLong) + history_frames;
  const Tensor clips = torch::arange(frame.size(0), frame.options());
  const auto at = [&](std::size_t agent) {
    return batch.poses.select(1, static_cast<long>(agent)).index({clips, frame});
  };
  const Tensor ego = at(kEgoAgent), attacker = at(kAttackerAgent);
  const Tensor yaw = ego.select(1, 2);
  return {ego, turned((attacker - ego).slice(1, 0, 2), -yaw), wrapped(attacker.select(1, 2) - yaw)};
}

/// What the heads are told.
struct Seen {
  Tensor all;       ///< [B, width] F_final
  Anchors anchors;  ///< of the heads that have some
  Tensor scores;    ///< [N] of the anchors
};

class PublishedNetwork : public TrafficModel {
 public:
  PublishedNetwork(PublishedHead head, const PublishedNetworkOptions& options,
                   const TrafficOptions& traffic, torch::Device device)
      : options_(options),
        traffic_(traffic),
        device_(device),
        patterns_(std::make_shared<Patterns>(head, options, traffic)),
        steps_(patterns_->parameters(), torch::optim::AdamOptions(options.learning_rate)) {
    patterns_->to(device);
  }

  std::vector<std::string> lossNames() const override {
    return {"ego_place", "ego_yaw", "attacker_offset", "attacker_yaw", "selection"};
  }

  /// The three modules learn jointly, by a weighted sum, later ever slower.
  std::vector<double> trainStep(const TrafficBatch& batch) override {
    const Truth truth = truthOf(batch, traffic_.history_frames);
    const Seen seen = look(batch);
    const std::vector<Tensor> losses = {
        placeLoss(seen, truth),
        options_.ego_yaw_loss * smoothL1(wrapped(egoYaw(seen) - truth.ego.select(1, 2))),
        options_.attacker_offset_loss * smoothL1(offset(seen) - truth.offset),
        options_.attacker_yaw_loss * smoothL1(attackerYaw(seen) - truth.attacker_yaw.abs()),
        options_.selection_loss * selectionLoss(patterns_->selection(batch, seen.all))};
    setLearningRate();
    steps_.zero_grad();
    torch::stack(losses).sum().backward();
    steps_.step();
    ++batches_;
    std::vector<double> told;
    for (const Tensor& loss : losses) told.push_back(loss.item<double>());
    return told;
  }

  /// The ego's place is judged where one is told.
  std::vector<std::string> errorNames() const override {
    return {"ego_yaw_deg", "relative_heading_deg", "offset_m", "selection_missed", "ego_m"};
  }
  std::vector<ErrorSum> errorsOn(const TrafficBatch& batch, torch::Generator) const override;

  int epochs() const override { return options_.epochs; }
  int batchSize() const override { return options_.batch; }
  const TrafficOptions& traffic() const override { return traffic_; }
  std::shared_ptr<nn::Module> network() const override { return patterns_; }

  void saveTraining(torch::serialize::OutputArchive& archive) const override {
    torch::serialize::OutputArchive steps;
    steps_.save(steps);
    archive.write("steps", steps);
    archive.write("batches", torch::tensor(batches_));
  }

  void loadTraining(torch::serialize::InputArchive& archive) override {
    torch::serialize::InputArchive steps;
    Tensor batches;
    archive.read("steps", steps);
    archive.read("batches", batches);
    steps_.load(steps);
    batches_ = batches.item<std::int64_t>();
  }

  std::unique_ptr<const AttackMethod> method(const std::string& name,
                                             const AttackOptions& options) const override;

  /// Of a batch's histories; on the device of the network, whose module is in eval mode.
  Told tell(const TrafficBatch& batch) const {
    const Seen seen = look(batch);
    const auto [placed, place] = egoPlace(seen);
    return {placed,
            place,
            egoYaw(seen),
            offset(seen),
            attackerYaw(seen),
            patterns_->selection(batch, seen.all)};
  }

  torch::Device device() const { return device_; }

 private:
  void setLearningRate() {
    const std::int64_t late = batches_ - options_.decay_from;
    const std::int64_t times = late < 0 ? 0 : 1 + late / options_.decay_every;
    const double rate =
        options_.learning_rate * std::pow(options_.decay, static_cast<double>(times));
    for (auto& group : steps_.param_groups()) group.options().set_lr(rate);
  }

  bool hasAnchors() const { return patterns_->head != PublishedHead::kRegression; }

  Seen look(const TrafficBatch& batch) const {
    const Pieces pieces = piecesOf(batch, traffic_.lanes.reach);
    const Tensor graph = patterns_->graphOf(batch, pieces);
    Seen seen{patterns_->joined(graph.select(1, 0), batch.condition), {}, {}};
    if (!hasAnchors()) return seen;
    seen.anchors = anchorsOf(pieces, graph.size(0));
    const Tensor row = pieces.clip * graph.size(1) + pieces.polyline;
    seen.scores = patterns_->scores(seen.anchors, graph.flatten(0, 1).index_select(0, row),
                                    seen.all.index_select(0, pieces.clip));
    return seen;
  }

  /// The best anchor with its offset, or the regression: where there is one, and the places [B, 2].
  std::pair<Tensor, Tensor> egoPlace(const Seen& seen) const {
    const long clips = seen.all.size(0);
    if (!hasAnchors()) {
      return {torch::ones({clips}, torch::kBool), patterns_->regressed(seen.all)};
    }
    const Tensor scores = seen.anchors.inRows(seen.scores, clips, kNever);
    const Tensor best = scores.argmax(1);
    const Tensor row = torch::arange(clips, best.options());
    Tensor place = seen.anchors.inRows(seen.anchors.place, clips, 0.0).index({row, best});
    if (patterns_->head == PublishedHead::kRegionProposal) {
      place = place + patterns_->shifts(place, seen.all);
    }
    return {scores.amax(1) > kNever, place};
  }

  Tensor egoYaw(const Seen& seen) const {
    return patterns_->ego_yaw_2(patterns_->dropout(patterns_->ego_yaw_1->forward(seen.all)))
        .squeeze(1);
  }
  Tensor offset(const Seen& seen) const { return patterns_->offset(patterns_->dropout(seen.all)); }
  Tensor attackerYaw(const Seen& seen) const {
    return patterns_->attacker_yaw(patterns_->dropout(seen.all)).squeeze(1);
  }

  Tensor placeLoss(const Seen& seen, const Truth& truth) const {
    const Tensor ego = truth.ego.slice(1, 0, 2);
    switch (patterns_->head) {
      case PublishedHead::kRegression:
        return options_.regression_loss * smoothL1(patterns_->regressed(seen.all) - ego);
      case PublishedHead::kTargetPoints:
        return options_.target_points_loss * targetPointLoss(seen, ego);
      case PublishedHead::kRegionProposal:
        break;
    }
    return proposalLoss(seen, ego);
  }

  /// The anchors around the ego's place are to be proposed, and to tell where it is from there.
  Tensor proposalLoss(const Seen& seen, const Tensor& ego) const {
    const Anchors& anchors = seen.anchors;
    const Tensor missing = ego.index({anchors.clip}) - anchors.place;
    const Tensor positive = missing.norm(2, 1) < options_.positive_radius;
    const Tensor scored = torch::binary_cross_entropy_with_logits(
        seen.scores, positive.to(torch::kFloat), {},
        torch::tensor(options_.positive_weight, seen.scores.options()), torch::Reduction::Sum);
    const Tensor which = positive.nonzero().squeeze(1);
    const Tensor told = patterns_->shifts(anchors.place.index({which}),
                                          seen.all.index_select(0, anchors.clip.index({which})));
    const Tensor shifted = (told - missing.index({which})).abs().sum();
    return (options_.anchors_loss * scored + options_.anchor_offset_loss * shifted) / ego.size(0);
  }

  /// Of all points the one that is nearest to the ego's place is the right one.
  Tensor targetPointLoss(const Seen& seen, const Tensor& ego) const {
    const Anchors& anchors = seen.anchors;
    const long clips = ego.size(0);
    const Tensor apart = (ego.index({anchors.clip}) - anchors.place).norm(2, 1);
    const Tensor nearest = anchors.inRows(apart, clips, -kNever).argmin(1);
    const Tensor logits = anchors.inRows(seen.scores, clips, kNever);
    return torch::cross_entropy_loss(logits, nearest);
  }

  static Tensor selectionLoss(const Tensor& logits) {
    const Tensor right = torch::full({logits.size(0)}, static_cast<long>(kAttackerAgent),
                                     torch::device(logits.device()).dtype(torch::kLong));
    return torch::cross_entropy_loss(logits, right);
  }

  PublishedNetworkOptions options_;
  TrafficOptions traffic_;
  torch::Device device_;
  std::shared_ptr<Patterns> patterns_;
  torch::optim::Adam steps_;
  std::int64_t batches_ = 0;
};

/// [B, A] the yaw of each agent relative to the ego's, if it is the attacker: one that comes from
/// the left is turned to the right.
Tensor relativeYaws(const Told& told, const TrafficBatch& batch, int history_frames) {
  const Tensor places = batch.poses.select(2, history_frames - 1).slice(2, 0, 2);
  const Tensor from_ego = places - told.ego_place.unsqueeze(1);
  const Tensor yaw = told.ego_yaw.unsqueeze(1);
  const Tensor left =
      torch::cos(yaw) * from_ego.select(2, 1) - torch::sin(yaw) * from_ego.select(2, 0);
  const Tensor side = torch::where(left > 0.0, -1.0, 1.0);
  return side * told.attacker_yaw.unsqueeze(1);
}

std::vector<ErrorSum> PublishedNetwork::errorsOn(const TrafficBatch& batch,
                                                 torch::Generator) const {
  const Truth truth = truthOf(batch, traffic_.history_frames);
  const Told told = tell(batch);
  const auto attacker = static_cast<long>(kAttackerAgent);
  const Tensor yaw = relativeYaws(told, batch, traffic_.history_frames).select(1, attacker);
  const auto sumOf = [](const Tensor& numbers) {
    return numbers.sum(torch::kFloat64).item<double>();
  };
  const auto degrees = [&](const Tensor& error) {
    return sumOf(wrapped(error).abs()) * 180.0 / M_PI;
  };
  const auto count = static_cast<double>(batch.poses.size(0));
  const Tensor apart = (told.ego_place - truth.ego.slice(1, 0, 2)).norm(2, 1);
  return {{degrees(told.ego_yaw - truth.ego.select(1, 2)), count},
          {degrees(yaw - truth.attacker_yaw), count},
          {sumOf((told.offset - truth.offset).norm(2, 1)), count},
          {sumOf(told.selection.argmax(1) != attacker), count},
          {sumOf(apart * told.placed), sumOf(told.placed)}};
}

/// The likeliest first, whom the request allows.
class PublishedPatternPredictor : public PatternPredictor {
 public:
  PublishedPatternPredictor(std::shared_ptr<const PublishedNetwork> network,
                            const AttackOptions& options)
      : network_(std::move(network)), options_(options.prediction) {}

  /// The ego's place is always the network's, in replay mode too.
  PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                            const CollisionRequest& request,
                            const Future* recorded) const override {
    PatternPrediction prediction;
    prediction.future = recorded
                            ? *recorded
                            : predictFuture(snapshot, lanes, request.tta + options_.tail, options_);
    const std::vector<std::string> allowed = allowedBy(request, snapshot);
    if (allowed.empty()) {
      prediction.status = {StatusCode::kNoCandidate, "no vehicle within candidate_radius = " +
                                                         std::to_string(options_.candidate_radius) +
                                                         " m, seen now and in the frame before"};
      return prediction;
    }
    const TrafficOptions& traffic = network_->traffic();
    const TrafficClip clip = trafficOf(snapshot, allowed.front(), request, traffic, &lanes);
    const TrafficBatch batch =
        movedTo(batchOf({{&clip, traffic.history_frames - 1}}, traffic, 0), network_->device());
    const torch::NoGradGuard no_gradients;
    const Told told = network_->tell(batch);
    if (!told.placed.item<bool>()) {
      prediction.status = {StatusCode::kRoadDoesNotAllow,
                           "no lane within " + std::to_string(traffic.lanes.reach) +
                               " m of the ego, where the crash could be"};
      return prediction;
    }
    fillIn(told, batch, clip, allowed, snapshot, request, prediction);
    return prediction;
  }

 private:
  /// The nearest to the ego first.
  std::vector<std::string> allowedBy(const CollisionRequest& request,
                                     const Snapshot& snapshot) const {
    if (request.attacker) return {*request.attacker};
    const Vector2 ego = snapshot.ego.states.back().pose.position();
    std::vector<std::pair<double, std::string>> found;
    for (const Track& agent : snapshot.agents) {
      if (request.attacker_class && agent.agent_class != *request.attacker_class) continue;
      if (!isCandidate(agent, snapshot, options_)) continue;
      found.emplace_back((agent.states.back().pose.position() - ego).norm(), agent.id);
    }
    std::sort(found.begin(), found.end());
    std::vector<std::string> ids;
    for (auto& entry : found) ids.push_back(std::move(entry.second));
    return ids;
  }

  /// A pattern for each of the allowed whom the network sees.
  void fillIn(const Told& told, const TrafficBatch& batch, const TrafficClip& clip,
              const std::vector<std::string>& allowed, const Snapshot& snapshot,
              const CollisionRequest& request, PatternPrediction& prediction) const {
    const Tensor yaws = relativeYaws(told, batch, network_->traffic().history_frames)[0];
    const Tensor offset = told.offset[0], place = told.ego_place[0];
    const auto number = [](const Tensor& tensor) {
      const double found = tensor.item<double>();
      if (!std::isfinite(found)) {
        throw std::runtime_error("the published network tells a number that is not finite");
      }
      return found;
    };
    const Pose2 now = estimateMotion(snapshot.ego, options_.motion_frames).pose;
    const Pose2 ego = compose(now, {number(place[0]), number(place[1]), number(told.ego_yaw[0])});
    const Tensor order = told.selection[0].argsort(0, true);
    for (long i = 0; i < order.size(0); ++i) {
      const long agent = order[i].item<long>();
      const std::string& id = clip.ids[static_cast<std::size_t>(agent)];
      if (std::find(allowed.begin(), allowed.end(), id) == allowed.end()) continue;
      CollisionPattern pattern;
      pattern.type = request.type;
      pattern.attacker_id = id;
      pattern.time = snapshot.now + request.tta;
      pattern.ego = boxAt(snapshot.ego, ego);
      pattern.attacker_offset = {number(offset[0]), number(offset[1]), number(yaws[agent])};
      pattern.attacker_speed = estimateMotion(trackOf(snapshot, id), options_.motion_frames).speed;
      pattern.tolerance = options_.network_pattern_tolerance;
      prediction.patterns.push_back(std::move(pattern));
    }
  }

  std::shared_ptr<const PublishedNetwork> network_;
  PredictionOptions options_;
};

std::unique_ptr<const AttackMethod> PublishedNetwork::method(const std::string&,
                                                             const AttackOptions& options) const {
  patterns_->eval();
  return std::make_unique<PatternQuinticMethod>(
      options, std::make_shared<PublishedPatternPredictor>(
                   std::static_pointer_cast<const PublishedNetwork>(shared_from_this()), options));
}

}  // namespace

std::shared_ptr<TrafficModel> makePublishedNetwork(PublishedHead head,
                                                   const PublishedNetworkOptions& options,
                                                   const TrafficOptions& traffic,
                                                   torch::Device device) {
  return std::make_shared<PublishedNetwork>(head, options, traffic, device);
}

}  // namespace forge
