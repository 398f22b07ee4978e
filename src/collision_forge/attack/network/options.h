#pragma once

#include <string>

namespace forge {

class Section;

// Bounds of network options, in config/ and in files of weights. Within them the features need
// little memory and anchor positions are exact enough in 4-byte floats.
inline constexpr int kMaxFeatureCount = 256;         ///< agents, lanes, points, paths, anchors
inline constexpr int kMinPolylinePoints = 2;         ///< lane_points, target_points
inline constexpr int kMinWayAnchors = 3;             ///< way_anchors
inline constexpr int kMaxLayerWidth = 4096;          ///< PatternNetworkOptions
inline constexpr double kMinFeatureNumber = 1e-3;    ///< least length (m), spacing and exponent
inline constexpr double kMaxFeatureLength = 1000.0;  ///< m; radii and spacings
inline constexpr double kMaxSpacingExponent = 4.0;   ///< spacing_exponent

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
/// Returns the name in training.yaml, for instance "region_proposal".
const char* toString(EgoHead head);
/// Returns the head of a name as toString() spells it. Throws std::invalid_argument for another
/// name.
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
  double spacing_exponent = 0.0;  ///< without unit
  int target_lanes = 0;           ///< lanes, used by the head target_points only
  int target_points = 0;          ///< points per lane
  double target_spacing = 0.0;    ///< m between points, at least
};

/// config/study/training.yaml, section network: layer widths. Stored with the weights.
struct PatternNetworkOptions {
  int hidden = 0;  ///< numbers per encoded polyline (an agent's past or a lane)
  int scene = 0;   ///< numbers per encoded scene
  int anchor = 0;  ///< numbers per encoded anchor or candidate
};

// Read the struct from its section. Throw ConfigError for a missing key or a value out of range.
/// `history_frames`: PredictionOptions::history_frames.
void readOptions(Section& section, PatternFeatureOptions& options, int history_frames);
void readOptions(Section& section, PatternNetworkOptions& options);
void readOptions(Section& section, EncodingOptions& options);

}  // namespace forge
