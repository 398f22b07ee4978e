#pragma once

#include <string>

namespace forge {

class Section;

// What a network may be made with, in config/ and in a file of weights alike. Within these its
// features take little memory, and its anchors are where numbers of 4 bytes reach.
inline constexpr int kMaxFeatureCount = 256;  ///< of agents, lanes, points, ways, anchors
inline constexpr int kMinPolylinePoints = 2;
inline constexpr int kMinWayAnchors = 3;
inline constexpr int kMaxLayerWidth = 4096;
inline constexpr double kMinFeatureNumber = 1e-3;
inline constexpr double kMaxFeatureLength = 1000.0;  ///< m
inline constexpr double kMaxSpacingExponent = 4.0;

/// Lanes as input of a network: config/encoding.yaml, where each number's unit stands.
struct EncodingOptions {
  double lane_radius = 0.0;
  int max_lanes = 0;
  int lane_points = 0;
  double lane_point_spacing = 0.0;
};

/// How the ego's pose at impact is told: by points along the ways that it may take, by points along
/// the centrelines in reach, or by one regression about driving on straight.
enum class EgoHead { kRegionProposal, kTargetPoints, kRegression };
const char* toString(EgoHead head);
/// Throws std::invalid_argument for an unknown name.
EgoHead egoHeadFromString(const std::string& name);

/// config/study/training.yaml, section features, where each number's unit stands. Kept in the
/// weights.
struct PatternFeatureOptions {
  EgoHead head = EgoHead::kRegionProposal;
  int history_frames = 0;  ///< of PredictionOptions, when a network is trained
  int agent_frames = 0;
  int max_agents = 0;
  EncodingOptions encoding;
  int max_ways = 0;
  int way_anchors = 0;
  double spacing_floor = 0.0;
  double spacing_rate = 0.0;
  double spacing_exponent = 0.0;
  int target_lanes = 0;
  int target_points = 0;
  double target_spacing = 0.0;
};

/// config/study/training.yaml, section network. Kept in the weights.
struct PatternNetworkOptions {
  int hidden = 0;
  int scene = 0;
  int anchor = 0;
};

/// `history_frames` are those of PredictionOptions: what is known of the past.
void readOptions(Section& section, PatternFeatureOptions& options, int history_frames);
void readOptions(Section& section, PatternNetworkOptions& options);
void readOptions(Section& section, EncodingOptions& options);

}  // namespace forge
