#include "collision_forge/attack/network/pattern_network.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace forge {
namespace {

constexpr int kMedianSteps = 30;
constexpr double kMedianFloor = 0.05;  // m
constexpr double kHeadingReach = 2.0;  // m around the median within which headings are averaged
constexpr int kEgoOutputs = 6;
constexpr int kCandidateOutputs = 5;
constexpr float kLargestWeight = 1e6F;  // trained weights are 2 at most
constexpr float kLargestOutput = 1e4F;  // of the last layers

std::string shapeText(Eigen::Index outputs, Eigen::Index inputs) {
  return std::to_string(outputs) + " x " + std::to_string(inputs);
}

void requireShape(const Eigen::Ref<const RowMatrix>& matrix, Eigen::Index rows,
                  Eigen::Index columns, const char* name) {
  if (matrix.rows() != rows || matrix.cols() != columns) {
    throw std::invalid_argument(std::string(name) + " are " +
                                shapeText(matrix.rows(), matrix.cols()) + ", not " +
                                shapeText(rows, columns));
  }
  if (!matrix.allFinite()) {
    throw std::invalid_argument(std::string(name) + " have a number that is not finite");
  }
}

/// Returns false for NaN, too.
template <typename Numbers>
bool isWithin(const Numbers& numbers, float largest) {
  return (numbers.array().abs() <= largest).all();
}

void checkOutputs(const RowMatrix& outputs) {
  if (isWithin(outputs, kLargestOutput)) return;
  throw std::runtime_error(
      "the pattern network returned a number beyond 10000: its weights are damaged");
}

RowMatrix apply(const LinearWeights& layer, const RowMatrix& input) {
  RowMatrix output = input * layer.matrix.transpose();
  output.rowwise() += layer.bias.transpose();
  return output;
}

/// The columns of a layer for its first inputs, and for its last inputs.
auto firstInputs(const LinearWeights& layer, Eigen::Index count) {
  return layer.matrix.leftCols(count);
}
auto lastInputs(const LinearWeights& layer, Eigen::Index count) {
  return layer.matrix.rightCols(count);
}

void relu(RowMatrix& values) { values = values.cwiseMax(0.0F); }

/// Encodes polylines of `size` vectors each: two layers, where the second also receives the
/// polyline's maximum, then max pooling. Returns one row per polyline with at least one unmasked
/// vector; masked vectors cost nothing.
RowMatrix polylines(const RowMatrix& vectors, const Eigen::VectorXf& mask, Eigen::Index size,
                    const LinearWeights& first, const LinearWeights& second) {
  std::vector<Eigen::Index> rows;
  std::vector<Eigen::Index> bounds;  // first row of each polyline
  for (Eigen::Index first_row = 0; first_row < mask.size(); first_row += size) {
    const auto before = static_cast<Eigen::Index>(rows.size());
    for (Eigen::Index row = first_row; row < first_row + size; ++row) {
      if (mask[row] > 0.0F) rows.push_back(row);
    }
    if (before < static_cast<Eigen::Index>(rows.size())) bounds.push_back(before);
  }
  const auto count = static_cast<Eigen::Index>(bounds.size());
  bounds.push_back(static_cast<Eigen::Index>(rows.size()));
  const auto polyline = [&](const RowMatrix& of, Eigen::Index i) {
    const auto at = static_cast<std::size_t>(i);
    return of.middleRows(bounds[at], bounds[at + 1] - bounds[at]);
  };
  const Eigen::Index hidden = second.bias.size();
  const RowMatrix there = vectors(rows, Eigen::all);
  RowMatrix inner = apply(first, there);
  relu(inner);
  RowMatrix largest(count, hidden);
  for (Eigen::Index i = 0; i < count; ++i) largest.row(i) = polyline(inner, i).colwise().maxCoeff();
  RowMatrix shared = largest * lastInputs(second, hidden).transpose();
  shared.rowwise() += second.bias.transpose();
  const RowMatrix outer = inner * firstInputs(second, hidden).transpose();
  RowMatrix result(count, hidden);
  for (Eigen::Index i = 0; i < count; ++i) {
    result.row(i) = polyline(outer, i).colwise().maxCoeff() + shared.row(i);
  }
  relu(result);  // the maximum of sums equals the sum of the maximum here
  return result;
}

/// Groups with at least one anchor, and the rows of their anchors.
struct PresentAnchors {
  std::vector<Eigen::Index> groups;
  std::vector<Eigen::Index> rows;
};
PresentAnchors presentAnchors(const AnchorFeatures& anchors) {
  PresentAnchors present;
  for (Eigen::Index group = 0; group < anchors.groups.rows(); ++group) {
    const Eigen::Index first = group * anchors.group_size;
    if (anchors.prior.segment(first, anchors.group_size).maxCoeff() <= kAbsent) continue;
    present.groups.push_back(group);
    for (Eigen::Index i = 0; i < anchors.group_size; ++i) present.rows.push_back(first + i);
  }
  return present;
}

/// Returns the spread in units of the anchors' scale.
float spreadOf(float log_spread) {
  constexpr auto kMax = static_cast<float>(kMaxLogSpread);
  return std::exp(std::clamp(log_spread, -kMax, kMax));
}

double logLogistic(double offset, double scale) {
  const double z = std::abs(offset / scale);
  return -z - 2.0 * std::log1p(std::exp(-z)) - std::log(scale);
}

}  // namespace

std::map<std::string, LayerShape> layerShapes(const PatternNetworkOptions& options) {
  const int hidden = options.hidden;
  const int scene = options.scene;
  const int anchor = options.anchor;
  return {{"agent_first", {kAgentVector, hidden}},
          {"agent_second", {2 * hidden, hidden}},
          {"lane_first", {kLaneVector, hidden}},
          {"lane_second", {2 * hidden, hidden}},
          {"query", {hidden, hidden}},
          {"key", {hidden, hidden}},
          {"value", {hidden, hidden}},
          {"scene", {2 * hidden + kEgoFeatures, scene}},
          {"request", {scene + kRequestFeatures, scene}},
          {"group", {scene + kGroupFeatures, scene}},
          {"anchor_first", {scene + kAnchorFeatures, anchor}},
          {"anchor_second", {anchor, anchor}},
          {"anchor_last", {anchor, kEgoOutputs}},
          {"candidate_first", {scene + kCandidateFeatures, anchor}},
          {"candidate_second", {anchor, anchor}},
          {"candidate_last", {anchor, kCandidateOutputs}}};
}

void checkWeights(const PatternWeights& weights) {
  const PatternNetworkOptions& network = weights.network;
  if (network.hidden < 1 || network.scene < 1 || network.anchor < 1) {
    throw std::invalid_argument("network: hidden, scene and anchor must be at least 1");
  }
  const auto shapes = layerShapes(network);
  for (const auto& [name, shape] : shapes) {
    const auto layer = weights.layers.find(name);
    if (layer == weights.layers.end()) throw std::invalid_argument("layer " + name + " is missing");
    const RowMatrix& matrix = layer->second.matrix;
    if (matrix.rows() != shape.outputs || matrix.cols() != shape.inputs ||
        layer->second.bias.size() != shape.outputs) {
      throw std::invalid_argument("layer " + name + " is " +
                                  shapeText(matrix.rows(), matrix.cols()) + ", not " +
                                  shapeText(shape.outputs, shape.inputs));
    }
    if (!isWithin(matrix, kLargestWeight) || !isWithin(layer->second.bias, kLargestWeight)) {
      throw std::invalid_argument("layer " + name + " has a number beyond " +
                                  std::to_string(static_cast<int>(kLargestWeight)));
    }
  }
  for (const auto& layer : weights.layers) {
    if (shapes.count(layer.first) == 0) {
      throw std::invalid_argument("layer " + layer.first + " is unknown");
    }
  }
}

PatternNetwork::PatternNetwork(PatternWeights weights, std::vector<PatternWeights> folds)
    : weights_(std::move(weights)), folds_(std::move(folds)) {
  checkWeights(weights_);
}

Eigen::VectorXf PatternNetwork::encode(const SceneFeatures& features) const {
  const PatternFeatureOptions& options = weights_.features;
  const auto& layers = weights_.layers;
  const Eigen::Index frames = options.history_frames;
  const Eigen::Index points = options.encoding.lane_points;
  requireShape(features.agents, (1 + options.max_agents) * frames, kAgentVector, "agents");
  requireShape(features.lanes, options.encoding.max_lanes * points, kLaneVector, "lanes");
  requireShape(features.ego, kEgoFeatures, 1, "ego features");
  requireShape(features.agent_mask, features.agents.rows(), 1, "agent masks");
  requireShape(features.lane_mask, features.lanes.rows(), 1, "lane masks");
  const RowMatrix agents = polylines(features.agents, features.agent_mask, frames,
                                     layers.at("agent_first"), layers.at("agent_second"));
  const RowMatrix lanes = polylines(features.lanes, features.lane_mask, points,
                                    layers.at("lane_first"), layers.at("lane_second"));
  const Eigen::Index hidden = weights_.network.hidden;
  RowMatrix tokens(agents.rows() + lanes.rows(), hidden);
  tokens << agents, lanes;
  const RowMatrix query = apply(layers.at("query"), tokens.topRows(1));
  const RowMatrix keys = apply(layers.at("key"), tokens);
  Eigen::VectorXf attention = keys * query.transpose() / std::sqrt(static_cast<float>(hidden));
  attention = (attention.array() - attention.maxCoeff()).exp();
  attention /= attention.sum();
  const RowMatrix mixed = attention.transpose() * apply(layers.at("value"), tokens);
  RowMatrix input(1, 2 * hidden + kEgoFeatures);
  input << tokens.topRows(1), mixed, features.ego.transpose();
  RowMatrix scene = apply(layers.at("scene"), input);
  relu(scene);
  return scene.transpose();
}

Eigen::VectorXf PatternNetwork::withRequest(const Eigen::VectorXf& scene,
                                            const Eigen::VectorXf& request) const {
  RowMatrix input(1, scene.size() + request.size());
  input << scene.transpose(), request.transpose();
  RowMatrix output = apply(weights_.layers.at("request"), input);
  relu(output);
  return output.transpose();
}

std::vector<EgoComponent> PatternNetwork::ego(const Eigen::VectorXf& with_request,
                                              const AnchorFeatures& anchors) const {
  const auto& layers = weights_.layers;
  const LinearWeights& group = layers.at("group");
  const LinearWeights& first = layers.at("anchor_first");
  const Eigen::Index scene = weights_.network.scene;
  if (!anchors.groups.allFinite() || !anchors.anchors.allFinite()) {
    throw std::invalid_argument("anchors have a number that is not finite");
  }
  const PresentAnchors present = presentAnchors(anchors);
  RowMatrix groups =
      anchors.groups(present.groups, Eigen::all) * lastInputs(group, kGroupFeatures).transpose();
  const Eigen::VectorXf shared = firstInputs(group, scene) * with_request + group.bias;
  groups.rowwise() += shared.transpose();
  relu(groups);
  RowMatrix of_groups = groups * firstInputs(first, scene).transpose();
  of_groups.rowwise() += first.bias.transpose();
  RowMatrix hidden =
      anchors.anchors(present.rows, Eigen::all) * lastInputs(first, kAnchorFeatures).transpose();
  for (Eigen::Index i = 0; i < of_groups.rows(); ++i) {
    hidden.middleRows(i * anchors.group_size, anchors.group_size).rowwise() += of_groups.row(i);
  }
  relu(hidden);
  RowMatrix second = apply(layers.at("anchor_second"), hidden);
  relu(second);
  const RowMatrix out = apply(layers.at("anchor_last"), second);
  checkOutputs(out);
  const Eigen::VectorXf scores = out.col(0) + anchors.prior(present.rows);
  const float largest = scores.maxCoeff();
  const float sum = (scores.array() - largest).exp().sum();
  std::vector<EgoComponent> components;
  for (Eigen::Index row = 0; row < out.rows(); ++row) {
    const Eigen::Index i = present.rows[static_cast<std::size_t>(row)];
    if (anchors.prior[i] <= kAbsent) continue;
    EgoComponent component;
    component.probability = std::exp(scores[row] - largest) / sum;
    const Pose2 anchor{anchors.poses(i, 0), anchors.poses(i, 1),
                       std::atan2(anchors.poses(i, 3), anchors.poses(i, 2))};
    const double along = anchors.along_scale * out(row, 1);
    component.pose = compose(anchor, {along, anchors.across_scale * out(row, 2), out(row, 5)});
    component.along = anchors.along_scale * spreadOf(out(row, 3));
    component.across = anchors.across_scale * spreadOf(out(row, 4));
    component.group = i / anchors.group_size;
    if (anchors.arc_lengths.size() > 0) component.arc_length = anchors.arc_lengths[i] + along;
    components.push_back(component);
  }
  return components;
}

std::vector<CandidateAnswer> PatternNetwork::candidates(const Eigen::VectorXf& with_request,
                                                        const RowMatrix& features) const {
  const auto& layers = weights_.layers;
  const LinearWeights& first = layers.at("candidate_first");
  const Eigen::VectorXf shared =
      firstInputs(first, weights_.network.scene) * with_request + first.bias;
  RowMatrix hidden = features * lastInputs(first, kCandidateFeatures).transpose();
  hidden.rowwise() += shared.transpose();
  relu(hidden);
  RowMatrix second = apply(layers.at("candidate_second"), hidden);
  relu(second);
  const RowMatrix out = apply(layers.at("candidate_last"), second);
  checkOutputs(out);
  std::vector<CandidateAnswer> answers;
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    answers.push_back(
        {out(i, 0),
         {kOffsetScale * out(i, 1), kOffsetScale * out(i, 2),
          std::atan2(static_cast<double>(out(i, 4)), static_cast<double>(out(i, 3)))}});
  }
  return answers;
}

Pose2 medianPose(const std::vector<EgoComponent>& components) {
  Vector2 median = Vector2::Zero();
  for (const EgoComponent& component : components) {
    median += component.probability * component.pose.position();
  }
  for (int step = 0; step < kMedianSteps; ++step) {  // Weiszfeld
    Vector2 sum = Vector2::Zero();
    double weights = 0.0;
    for (const EgoComponent& component : components) {
      const double distance = (component.pose.position() - median).norm();
      const double weight = component.probability / std::max(distance, kMedianFloor);
      sum += weight * component.pose.position();
      weights += weight;
    }
    median = sum / weights;
  }
  Vector2 heading = Vector2::Zero();
  for (const EgoComponent& component : components) {
    const double distance = (component.pose.position() - median).norm() / kHeadingReach;
    const double weight = component.probability / (1.0 + distance * distance * distance * distance);
    heading += weight * component.pose.heading();
  }
  return {median.x(), median.y(), std::atan2(heading.y(), heading.x())};
}

double logDensity(const std::vector<EgoComponent>& components, const Vector2& position) {
  double density = 0.0;
  for (const EgoComponent& component : components) {
    const Pose2 offset = relativeTo(component.pose, {position.x(), position.y(), 0.0});
    density += component.probability * std::exp(logLogistic(offset.x, component.along) +
                                                logLogistic(offset.y, component.across));
  }
  return std::log(std::max(density, 1e-30));
}

}  // namespace forge
