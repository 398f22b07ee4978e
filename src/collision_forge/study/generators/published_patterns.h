#pragma once

#include <memory>

#include "collision_forge/study/generators/published_head.h"
#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

inline constexpr int kConditionTypes = kConditionNumbers - 1;
inline constexpr double kAbsentLogit = -1e9;  ///< of what is not there

/// The pieces of lanes near the egos of a batch, all clips' in one list.
struct PublishedPieces {
  torch::Tensor points;    ///< [N, P, kLaneNumbers]
  torch::Tensor seen;      ///< [N, P]
  torch::Tensor clip;      ///< [N] whose
  torch::Tensor polyline;  ///< [N] from 1 on within the clip; 0 is the ego
};

/// Those that have a point within `reach` of the ego, wherever its attacker is.
PublishedPieces piecesOf(const TrafficBatch& batch, double reach);

/// Points of lanes where the ego may be at the crash, all clips' in one list, in order of the clip.
struct PublishedAnchors {
  torch::Tensor place;   ///< [N, 2] m
  torch::Tensor clip;    ///< [N] whose
  torch::Tensor piece;   ///< [N] of PublishedPieces
  torch::Tensor point;   ///< [N] of the piece
  torch::Tensor column;  ///< [N] from 0 on within the clip
  long most = 0;         ///< of one clip, 1 at least

  /// Numbers [N, ...] of each as [B, most, ...], `none` where there is no anchor.
  torch::Tensor inRows(const torch::Tensor& numbers, long clips, double none) const;
};

/// All points but the last one of a full piece, which is the first of the next.
PublishedAnchors anchorsOf(const PublishedPieces& pieces, long clips);

struct PublishedBlock;
struct PublishedSubGraph;

/// The parts of the published network.
struct PublishedPatterns : torch::nn::Module {
  PublishedPatterns(PublishedHead head, const PublishedNetworkOptions& options,
                    const TrafficOptions& traffic);

  /// What the two heads with anchors have beside.
  void addAnchorLayers();
  /// [N, V, kVectorNumbers]: where each step is and how long, [N, V, 2], and what else is told.
  torch::Tensor vectorsOf(const torch::Tensor& at, const torch::Tensor& steps,
                          const torch::Tensor& yaw, const torch::Tensor& frame,
                          const torch::Tensor& intersection) const;
  /// [N, width + 2] with the least x and y of each.
  torch::Tensor polylinesOf(const torch::Tensor& vectors);
  torch::Tensor egoPolylines(const TrafficBatch& batch);
  torch::Tensor lanePolylines(const PublishedPieces& pieces);
  /// The global graph: [B, 1 + L, width], the ego and its lanes, each with what it sees in all.
  torch::Tensor graphOf(const TrafficBatch& batch, const PublishedPieces& pieces);
  /// The paper's F_final [B, width]: scene, type and time, for all heads.
  torch::Tensor joined(const torch::Tensor& ego, const torch::Tensor& condition);
  /// [N, width] of what an anchor's place says.
  torch::Tensor placesOf(const PublishedAnchors& anchors);
  /// [N] logits of anchors. Of each piece that they lie on `polylines` and its clip's F_final
  /// `seen`, [pieces, width].
  torch::Tensor scores(const PublishedAnchors& anchors, const torch::Tensor& polylines,
                       const torch::Tensor& seen);
  /// [N, 2] m from places to where the ego is rather; `seen` F_final of each.
  torch::Tensor shifts(const torch::Tensor& places, const torch::Tensor& seen);
  /// [B, 2] m, without a lane.
  torch::Tensor regressed(const torch::Tensor& seen);
  /// [B] rad.
  torch::Tensor egoYawOf(const torch::Tensor& seen);
  /// [B, 2] m, of the attacker in the frame of the ego's box.
  torch::Tensor offsetOf(const torch::Tensor& seen);
  /// [B] rad, to the ego's yaw, to whichever side.
  torch::Tensor attackerYawOf(const torch::Tensor& seen);
  /// [B, A] logits.
  torch::Tensor selection(const TrafficBatch& batch, const torch::Tensor& seen);

  PublishedHead head;
  PublishedNetworkOptions options;
  TrafficOptions traffic;
  std::shared_ptr<PublishedSubGraph> subgraph;
  std::shared_ptr<PublishedBlock> ego_yaw_1, selector_2, place_1, anchor_4, score_1, shift_1;
  torch::nn::Linear query{nullptr}, key{nullptr}, value{nullptr};
  torch::nn::Linear type_1{nullptr}, type_2{nullptr}, time{nullptr}, join_1{nullptr},
      join_2{nullptr};
  torch::nn::Linear ego_yaw_2{nullptr}, offset{nullptr}, attacker_yaw{nullptr}, place_2{nullptr};
  torch::nn::Linear selector_1{nullptr}, selector_3{nullptr};
  torch::nn::Linear anchor_1{nullptr}, anchor_2{nullptr}, anchor_3{nullptr}, anchor_5{nullptr};
  torch::nn::LayerNorm anchor_norm_1{nullptr}, anchor_norm_2{nullptr}, anchor_norm_3{nullptr};
  torch::nn::Linear scene{nullptr}, score_2{nullptr}, shift_2{nullptr};
  torch::nn::Dropout dropout{nullptr};
};

}  // namespace forge
