#pragma once

#include <string>
#include <vector>

namespace forge {

class Section;

// Upper limits of the sizes of models, in config/ and in weight files.
inline constexpr int kMaxModelWidth = 1024;   ///< width of a layer
inline constexpr int kMaxModelCount = 256;    ///< frames, agents, lanes, points, layers, samples
inline constexpr int kMaxModelSteps = 10000;  ///< steps of a search or a diffusion

/// config/study/generators.yaml, section lanes: the lane input of a model.
struct TrafficLaneOptions {
  double reach = 0.0;    ///< m around ego and attacker at t0 within which lanes are used
  int max_lanes = 0;     ///< maximum number of lane pieces; 0: the model ignores lanes
  int points = 0;        ///< points per piece
  double spacing = 0.0;  ///< m between points
};

/// config/study/generators.yaml, section traffic: the agent input of a model, at 2 Hz.
struct TrafficOptions {
  int history_frames = 0;   ///< PredictionOptions::history_frames; the last frame is t0
  int future_frames = 0;    ///< frames per prediction, from the one after t0 on
  int max_agents = 0;       ///< largest number of agents, including ego and attacker
  double min_motion = 0.0;  ///< m from the first to the last observed frame of the history; other
                            ///< agents that moved less are omitted
  /// m per frame; models that predict positions keep the heading with shorter steps.
  double min_step = 0.0;
  TrafficLaneOptions lanes;  ///< section lanes
};

/// config/study/generators.yaml, section c_sgan. "Original": Social-GAN (Gupta et al. 2018),
/// scripts/run_traj.sh.
struct SocialGanOptions {
  int epochs = 0;               ///< passes over the training data
  int batch = 0;                ///< windows per step
  double learning_rate = 0.0;   ///< of the optimizers
  double max_gradient = 1.5;    ///< norm to which larger gradients are clipped, generator only
  int embedding = 0;            ///< width of an embedded step or relative position
  int encoder = 0;              ///< width of the LSTM over the history
  int decoder = 0;              ///< width of the LSTM over the future
  int pooled = 0;               ///< width of the pooled feature of the other agents
  int pooling_layer = 0;        ///< width of the hidden layer before pooling
  int context_layer = 0;        ///< width of the hidden layer that joins history and pooled feature
  int noise = 0;                ///< numbers of noise in the decoder's first state, below `decoder`
  int discriminator = 0;        ///< width of the discriminator's layers
  int discriminator_steps = 2;  ///< steps of the discriminator per step of the generator
  int variety = 10;             ///< samples per scene; only the best one enters the loss
  double step_scale = 0.0;      ///< m, unit of steps
  double position_scale = 0.0;  ///< m, unit of positions
};

/// config/study/generators.yaml, section c_mid. "Original": MID (Gu et al. 2022),
/// configs/baseline.yaml.
struct MidOptions {
  int epochs = 0;                 ///< passes over the training data
  int batch = 0;                  ///< windows per step
  double learning_rate = 0.0;     ///< of the optimizer
  double attacker_weight = 3.0;   ///< loss weight of the attacker; others have 1; original 1
  int encoder = 0;                ///< width of the encoded history
  double encoder_dropout = 0.25;  ///< probability 0..1, of the encoded history
  int width = 0;            ///< width of a token of the transformer, a multiple of 4 and of `heads`
  int layers = 0;           ///< number of layers of the transformer
  int heads = 0;            ///< number of attention heads
  int feed_forward = 0;     ///< width of the transformer's feed-forward layers
  double dropout = 0.1;     ///< probability 0..1, in the transformer
  int diffusion_steps = 0;  ///< number of noise levels in training
  double beta_first = 0.0;  ///< noise variance of the first step
  double beta_last = 0.0;   ///< noise variance of the last step
  int sampling_steps = 0;   ///< denoising steps at inference, a divisor of `diffusion_steps`
  double neighbour_reach = 0.0;     ///< m; agents within this distance are neighbours
  double position_scale = 0.0;      ///< m, unit of positions
  double velocity_scale = 0.0;      ///< m/s, unit of velocities
  double acceleration_scale = 0.0;  ///< m/s^2, unit of accelerations
  double target_scale = 0.0;        ///< m/s, unit of the diffused velocity change
};

/// config/study/generators.yaml, section c_strive. "Original": STRIVE (Rempe et al. 2022),
/// configs/train_traffic.cfg.
struct StriveOptions {
  int epochs = 0;               ///< passes over the training data
  int batch = 0;                ///< windows per step
  double learning_rate = 0.0;   ///< of the optimizer
  double max_gradient = 1.0;    ///< norm to which larger gradients are clipped; original: no limit
  int hidden = 0;               ///< layer width
  int feature = 0;              ///< width of the features of past, future and map
  int latent = 0;               ///< latent numbers per agent
  int lane_hidden = 0;          ///< layer width of the lane encoder
  int lanes_of_agent = 0;       ///< lane pieces per agent, nearest to a point ahead of it
  double map_ahead = 0.0;       ///< m from the agent to that point
  double lane_reach = 0.0;      ///< m from a lane's centre line beyond which an agent is off lanes
  double length = 0.0;          ///< m, of all agents
  double width = 0.0;           ///< m, of all agents
  double position_scale = 0.0;  ///< m, unit of positions
  double speed_mean = 0.0;      ///< m/s, subtracted from speeds
  double speed_scale = 0.0;     ///< m/s, unit of speeds about the mean
  double turn_scale = 0.0;      ///< rad/s, unit of turn, StriveScene::turn
  double acceleration_scale = 0.0;  ///< m/s^2, unit of the decoder's acceleration
  double turn_change_scale = 0.0;   ///< rad/s^2, unit of the decoder's change of turn
  double noise = 0.01;  ///< standard deviation of the noise added to the scaled past in training
  double attacker_weight = 3.0;      ///< reconstruction weight of the attacker; original 1
  double divergence_weight = 0.004;  ///< loss weight of the divergence of posterior and prior
  int divergence_steps = 6000;    ///< steps in which that weight rises from 0; original 20 epochs
  double overlap_weight = 0.05;   ///< loss weight of overlapOf()
  double off_lanes_weight = 0.1;  ///< loss weight of beyondLanes()
};

/// config/study/network_published.yaml, section network. "Original": the code released with arXiv
/// 2510.12206.
struct PublishedNetworkOptions {
  int epochs = 0;                 ///< passes over the training data
  int batch = 0;                  ///< clips per step
  double learning_rate = 0.0;     ///< of the optimizer, before decays
  int decay_from = 0;             ///< steps before the first decay of the learning rate
  int decay_every = 0;            ///< steps between decays
  double decay = 0.75;            ///< factor of a decay, original value
  double dropout = 0.1;           ///< probability 0..1, before the last layers of the heads
  int width = 0;                  ///< width of most features and layers
  int condition = 0;              ///< width of the features of type and of time
  int selector = 0;               ///< width of the feature of an agent's position
  int anchor_1 = 0;               ///< width of the first layer on an anchor's position
  int anchor_2 = 0;               ///< width of the second layer
  int anchor_3 = 0;               ///< width of the third layer
  double anchor_scale = 0.0;      ///< m, unit of anchor positions
  double positive_radius = 0.0;   ///< m around the ego at the crash; anchors within it are positive
  double positive_weight = 28.0;  ///< loss weight of positive anchors, others 1; original 27 to 29
  // Weights of the losses, each summed over a clip, then averaged over a batch.
  /// scores of the anchors; original 0.001, for a loss with probabilities as logits.
  double anchors_loss = 0.02;
  /// Offsets to the ego, over positive anchors; original 0.008 over all anchors.
  double anchor_offset_loss = 0.1;
  double ego_yaw_loss = 10.0;         ///< ego's yaw; this and all below: original values
  double attacker_offset_loss = 0.4;  ///< attacker's position in the frame of the ego's box
  double attacker_yaw_loss = 20.0;    ///< |attacker's yaw - ego's yaw|
  double selection_loss = 1.0;        ///< choice of the attacker
};

/// config/study/generators.yaml, one member per section, or network_published.yaml, which has the
/// last one. Weight files store the values that their model was made with.
struct GeneratorOptions {
  TrafficOptions traffic;         ///< sections traffic and lanes
  double validation_share = 0.1;  ///< share 0..1 of the scenes for the choice of the best epoch
  SocialGanOptions c_sgan;        ///< section c_sgan
  MidOptions c_mid;               ///< section c_mid
  StriveOptions c_strive;         ///< section c_strive
  PublishedNetworkOptions published_network;  ///< section network of network_published.yaml
};

/// Returns the names of all models: "c_sgan", "c_mid", "c_strive" and "published_network".
std::vector<std::string> trafficModelNames();

/// Returns true for "published_network", the model that uses GeneratorOptions::published_network.
bool isPublishedNetwork(const std::string& model);

/// Returns the path of the configuration file of a model, relative to config/
/// ("study/generators.yaml").
std::string configFileOf(const std::string& model);

/// Returns the names of the sections of configFileOf() that a model needs, in the order of reading;
/// "traffic" is the first.
std::vector<std::string> sectionsOf(const std::string& model);

/// Returns the names of all sections of generators.yaml.
std::vector<std::string> sectionsOfGenerators();

/// Reads the given sections of a file, which must have no others, except for sections of earlier
/// versions. `history_frames`: PredictionOptions::history_frames. Throws ConfigError.
void readOptions(Section& file, GeneratorOptions& options, const std::vector<std::string>& sections,
                 int history_frames);

}  // namespace forge
