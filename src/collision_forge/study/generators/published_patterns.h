#pragma once

#include <memory>

#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

// Tensors of the published network: B clips of a batch, N pieces or anchors of all clips in one
// list, L the largest number of pieces of a clip, P points per piece, A agents, `width` features.
// Positions are in m, in the frame of the clip's ego at t0. F_final is the paper's joint feature
// (joined()).

inline constexpr int kConditionTypes = kConditionNumbers - 1;  ///< numbers of the one-hot type
inline constexpr double kAbsentLogit = -1e9;                   ///< logit of padding

/// The lane pieces near the egos of a batch, of all clips in one list.
struct PublishedPieces {
  torch::Tensor points;  ///< [N, P, kLaneNumbers], as TrafficBatch::lanes
  torch::Tensor seen;    ///< [N, P] 1 for a point, 0 for padding
  torch::Tensor clip;    ///< [N] index of the clip in the batch, ascending
  /// [N] index of the piece among the polylines of its clip, from 1; 0 is the ego.
  torch::Tensor polyline;
};

/// Returns the lane pieces of the batch with a point within `reach` (m) of their clip's ego at t0.
PublishedPieces piecesOf(const TrafficBatch& batch, double reach);

/// Lane points that are candidate positions of the ego at the crash, of all clips in one list,
/// sorted by clip.
struct PublishedAnchors {
  torch::Tensor place;   ///< [N, 2] m, position
  torch::Tensor clip;    ///< [N] index of the clip in the batch
  torch::Tensor piece;   ///< [N] index of the piece in PublishedPieces
  torch::Tensor point;   ///< [N] index of the point in the piece
  torch::Tensor column;  ///< [N] index of the anchor among the anchors of its clip, from 0
  long most = 0;         ///< maximum number of anchors of a clip, at least 1

  /// Returns `numbers` [N, ...], values of the anchors, arranged as [B, most, ...], each at row
  /// `clip` and column `column`, padded with `none`. `clips`: B.
  torch::Tensor inRows(const torch::Tensor& numbers, long clips, double none) const;
};

/// Returns all points of the pieces as anchors, without the last point of a full piece, which is
/// the first of the next piece. `clips`: number of clips B.
PublishedAnchors anchorsOf(const PublishedPieces& pieces, long clips);

struct PublishedBlock;
struct PublishedSubGraph;

/// The modules of the published network (arXiv 2510.12206, Sec. 3). Features without a unit are
/// learned.
struct PublishedPatterns : torch::nn::Module {
  /// Creates the layers with random weights from libtorch's generator.
  PublishedPatterns(const PublishedNetworkOptions& options, const TrafficOptions& traffic);

  /// Registers the layers of the anchors; called by the constructor.
  void addAnchorLayers();
  /// Returns vectors [N, V, 7] of polylines from positions `at` and `steps` [N, V, 2] (m; scaled by
  /// the reach of lanes and the spacing of lane points) and the attributes [N, V] `yaw` (rad),
  /// `frame` (0..1 over the history) and `intersection` (1 or 0).
  torch::Tensor vectorsOf(const torch::Tensor& at, const torch::Tensor& steps,
                          const torch::Tensor& yaw, const torch::Tensor& frame,
                          const torch::Tensor& intersection) const;
  /// Returns the features [N, width + 2] of polylines given by vectorsOf(), the last two being the
  /// minimum of the scaled x and y.
  torch::Tensor polylinesOf(const torch::Tensor& vectors);
  /// Returns the features of the egos' histories [B, width + 2].
  torch::Tensor egoPolylines(const TrafficBatch& batch);
  /// Returns the features of the lane pieces [N, width + 2].
  torch::Tensor lanePolylines(const PublishedPieces& pieces);
  /// Returns the output of the global graph [B, 1 + L, width]: self-attention over ego (row 0) and
  /// lanes (rows PublishedPieces::polyline).
  torch::Tensor graphOf(const TrafficBatch& batch, const PublishedPieces& pieces);
  /// Returns the paper's F_final [B, width], the joint feature of scene, type and time. `ego`: row
  /// 0 of graphOf() [B, width]; `condition`: TrafficBatch::condition.
  torch::Tensor joined(const torch::Tensor& ego, const torch::Tensor& condition);
  /// Returns the features [N, width] of the anchors' positions.
  torch::Tensor placesOf(const PublishedAnchors& anchors);
  /// Returns the logits [N] of the anchors. `polylines` and `seen` [pieces, width] are the features
  /// (graphOf()) and the F_final of the clip of each element of PublishedPieces.
  torch::Tensor scores(const PublishedAnchors& anchors, const torch::Tensor& polylines,
                       const torch::Tensor& seen);
  /// Returns the predicted offsets [N, 2] (m) from anchors to the ego at the crash. `places`:
  /// positions of the anchors [N, 2], m; `seen`: F_final of each anchor's clip [N, width].
  torch::Tensor anchorOffsets(const torch::Tensor& places, const torch::Tensor& seen);
  // The following predict from `seen`, F_final [B, width].
  /// Returns the ego's yaw [B] at the crash, rad, in the frame of the ego at t0.
  torch::Tensor egoYawOf(const torch::Tensor& seen);
  /// Returns the attacker's position [B, 2] at the crash in the frame of the ego's box, m.
  torch::Tensor offsetOf(const torch::Tensor& seen);
  /// Returns the angle [B] between the attacker's and the ego's yaw at the crash, rad, without
  /// sign.
  torch::Tensor attackerYawOf(const torch::Tensor& seen);
  /// Returns the logits [B, A] of the choice of the attacker; kAbsentLogit for the ego and for
  /// agents not observed at t0.
  torch::Tensor selection(const TrafficBatch& batch, const torch::Tensor& seen);

  PublishedNetworkOptions options;  ///< of the constructor
  TrafficOptions traffic;           ///< of the constructor
  // The layers. A number at the end gives the order in which the layers of a head are applied.
  std::shared_ptr<PublishedSubGraph> subgraph;  ///< VectorNet's polyline subgraph, polylinesOf()
  /// Residual blocks of egoYawOf(), selection(), placesOf(), scores() and anchorOffsets().
  std::shared_ptr<PublishedBlock> ego_yaw_1, selector_2, anchor_4, score_1, shift_1;
  /// Self-attention of graphOf().
  torch::nn::Linear query{nullptr}, key{nullptr}, value{nullptr};
  /// joined(): features of the type and of the time, and the layers that join them with the ego.
  torch::nn::Linear type_1{nullptr}, type_2{nullptr}, time{nullptr}, join_1{nullptr},
      join_2{nullptr};
  /// egoYawOf(), offsetOf() and attackerYawOf().
  torch::nn::Linear ego_yaw_2{nullptr}, offset{nullptr}, attacker_yaw{nullptr};
  /// selection().
  torch::nn::Linear selector_1{nullptr}, selector_3{nullptr};
  /// placesOf().
  torch::nn::Linear anchor_1{nullptr}, anchor_2{nullptr}, anchor_3{nullptr}, anchor_5{nullptr};
  /// placesOf(), after the layers of the same numbers.
  torch::nn::LayerNorm anchor_norm_1{nullptr}, anchor_norm_2{nullptr}, anchor_norm_3{nullptr};
  /// scores(): layer on F_final and last layer; anchorOffsets(): last layer.
  torch::nn::Linear scene{nullptr}, score_2{nullptr}, shift_2{nullptr};
  torch::nn::Dropout dropout{nullptr};  ///< before the last layer of each head but scores()
};

}  // namespace forge
