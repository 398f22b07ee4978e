#pragma once

#include <string>
#include <vector>

namespace forge {

class Section;

// What a model may be made with, in config/ and in a file of weights alike.
inline constexpr int kMaxModelWidth = 1024;   ///< of a layer
inline constexpr int kMaxModelCount = 256;    ///< of frames, agents, lanes, points, layers, samples
inline constexpr int kMaxModelSteps = 10000;  ///< of a search, of diffusion

/// config/study/generators.yaml, section lanes, where each number's unit stands.
struct TrafficLaneOptions {
  double reach = 0.0;
  int max_lanes = 0;  ///< 0: a model that sees none
  int points = 0;
  double spacing = 0.0;
};

/// config/study/generators.yaml, section traffic, where each number's unit stands.
struct TrafficOptions {
  int history_frames = 0;  ///< of PredictionOptions; the last one is now
  int future_frames = 0;
  int max_agents = 0;
  double min_motion = 0.0;
  double min_step = 0.0;
  TrafficLaneOptions lanes;
};

/// config/study/generators.yaml, section c_sgan, where the unit and source of each of its keys
/// stand; "there" is Social-GAN (Gupta et al. 2018), scripts/run_traj.sh.
struct SocialGanOptions {
  int epochs = 0;
  int batch = 0;
  double learning_rate = 0.0;
  double max_gradient = 1.5;  ///< norm, of the generator
  int embedding = 0;
  int encoder = 0;
  int decoder = 0;
  int pooled = 0;
  int pooling_layer = 0;
  int context_layer = 0;
  int noise = 0;
  int discriminator = 0;
  int discriminator_steps = 2;  ///< for one of the generator
  int variety = 10;             ///< samples, of which the best one of a scene counts
  double step_scale = 0.0;
  double position_scale = 0.0;
};

/// config/study/generators.yaml, section c_mid, where the unit and source of each of its keys
/// stand; "there" is MID (Gu et al. 2022), configs/baseline.yaml.
struct MidOptions {
  int epochs = 0;
  int batch = 0;
  double learning_rate = 0.0;
  double attacker_weight = 3.0;  ///< of the attacker's error, as 1 of anybody else's; 1 there
  int encoder = 0;
  double encoder_dropout = 0.25;
  int width = 0;  ///< a multiple of 4 and of `heads`
  int layers = 0;
  int heads = 0;
  int feed_forward = 0;
  double dropout = 0.1;
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

/// config/study/generators.yaml, section c_strive, where the unit and source of each of its keys
/// stand; "there" is STRIVE (Rempe et al. 2022), configs/train_traffic.cfg.
struct StriveOptions {
  int epochs = 0;
  int batch = 0;
  double learning_rate = 0.0;
  double max_gradient = 1.0;  ///< norm; none there
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
  double noise = 0.01;           ///< of the scaled past in training
  double attacker_weight = 3.0;  ///< of its reconstruction; 1 there
  double divergence_weight = 0.004;
  int divergence_steps = 6000;  ///< in which this weight rises from 0; 20 epochs there
  double overlap_weight = 0.05;
  double off_lanes_weight = 0.1;
};

/// STRIVE's search in the latent space (configs/adv_gen_*.cfg), for the method strive_optimised.
struct StriveAttackOptions {
  int iterations = 200;  ///< at most
  int hold = 10;         ///< iterations with the crash that end the search; none do there
  int window = 1;        ///< frames before the time asked for in which the crash may be
  double learning_rate = 0.05;
  double temperature = 1.0;  ///< m, of the nearest frame
  double crash_weight = 2.0;
  double heading_weight = 5.0;  ///< of the relative heading of the type; none there
  double prior_weight = 1.0;    ///< of all but the attacker
  double attacker_prior_weight = 0.005;
  double stay_weight = 0.5;  ///< of all but the attacker
  double attacker_stay_weight = 0.05;
  double overlap_weight = 20.0;    ///< of all but the ego
  double off_lanes_weight = 20.0;  ///< of all but the ego
};

/// config/study/network_published.yaml, section network, where the unit and source of each of its
/// keys stand; "there" is the code released with arXiv 2510.12206.
struct PublishedNetworkOptions {
  int epochs = 0;
  int batch = 0;
  double learning_rate = 0.0;
  int decay_from = 0;
  int decay_every = 0;
  double decay = 0.75;   ///< the rate's factor each time, as there
  double dropout = 0.1;  ///< before the last layers of the heads
  int width = 0;
  int condition = 0;
  int selector = 0;
  int anchor_1 = 0;
  int anchor_2 = 0;
  int anchor_3 = 0;
  double anchor_scale = 0.0;
  double place_scale = 0.0;
  double positive_radius = 0.0;
  double positive_weight = 28.0;  ///< of a positive anchor, one of another counts 1; 27 to 29 there
  // Weights of the losses, each summed over a clip, then averaged over a batch.
  double anchors_loss = 0.02;       ///< 0.001 there, of a loss whose logit was a probability
  double anchor_offset_loss = 0.1;  ///< 0.008 there, over all anchors; here over the positive ones
  double target_points_loss = 1.0;  ///< not published
  double regression_loss = 0.4;     ///< not published
  double ego_yaw_loss = 10.0;       ///< as there, like all below
  double attacker_offset_loss = 0.4;
  double attacker_yaw_loss = 20.0;
  double selection_loss = 1.0;
};

/// config/study/generators.yaml, a member a section, or network_published.yaml, which has the last
/// one. What a model was made with is kept in its weights.
struct GeneratorOptions {
  TrafficOptions traffic;
  double validation_share = 0.1;  ///< of the scenes, to find the best epoch
  SocialGanOptions c_sgan;
  MidOptions c_mid;
  StriveOptions c_strive;
  StriveAttackOptions strive_optimised;
  PublishedNetworkOptions published_network;
};

/// The models that there are: "c_sgan", "c_mid", "c_strive" and "published_network" with each head.
std::vector<std::string> trafficModelNames();

/// True for the models that read `published_network` of GeneratorOptions.
bool isPublishedNetwork(const std::string& model);

/// The file of config/ that a model's numbers stand in.
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
