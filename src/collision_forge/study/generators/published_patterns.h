#pragma once

#include <memory>

#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

inline constexpr int kConditionTypes = kConditionNumbers - 1;  ///< numbers of the one-hot type
inline constexpr double kAbsentLogit = -1e9;                   ///< logit of padding

/// The lane pieces near the egos of a batch, of all clips in one list.
struct PublishedPieces {
  torch::Tensor points;    ///< [N, P, kLaneNumbers]
  torch::Tensor seen;      ///< [N, P] 1 for a point, 0 for padding
  torch::Tensor clip;      ///< [N] index of the clip
  torch::Tensor polyline;  ///< [N] index within the clip, from 1; 0 is the ego
};

/// Returns the pieces with a point within `reach` (m) of the ego at t0.
PublishedPieces piecesOf(const TrafficBatch& batch, double reach);

/// Lane points that are candidate positions of the ego at the crash, of all clips in one list,
/// sorted by clip.
struct PublishedAnchors {
  torch::Tensor place;   ///< [N, 2] m
  torch::Tensor clip;    ///< [N] index of the clip
  torch::Tensor piece;   ///< [N] index in PublishedPieces
  torch::Tensor point;   ///< [N] index in the piece
  torch::Tensor column;  ///< [N] index within the clip, from 0
  long most = 0;         ///< maximum number of anchors of a clip, at least 1

  /// Arranges values [N, ...] of the anchors as [B, most, ...], padded with `none`.
  torch::Tensor inRows(const torch::Tensor& numbers, long clips, double none) const;
};

/// Returns all points of the pieces, without the last point of a full piece, which is the first of
/// the next piece. `clips`: number of clips B.
PublishedAnchors anchorsOf(const PublishedPieces& pieces, long clips);

struct PublishedBlock;
struct PublishedSubGraph;

/// The modules of the published network.
struct PublishedPatterns : torch::nn::Module {
  PublishedPatterns(const PublishedNetworkOptions& options, const TrafficOptions& traffic);

  /// Registers the layers of the anchors.
  void addAnchorLayers();
  /// Returns vectors [N, V, kVectorNumbers] from positions `at` and `steps` [N, V, 2] and
  /// attributes.
  torch::Tensor vectorsOf(const torch::Tensor& at, const torch::Tensor& steps,
                          const torch::Tensor& yaw, const torch::Tensor& frame,
                          const torch::Tensor& intersection) const;
  /// Returns polyline features [N, width + 2], with the minimum x and y of each polyline.
  torch::Tensor polylinesOf(const torch::Tensor& vectors);
  /// Returns the features of the egos' histories [B, width + 2].
  torch::Tensor egoPolylines(const TrafficBatch& batch);
  /// Returns the features of the lane pieces [N, width + 2].
  torch::Tensor lanePolylines(const PublishedPieces& pieces);
  /// Returns the output of the global graph [B, 1 + L, width]: self-attention over ego and lanes.
  torch::Tensor graphOf(const TrafficBatch& batch, const PublishedPieces& pieces);
  /// Returns the paper's F_final [B, width], the joint feature of scene, type and time.
  torch::Tensor joined(const torch::Tensor& ego, const torch::Tensor& condition);
  /// Returns the features [N, width] of the anchors' positions.
  torch::Tensor placesOf(const PublishedAnchors& anchors);
  /// Returns the logits [N] of the anchors. `polylines` and `seen` [pieces, width] are the features
  /// of their pieces and the F_final of their clips.
  torch::Tensor scores(const PublishedAnchors& anchors, const torch::Tensor& polylines,
                       const torch::Tensor& seen);
  /// Returns the offsets [N, 2] (m) from anchors to the ego. `places`: placesOf(); `seen`: F_final
  /// of each anchor's clip.
  torch::Tensor shifts(const torch::Tensor& places, const torch::Tensor& seen);
  /// Returns the ego's yaw [B] at the crash, rad.
  torch::Tensor egoYawOf(const torch::Tensor& seen);
  /// Returns the attacker's position [B, 2] in the frame of the ego's box, m.
  torch::Tensor offsetOf(const torch::Tensor& seen);
  /// Returns the angle [B] between the attacker's and the ego's yaw, rad, without sign.
  torch::Tensor attackerYawOf(const torch::Tensor& seen);
  /// Returns the logits [B, A] of the choice of the attacker.
  torch::Tensor selection(const TrafficBatch& batch, const torch::Tensor& seen);

  PublishedNetworkOptions options;
  TrafficOptions traffic;
  std::shared_ptr<PublishedSubGraph> subgraph;
  std::shared_ptr<PublishedBlock> ego_yaw_1, selector_2, anchor_4, score_1, shift_1;
  torch::nn::Linear query{nullptr}, key{nullptr}, value{nullptr};
  torch::nn::Linear type_1{nullptr}, type_2{nullptr}, time{nullptr}, join_1{nullptr},
      join_2{nullptr};
  torch::nn::Linear ego_yaw_2{nullptr}, offset{nullptr}, attacker_yaw{nullptr};
  torch::nn::Linear selector_1{nullptr}, selector_3{nullptr};
  torch::nn::Linear anchor_1{nullptr}, anchor_2{nullptr}, anchor_3{nullptr}, anchor_5{nullptr};
  torch::nn::LayerNorm anchor_norm_1{nullptr}, anchor_norm_2{nullptr}, anchor_norm_3{nullptr};
  torch::nn::Linear scene{nullptr}, score_2{nullptr}, shift_2{nullptr};
  torch::nn::Dropout dropout{nullptr};
};

}  // namespace forge
