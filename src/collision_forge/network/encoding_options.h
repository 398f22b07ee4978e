#pragma once

namespace forge {

/// config/encoding.yaml, where each number's unit stands.
struct EncodingOptions {
  double lane_radius = 0.0;
  int max_lanes = 0;
  int lane_points = 0;
  double lane_point_spacing = 0.0;
};

}  // namespace forge
