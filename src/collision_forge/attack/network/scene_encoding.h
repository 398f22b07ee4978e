#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// A dense row-major array of any rank.
struct DenseTensor {
  std::vector<std::uint32_t> shape;  ///< length of each dimension, outermost first
  std::vector<float> data;           ///< as many numbers as the product of `shape`
};

/// A snapshot as network input, in the frame of the ego's box at t0 (x forward, y left; m, rad,
/// m/s). Missing entries have mask 0 and value 0, others mask 1.
struct SceneEncoding {
  /// [1 + agents, frames, 8]: x, y, cos yaw, sin yaw, vx, vy, length, width. Row 0 is the ego, then
  /// all agents of the snapshot in its order; the last frame is t0. An entry is missing if the
  /// agent has no state at the frame's time (to 1 us).
  DenseTensor agent_features;
  DenseTensor agent_mask;  ///< [1 + agents, frames]
  /// [lanes, points, 6]: x, y, cos yaw, sin yaw, is_connector, is_intersection (1 or 0); nearest
  /// lane first. `lanes` is the number of lanes found, `points` is EncodingOptions::lane_points.
  DenseTensor lane_features;
  DenseTensor lane_mask;              ///< [lanes, points]
  std::vector<std::string> lane_ids;  ///< [lanes], ids of the rows of lane_features
  std::vector<std::size_t> lanes;     ///< [lanes], the same as indices into LaneMap::lanes
};

/// Encodes the `frames` newest frames of the snapshot (times of ego states; the oldest columns stay
/// empty if there are fewer) and the lanes within options.lane_radius of the ego, at most
/// options.max_lanes, a point every options.lane_point_spacing from the lane's start to at most its
/// end. Throws std::invalid_argument if the snapshot has no ego state at its time (to 1 us).
SceneEncoding encodeScene(const Snapshot& snapshot, const LaneIndex& lanes, int frames,
                          const EncodingOptions& options);

}  // namespace forge
