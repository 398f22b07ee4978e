#pragma once

#include <string>

namespace forge {

class Section;

// Bounds of network options, in config/ and in files of weights. Within them the features need
// little memory and anchor positions are exact enough in 4-byte floats.
inline constexpr int kMaxFeatureCount = 256;       ///< most agents, lanes, points, paths or anchors
inline constexpr int kMinPolylinePoints = 2;       ///< smallest lane_points and target_points
inline constexpr int kMinWayAnchors = 3;           ///< smallest way_anchors
inline constexpr int kMaxLayerWidth = 4096;        ///< largest width in PatternNetworkOptions
inline constexpr double kMinFeatureNumber = 1e-3;  ///< smallest length (m), spacing and exponent
inline constexpr double kMaxFeatureLength = 1000.0;  ///< m; largest radius and spacing
inline constexpr double kMaxSpacingExponent = 4.0;   ///< largest spacing_exponent

/// Lanes as network input, config/encoding.yaml.
struct EncodingOptions {
  double lane_radius = 0.0;  ///< m around the ego's box centre at t0 within which lanes are encoded
  int max_lanes = 0;         ///< most lanes, nearest first
  int lane_points = 0;       ///< most points per lane, from its start
  double lane_point_spacing = 0.0;  ///< m between points
};

/// How the network predicts the ego's pose at impact: kRegionProposal by anchors along its
/// candidate paths, kTargetPoints by points along nearby centrelines, kRegression by one regression
/// relative to driving straight on.
enum class EgoHead { kRegionProposal, kTargetPoints, kRegression };
/// Returns the name in training.yaml: "region_proposal", "target_points" or "regression".
const char* toString(EgoHead head);
/// Returns the head of a name as toString() spells it. Throws std::invalid_argument for another
/// name.
EgoHead egoHeadFromString(const std::string& name);

/// config/study/training.yaml, section features. Stored with the weights.
struct PatternFeatureOptions {
  EgoHead head = EgoHead::kRegionProposal;
  int history_frames = 0;  ///< frames of the ego; PredictionOptions::history_frames at training
  int agent_frames = 0;    ///< newest frames of other agents, at most history_frames
  int max_agents = 0;      ///< most other agents, nearest to the ego first
  EncodingOptions encoding;
  int max_ways = 0;     ///< most candidate paths of the ego, most probable first
  int way_anchors = 0;  ///< anchors per path, plus one that stands
  /// m; spacing of anchors on a path = spacing_floor + spacing_rate * TTA^spacing_exponent (TTA in
  /// s)
  double spacing_floor = 0.0;
  double spacing_rate = 0.0;      ///< m/s^exponent
  double spacing_exponent = 0.0;  ///< without unit
  /// most lanes, nearest first; the head kTargetPoints alone uses the target_ options
  int target_lanes = 0;
  int target_points = 0;        ///< most points per lane
  double target_spacing = 0.0;  ///< m, least distance between points
};

/// config/study/training.yaml, section network: layer widths. Stored with the weights.
struct PatternNetworkOptions {
  int hidden = 0;  ///< width per encoded polyline (an agent's past or a lane)
  int scene = 0;   ///< width of an encoded scene
  int anchor = 0;  ///< width per encoded anchor or candidate
};

// Read the struct from its section. Throw ConfigError for a missing key or a value out of range.
/// `history_frames`: PredictionOptions::history_frames.
void readOptions(Section& section, PatternFeatureOptions& options, int history_frames);
void readOptions(Section& section, PatternNetworkOptions& options);
void readOptions(Section& section, EncodingOptions& options);

}  // namespace forge
