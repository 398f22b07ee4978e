#pragma once

#include <string>

namespace forge {

class Section;

// Bounds of network options, in config/ and in files of weights. Within them the features need
// little memory and anchor positions are exact enough in 4-byte floats.
inline constexpr int kMaxFeatureCount = 256;  ///< agents, lanes, points, paths, anchors
inline constexpr int kMinPolylinePoints = 2;
inline constexpr int kMinWayAnchors = 3;
inline constexpr int kMaxLayerWidth = 4096;
inline constexpr double kMinFeatureNumber = 1e-3;
inline constexpr double kMaxFeatureLength = 1000.0;  ///< m
inline constexpr double kMaxSpacingExponent = 4.0;

/// Lanes as network input, config/encoding.yaml.
struct EncodingOptions {
  double lane_radius = 0.0;         ///< m around the ego at t0
  int max_lanes = 0;                ///< nearest first
  int lane_points = 0;              ///< points per lane
  double lane_point_spacing = 0.0;  ///< m
};

/// How the network predicts the ego's pose at impact: by anchors along its candidate paths, by
/// points along nearby centrelines, or by one regression relative to driving straight on.
enum class EgoHead { kRegionProposal, kTargetPoints, kRegression };
const char* toString(EgoHead head);
/// Throws std::invalid_argument if `name` is unknown.
EgoHead egoHeadFromString(const std::string& name);

/// config/study/training.yaml, section features. Stored with the weights.
struct PatternFeatureOptions {
  EgoHead head = EgoHead::kRegionProposal;
  int history_frames = 0;  ///< frames; PredictionOptions at training time
  int agent_frames = 0;    ///< newest frames of other agents
  int max_agents = 0;      ///< nearest to the ego
  EncodingOptions encoding;
  int max_ways = 0;               ///< candidate paths of the ego
  int way_anchors = 0;            ///< anchors per path, plus one that stands
  double spacing_floor = 0.0;     ///< m; anchor spacing = floor + rate * TTA^exponent
  double spacing_rate = 0.0;      ///< m/s^exponent
  double spacing_exponent = 0.0;  ///< 1
  int target_lanes = 0;           ///< lanes, head target_points
  int target_points = 0;          ///< points per lane
  double target_spacing = 0.0;    ///< m between points, at least
};

/// config/study/training.yaml, section network: layer widths. Stored with the weights.
struct PatternNetworkOptions {
  int hidden = 0;  ///< of a polyline
  int scene = 0;   ///< of the scene encoding
  int anchor = 0;  ///< of an anchor and of a candidate
};

/// `history_frames`: PredictionOptions::history_frames.
void readOptions(Section& section, PatternFeatureOptions& options, int history_frames);
void readOptions(Section& section, PatternNetworkOptions& options);
void readOptions(Section& section, EncodingOptions& options);

}  // namespace forge
