#include "collision_forge/study/generators/published_network.h"

#include <cmath>
#include <utility>

#include "collision_forge/attack/search/baselines.h"
#include "collision_forge/study/generators/published_patterns.h"
#include "collision_forge/study/generators/published_predictor.h"

// Deviations from the released code, and choices that the paper leaves open:
// - The ego's heading is along x. Positions are in units of the lanes' reach and steps in units of
//   the spacing of lane points, not in metres.
// - A polyline is a piece of a lane, not a lane. A vector has position, step, yaw, frame and an
//   intersection flag; traffic control, turns and the polyline's number are omitted.
// - The anchor layers use LayerNorm; the released code uses BatchNorm.
// - The polyline joined to an anchor is the one on which the anchor lies. The released code
//   searches "the nearest" among learned features and confuses an axis if there are several.
// - The score of an anchor is a logit. The released code uses the softmax probability as logit.
// - Offsets are trained at positive anchors. The released code trains them to 0 at negative ones.
// - The softmax of the selector is trained with cross entropy.
// - Losses are summed over a clip and averaged over a batch. The weights of the two anchor losses
//   differ accordingly.
// - The side of the attacker's heading is the side of its position at t0 relative to the ego's
//   predicted box. The released code takes it from the recorded future.

namespace forge {
namespace {

using torch::Tensor;
namespace nn = torch::nn;

Tensor wrapped(const Tensor& angle) { return torch::atan2(torch::sin(angle), torch::cos(angle)); }

/// Returns vectors [B, 2] rotated by `angle` [B].
Tensor turned(const Tensor& vectors, const Tensor& angle) {
  const Tensor x = vectors.select(1, 0), y = vectors.select(1, 1);
  const Tensor c = torch::cos(angle), s = torch::sin(angle);
  return torch::stack({c * x - s * y, s * x + c * y}, 1);
}

/// Returns the smooth L1 loss, summed over all dimensions but the first, averaged over the clips.
Tensor smoothL1(const Tensor& error) {
  return torch::smooth_l1_loss(error, torch::zeros_like(error), torch::Reduction::Sum) /
         error.size(0);
}

/// The recorded targets at the crash, in the layout of PublishedPrediction.
struct Truth {
  Tensor ego;           ///< [B, 3]
  Tensor offset;        ///< [B, 2]
  Tensor attacker_yaw;  ///< [B] rad, signed
};

Truth truthOf(const TrafficBatch& batch, int history_frames) {
  const Tensor ahead = torch::round(batch.condition.select(1, kConditionTypes) * kTtaFrames);
  const Tensor frame = ahead.to(torch::kLong) + history_frames;
  const Tensor clips = torch::arange(frame.size(0), frame.options());
  const auto at = [&](std::size_t agent) {
    return batch.poses.select(1, static_cast<long>(agent)).index({clips, frame});
  };
  const Tensor ego = at(kEgoAgent), attacker = at(kAttackerAgent);
  const Tensor yaw = ego.select(1, 2);
  return {ego, turned((attacker - ego).slice(1, 0, 2), -yaw), wrapped(attacker.select(1, 2) - yaw)};
}

/// The inputs of the heads.
struct Seen {
  Tensor all;  ///< [B, width] F_final
  PublishedAnchors anchors;
  Tensor scores;  ///< [N] logits of the anchors
};

class PublishedNetwork : public TrafficModel {
 public:
  PublishedNetwork(const PublishedNetworkOptions& options, const TrafficOptions& traffic,
                   torch::Device device)
      : options_(options),
        traffic_(traffic),
        device_(device),
        patterns_(std::make_shared<PublishedPatterns>(options, traffic)),
        steps_(patterns_->parameters(), torch::optim::AdamOptions(options.learning_rate)) {
    patterns_->to(device);
  }

  std::vector<std::string> lossNames() const override {
    return {"ego_place", "ego_yaw", "attacker_offset", "attacker_yaw", "selection"};
  }

  /// Trains the three modules jointly with a weighted sum of losses and a decaying learning rate.
  std::vector<double> trainStep(const TrafficBatch& batch) override {
    const Truth truth = truthOf(batch, traffic_.history_frames);
    const Seen seen = encode(batch);
    const std::vector<Tensor> losses = {
        placeLoss(seen, truth),
        options_.ego_yaw_loss *
            smoothL1(wrapped(patterns_->egoYawOf(seen.all) - truth.ego.select(1, 2))),
        options_.attacker_offset_loss * smoothL1(patterns_->offsetOf(seen.all) - truth.offset),
        options_.attacker_yaw_loss *
            smoothL1(patterns_->attackerYawOf(seen.all) - truth.attacker_yaw.abs()),
        options_.selection_loss * selectionLoss(patterns_->selection(batch, seen.all))};
    setLearningRate();
    steps_.zero_grad();
    torch::stack(losses).sum().backward();
    steps_.step();
    ++batches_;
    std::vector<double> values;
    for (const Tensor& loss : losses) values.push_back(loss.item<double>());
    return values;
  }

  /// The error of the ego's position covers only clips with a predicted position.
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

  std::unique_ptr<const AttackMethod> method(const AttackOptions& options) const override;

  /// Predicts from histories, which must be on the network's device. The module must be in eval
  /// mode.
  PublishedPrediction predict(const TrafficBatch& batch) const {
    const Seen seen = encode(batch);
    const auto [placed, place] = egoPlace(seen);
    return {placed,
            place,
            patterns_->egoYawOf(seen.all),
            patterns_->offsetOf(seen.all),
            patterns_->attackerYawOf(seen.all),
            patterns_->selection(batch, seen.all)};
  }

 private:
  void setLearningRate() {
    const std::int64_t late = batches_ - options_.decay_from;
    const std::int64_t times = late < 0 ? 0 : 1 + late / options_.decay_every;
    const double rate =
        options_.learning_rate * std::pow(options_.decay, static_cast<double>(times));
    for (auto& group : steps_.param_groups()) group.options().set_lr(rate);
  }

  Seen encode(const TrafficBatch& batch) const {
    const PublishedPieces pieces = piecesOf(batch, traffic_.lanes.reach);
    const Tensor graph = patterns_->graphOf(batch, pieces);
    Seen seen{patterns_->joined(graph.select(1, 0), batch.condition), {}, {}};
    seen.anchors = anchorsOf(pieces, graph.size(0));
    const Tensor row = pieces.clip * graph.size(1) + pieces.polyline;
    seen.scores = patterns_->scores(seen.anchors, graph.flatten(0, 1).index_select(0, row),
                                    seen.all.index_select(0, pieces.clip));
    return seen;
  }

  /// Returns a mask of the clips with a predicted ego position, and the positions [B, 2]: the best
  /// anchor with its offset.
  std::pair<Tensor, Tensor> egoPlace(const Seen& seen) const {
    const long clips = seen.all.size(0);
    const Tensor scores = seen.anchors.inRows(seen.scores, clips, kAbsentLogit);
    const Tensor best = scores.argmax(1);
    const Tensor row = torch::arange(clips, best.options());
    const Tensor place = seen.anchors.inRows(seen.anchors.place, clips, 0.0).index({row, best});
    return {scores.amax(1) > kAbsentLogit, place + patterns_->anchorOffsets(place, seen.all)};
  }

  /// Returns the losses of anchor scores and of the offsets of positive anchors.
  Tensor placeLoss(const Seen& seen, const Truth& truth) const {
    const Tensor ego = truth.ego.slice(1, 0, 2);
    const PublishedAnchors& anchors = seen.anchors;
    const Tensor missing = ego.index({anchors.clip}) - anchors.place;
    const Tensor positive = missing.norm(2, 1) < options_.positive_radius;
    const Tensor scored = torch::binary_cross_entropy_with_logits(
        seen.scores, positive.to(torch::kFloat), {},
        torch::tensor(options_.positive_weight, seen.scores.options()), torch::Reduction::Sum);
    const Tensor which = positive.nonzero().squeeze(1);
    const Tensor predicted = patterns_->anchorOffsets(
        anchors.place.index({which}), seen.all.index_select(0, anchors.clip.index({which})));
    const Tensor shifted = (predicted - missing.index({which})).abs().sum();
    return (options_.anchors_loss * scored + options_.anchor_offset_loss * shifted) / ego.size(0);
  }

  static Tensor selectionLoss(const Tensor& logits) {
    const Tensor right = torch::full({logits.size(0)}, static_cast<long>(kAttackerAgent),
                                     torch::device(logits.device()).dtype(torch::kLong));
    return torch::cross_entropy_loss(logits, right);
  }

  PublishedNetworkOptions options_;
  TrafficOptions traffic_;
  torch::Device device_;
  std::shared_ptr<PublishedPatterns> patterns_;
  torch::optim::Adam steps_;
  std::int64_t batches_ = 0;
};

std::vector<ErrorSum> PublishedNetwork::errorsOn(const TrafficBatch& batch,
                                                 torch::Generator) const {
  const Truth truth = truthOf(batch, traffic_.history_frames);
  const PublishedPrediction predicted = predict(batch);
  const auto attacker = static_cast<long>(kAttackerAgent);
  const Tensor yaw = relativeYaws(predicted, batch, traffic_.history_frames).select(1, attacker);
  const auto sumOf = [](const Tensor& numbers) {
    return numbers.sum(torch::kFloat64).item<double>();
  };
  const auto degrees = [&](const Tensor& error) {
    return sumOf(wrapped(error).abs()) * 180.0 / M_PI;
  };
  const auto count = static_cast<double>(batch.poses.size(0));
  const Tensor apart = (predicted.ego_place - truth.ego.slice(1, 0, 2)).norm(2, 1);
  return {{degrees(predicted.ego_yaw - truth.ego.select(1, 2)), count},
          {degrees(yaw - truth.attacker_yaw), count},
          {sumOf((predicted.offset - truth.offset).norm(2, 1)), count},
          {sumOf(predicted.selection.argmax(1) != attacker), count},
          {sumOf(apart * predicted.placed), sumOf(predicted.placed)}};
}

std::unique_ptr<const AttackMethod> PublishedNetwork::method(const AttackOptions& options) const {
  patterns_->eval();
  const auto self = std::static_pointer_cast<const PublishedNetwork>(shared_from_this());
  const auto tell = [self](const TrafficBatch& batch) {
    return self->predict(movedTo(batch, self->device_));
  };
  return std::make_unique<PatternQuinticMethod>(
      options, makePublishedPredictor(tell, traffic_, options.prediction));
}

}  // namespace

std::shared_ptr<TrafficModel> makePublishedNetwork(const PublishedNetworkOptions& options,
                                                   const TrafficOptions& traffic,
                                                   torch::Device device) {
  return std::make_shared<PublishedNetwork>(options, traffic, device);
}

}  // namespace forge
