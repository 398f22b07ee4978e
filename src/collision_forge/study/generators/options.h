#pragma once

#include <string>
#include <vector>

namespace forge {

class Section;

// What a model may be made with, in config/ and in a file of weights alike.
inline constexpr int kMaxModelWidth = 1024;   ///< of a layer
inline constexpr int kMaxModelCount = 256;    ///< of frames, agents, lanes, points, layers, samples
inline constexpr int kMaxModelSteps = 10000;  ///< of a search, of diffusion

/// config/generators.yaml, section lanes, where each number's unit stands.
struct TrafficLaneOptions {
  double reach = 0.0;
  int max_lanes = 0;  ///< 0: a model that sees none
  int points = 0;
  double spacing = 0.0;
};

/// config/generators.yaml, section traffic, where each number's unit stands.
struct TrafficOptions {
  int history_frames = 0;  ///< of PredictionOptions; the last one is now
  int future_frames = 0;
  int max_agents = 0;
  double min_motion = 0.0;
  double min_step = 0.0;
  TrafficLaneOptions lanes;
};

/// config/generators.yaml, section c_sgan, where each number's unit and source stand.
struct SocialGanOptions {
  int epochs = 0;
  int batch = 0;
  double learning_rate = 0.0;
  double max_gradient = 0.0;
  int embedding = 0;
  int encoder = 0;
  int decoder = 0;
  int pooled = 0;
  int pooling_layer = 0;
  int context_layer = 0;
  int noise = 0;
  int discriminator = 0;
  int discriminator_steps = 0;
  int variety = 0;
  double step_scale = 0.0;
  double position_scale = 0.0;
};

/// config/generators.yaml, section c_mid, where each number's unit and source stand.
struct MidOptions {
  int epochs = 0;
  int batch = 0;
  double learning_rate = 0.0;
  double attacker_weight = 0.0;
  int encoder = 0;
  double encoder_dropout = 0.0;
  int width = 0;  ///< a multiple of 4 and of `heads`
  int layers = 0;
  int heads = 0;
  int feed_forward = 0;
  double dropout = 0.0;
  int diffusion_steps = 0;
  double beta_first = 0.0;
  double beta_last = 0.0;
  int sampling_steps = 0;  ///< a divisor of `diffusion_steps`
  double neighbour_reach = 0.0;
  double position_scale = 0.0;
  double velocity_scale = 0.0;
  double acceleration_scale = 0.0;
  double target_scale = 0.0;
};

/// config/generators.yaml, section c_strive, where each number's unit and source stand.
struct StriveOptions {
  int epochs = 0;
  int batch = 0;
  double learning_rate = 0.0;
  double max_gradient = 0.0;
  int hidden = 0;
  int feature = 0;
  int latent = 0;
  int lane_hidden = 0;
  int lanes_of_agent = 0;
  double map_ahead = 0.0;
  double lane_reach = 0.0;
  double length = 0.0;
  double width = 0.0;
  double position_scale = 0.0;
  double speed_mean = 0.0;
  double speed_scale = 0.0;
  double turn_scale = 0.0;
  double acceleration_scale = 0.0;
  double turn_change_scale = 0.0;
  double noise = 0.0;
  double attacker_weight = 0.0;
  double divergence_weight = 0.0;
  int divergence_steps = 0;
  double overlap_weight = 0.0;
  double off_lanes_weight = 0.0;
};

/// config/generators.yaml, section strive_optimised, where each number's unit and source stand.
struct StriveAttackOptions {
  int iterations = 0;
  int hold = 0;
  int window = 0;
  double learning_rate = 0.0;
  double temperature = 0.0;
  double crash_weight = 0.0;
  double heading_weight = 0.0;
  double prior_weight = 0.0;
  double attacker_prior_weight = 0.0;
  double stay_weight = 0.0;
  double attacker_stay_weight = 0.0;
  double overlap_weight = 0.0;
  double off_lanes_weight = 0.0;
};

/// config/network_published.yaml, section network, where each number's unit and source stand.
struct PublishedNetworkOptions {
  int epochs = 0;
  int batch = 0;
  double learning_rate = 0.0;
  int decay_from = 0;
  int decay_every = 0;
  double decay = 0.0;
  double dropout = 0.0;
  int width = 0;
  int condition = 0;
  int selector = 0;
  int anchor_1 = 0;
  int anchor_2 = 0;
  int anchor_3 = 0;
  double anchor_scale = 0.0;
  double place_scale = 0.0;
  double positive_radius = 0.0;
  double positive_weight = 0.0;
  double anchors_loss = 0.0;
  double anchor_offset_loss = 0.0;
  double target_points_loss = 0.0;
  double regression_loss = 0.0;
  double ego_yaw_loss = 0.0;
  double attacker_offset_loss = 0.0;
  double attacker_yaw_loss = 0.0;
  double selection_loss = 0.0;
};

/// config/generators.yaml, a member a section, or network_published.yaml, which has the last one.
/// What a model was made with is kept in its weights.
struct GeneratorOptions {
  TrafficOptions traffic;
  double validation_share = 0.0;
  SocialGanOptions c_sgan;
  MidOptions c_mid;
  StriveOptions c_strive;
  StriveAttackOptions strive_optimised;
  PublishedNetworkOptions published_network;
};

/// The models that there are: "c_sgan", "c_mid", "c_strive" and "published_network" with each head.
std::vector<std::string> trafficModelNames();

/// The file of config/ that a model's numbers stand in, without its ending.
std::string configFileOf(const std::string& model);

/// The mappings of that file that a model needs.
std::vector<std::string> sectionsOf(const std::string& model);

/// All mappings of generators.yaml.
std::vector<std::string> sectionsOfGenerators();

/// Reads these mappings of a file, which has no others. `history_frames` are those of
/// PredictionOptions.
void readOptions(Section& file, GeneratorOptions& options, const std::vector<std::string>& sections,
                 int history_frames);

}  // namespace forge
