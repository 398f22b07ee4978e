#include "network/features.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "attack/ego_sampling.h"
#include "network/scene_encoding.h"

namespace forge {
namespace {

// What features are divided by to be of order one.
constexpr double kPlace = 30.0;                                       // m
constexpr double kSpeed = 10.0;                                       // m/s
constexpr double kAcceleration = 2.0;                                 // m/s2
constexpr double kTurnRate = 0.2;                                     // rad/s
constexpr double kSeconds = 4.0;                                      // s
constexpr double kLongestTta = 9.0;                                   // s
constexpr double kSpeedChange = 3.0;                                  // m/s
constexpr double kMaxChange = 4.0;                                    // times these at most
constexpr double kJunction = 20.0;                                    // m
constexpr double kMaxJunction = 80.0;                                 // m
constexpr double kWayPoints[] = {5.0, 10.0, 20.0, 30.0, 45.0, 60.0};  // m
constexpr double kMinHeadway = 1e-3;
constexpr double kAcrossFloor = 0.3;    // m
constexpr double kAcrossRate = 0.1;     // m/s
constexpr double kWishedGap = 2.0;      // m, as WayAhead::headway has it
constexpr double kWishedTimeGap = 1.2;  // s

double held(double value, double limit) { return std::clamp(value, -limit, limit); }

void requireFinite(const Track& track) {
  for (const AgentState& state : track.states) {
    if (!state.pose.isFinite() || !state.velocity.allFinite() || !std::isfinite(state.time)) {
      throw std::invalid_argument("agent " + track.id +
                                  " has a state with a number that is not finite");
    }
  }
}

/// Rows of the encoding's agents: the ego, then those seen now, nearest first.
std::vector<std::size_t> nearestAgents(const Snapshot& observed, int count) {
  const Vector2 ego = observed.ego.states.back().pose.position();
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t i = 0; i < observed.agents.size(); ++i) {
    const Track& agent = observed.agents[i];
    if (!newestAt(agent, observed.now)) continue;
    near.emplace_back((agent.states.back().pose.position() - ego).norm(), i + 1);
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  near.resize(std::min(near.size(), static_cast<std::size_t>(count)));
  std::vector<std::size_t> rows = {0};
  for (const auto& entry : near) rows.push_back(entry.second);
  return rows;
}

void takeAgents(const SceneEncoding& encoding, const std::vector<std::size_t>& rows,
                const PatternFeatureOptions& options, SceneFeatures& features) {
  const int frames = options.history_frames;
  const float scales[6] = {kPlace, kPlace, 1.0F, 1.0F, kSpeed, kSpeed};
  const Eigen::Index width = encoding.agent_features.shape[2];
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int first = i == 0 ? 0 : std::max(frames - options.agent_frames, 0);
    for (int frame = first; frame < frames; ++frame) {
      const auto source = static_cast<Eigen::Index>(rows[i]) * frames + frame;
      const auto target = static_cast<Eigen::Index>(i) * frames + frame;
      if (encoding.agent_mask.data[static_cast<std::size_t>(source)] == 0.0F) continue;
      const float* values = encoding.agent_features.data.data() + source * width;
      for (int j = 0; j < 6; ++j) features.agents(target, j) = values[j] / scales[j];
      features.agents(target, 6) =
          static_cast<float>((frame + 1 - frames) * kProfileStep / kSeconds);
      features.agents(target, 7) = i == 0 ? 1.0F : 0.0F;
      features.agent_mask[target] = 1.0F;
    }
  }
}

void takeLanes(const SceneEncoding& encoding, int points, SceneFeatures& features) {
  const Eigen::Index width = encoding.lane_features.shape[2];
  for (std::size_t cell = 0; cell < encoding.lane_mask.data.size(); ++cell) {
    if (encoding.lane_mask.data[cell] == 0.0F) continue;
    const auto row = static_cast<Eigen::Index>(cell);
    const float* values = encoding.lane_features.data.data() + row * width;
    for (int j = 0; j < 6; ++j) {
      features.lanes(row, j) = j < 2 ? values[j] / static_cast<float>(kPlace) : values[j];
    }
    features.lanes(row, 6) = static_cast<float>(row % points) / static_cast<float>(points);
    features.lane_mask[row] = 1.0F;
  }
}

Eigen::VectorXf egoFeatures(const EgoNow& ego) {
  Eigen::VectorXf features(kEgoFeatures);
  for (int i = 0; i < 5; ++i) {
    features[i] = static_cast<float>(ego.past_speeds[static_cast<std::size_t>(i)] / kSpeed);
  }
  for (int i = 0; i < 3; ++i) {
    const auto newer = static_cast<std::size_t>(i);
    features[5 + i] = static_cast<float>((ego.past_speeds[newer] - ego.past_speeds[newer + 1]) /
                                         kProfileStep / kAcceleration);
  }
  features[8] = static_cast<float>(held(ego.turn_rate / kTurnRate, kMaxChange));
  return features;
}

/// The gap to the vehicle ahead that WayAhead tells, metres; empty when there is none.
std::optional<double> gapAhead(const WayAhead& ahead, double speed) {
  if (ahead.headway < kMinHeadway) return std::nullopt;
  return (kWishedGap + kWishedTimeGap * speed) / ahead.headway;
}

void fillWay(const EgoPath& path, const WayAhead& ahead, const EgoNow& ego,
             Eigen::Ref<Eigen::RowVectorXf> row) {
  const Pose2 start = relativeTo(path.line.poses().front(), ego.state.pose);
  const double junction_start = std::min(path.junction_start, kMaxJunction);
  const double junction_end = std::min(path.junction_end, kMaxJunction);
  const double values[] = {std::log(std::max(path.weight, 1e-6)) / 4.0,
                           path.on_lanes ? 1.0 : 0.0,
                           ahead.turn_rate / kTurnRate,
                           ahead.bend_braking / kAcceleration,
                           ahead.bend_turn,
                           ahead.bend_curvature * 10.0,
                           ahead.headway,
                           ahead.closing * 4.0,
                           start.y / 3.0,
                           start.yaw * 4.0,
                           junction_start / kJunction,
                           junction_end / kJunction,
                           std::isfinite(path.junction_start) ? 1.0 : 0.0,
                           junction_start <= 0.0 ? 1.0 : 0.0,
                           ego.past_speeds[0] / kSpeed};
  Eigen::Index column = 0;
  for (const double value : values) row[column++] = static_cast<float>(value);
  for (const double distance : kWayPoints) {
    const double yaw = path.line.poseAt(start.x + distance, 0.0).yaw;
    row[column++] = static_cast<float>(held(yaw - path.line.poses().front().yaw, kMaxChange));
  }
}

void placeAnchor(const Pose2& ego, const Pose2& pose, Eigen::Index row, AnchorFeatures& features) {
  const Pose2 local = relativeTo(ego, pose);
  features.poses.row(row) << static_cast<float>(local.x), static_cast<float>(local.y),
      static_cast<float>(std::cos(local.yaw)), static_cast<float>(std::sin(local.yaw));
}

/// Largest squared speed times curvature on the first `driven` metres, over what is comfortable.
double bendDemand(const EgoPath& path, double start, double driven, double speed,
                  double comfortable) {
  if (driven < 1.0) return 0.0;
  const double turned =
      path.line.poseAt(start + driven, 0.0).yaw - path.line.poseAt(start, 0.0).yaw;
  return speed * speed * std::abs(turned) / driven / comfortable;
}

void fillAnchor(const EgoWays& ways, std::size_t way, double driven, double place, double tta,
                const EgoFutureOptions& futures, Eigen::Index row, AnchorFeatures& features) {
  const EgoPath& path = ways.paths[way];
  const double speed = ways.ego.past_speeds[0];
  const double mean_speed = driven / tta;
  const double start = relativeTo(path.line.poses().front(), ways.ego.state.pose).x;
  const double gap = gapAhead(ways.ahead[way], std::max(speed, 0.0)).value_or(kMaxJunction);
  const double lead_speed = speed - ways.ahead[way].closing * std::max(gap, kWishedGap);
  const double rest = gap + std::max(lead_speed, 0.0) * tta - driven;
  const double junction = std::min(path.junction_start, kMaxJunction);
  const double values[kAnchorFeatures] = {
      held((mean_speed - speed) / kSpeedChange, kMaxChange),
      mean_speed / kSpeed,
      place,
      driven < 1e-6 ? 1.0 : 0.0,
      held(2.0 * (mean_speed - speed) / tta / kAcceleration, kMaxChange),
      held(rest / kJunction, kMaxChange),
      held((driven - junction) / kJunction, kMaxChange),
      held(std::min(std::abs(driven - junction), 10.0) / 10.0, 1.0),
      held(bendDemand(path, start, driven, mean_speed,
                      futures.paths.comfortable_lateral_acceleration),
           kMaxChange),
      held(driven / kPlace, 2.0 * kMaxChange),
      held(static_cast<double>(features.poses(row, 1)) / kPlace, kMaxChange),
      static_cast<double>(features.poses(row, 3))};
  for (int i = 0; i < kAnchorFeatures; ++i) {
    features.anchors(row, i) = static_cast<float>(values[i]);
  }
}

AnchorFeatures emptyAnchors(int groups, int group_size, double tta,
                            const PatternFeatureOptions& options) {
  AnchorFeatures features;
  features.group_size = group_size;
  features.groups = RowMatrix::Zero(groups, kGroupFeatures);
  features.anchors = RowMatrix::Zero(groups * group_size, kAnchorFeatures);
  features.poses = RowMatrix::Zero(groups * group_size, 4);
  features.prior = Eigen::VectorXf::Constant(groups * group_size, kAbsent);
  features.along_scale = static_cast<float>(
      options.spacing_floor + options.spacing_rate * std::pow(tta, options.spacing_exponent));
  features.across_scale = static_cast<float>(kAcrossFloor + kAcrossRate * tta);
  return features;
}

/// Anchors along the ways: standing still, then evenly about driving on at the present speed.
AnchorFeatures wayAnchors(const EgoWays& ways, double tta, const EgoFutureOptions& futures,
                          const PatternFeatureOptions& options) {
  AnchorFeatures features = emptyAnchors(options.max_ways, options.way_anchors + 1, tta, options);
  features.arc_lengths = Eigen::VectorXf::Zero(features.prior.size());
  const double reached = ways.ego.past_speeds[0] * tta;
  const int middle = options.way_anchors / 2;
  for (std::size_t way = 0; way < ways.paths.size(); ++way) {
    const EgoPath& path = ways.paths[way];
    const auto group = static_cast<Eigen::Index>(way);
    fillWay(path, ways.ahead[way], ways.ego, features.groups.row(group));
    const ReturnToPath line(path.line, ways.ego, 0.0, futures);
    for (int i = 0; i <= options.way_anchors; ++i) {
      const int step = i - 1 - middle;
      const double driven =
          i == 0 ? 0.0 : reached + step * static_cast<double>(features.along_scale);
      if (driven < 0.0) continue;
      const Eigen::Index row = group * features.group_size + i;
      placeAnchor(ways.ego.state.pose, line.poseAfter(driven), row, features);
      const double place = i == 0 ? 0.0 : static_cast<double>(step) / middle;
      fillAnchor(ways, way, driven, place, tta, futures, row, features);
      features.prior[row] = static_cast<float>(std::log(std::max(path.weight, 1e-6)));
      features.arc_lengths[row] = static_cast<float>(driven);
    }
  }
  return features;
}

void fillFreely(const EgoNow& ego, double tta, Eigen::Index row, AnchorFeatures& features) {
  const auto pose = features.poses.row(row);
  const double distance = std::hypot(pose[0], pose[1]);
  features.anchors(row, 0) =
      static_cast<float>(held((distance / tta - ego.past_speeds[0]) / kSpeedChange, kMaxChange));
  features.anchors(row, 1) = static_cast<float>(distance / tta / kSpeed);
  features.anchors(row, 2) = static_cast<float>(held(pose[0] / kPlace, kMaxChange));
  features.anchors(row, 3) = static_cast<float>(held(pose[1] / kPlace, kMaxChange));
  features.anchors(row, 4) = pose[2];
  features.anchors(row, 5) = pose[3];
}

/// Points along the centrelines nearest to where the ego would be.
AnchorFeatures targetPoints(const EgoWays& ways, const LaneIndex& lanes, double tta,
                            const PatternFeatureOptions& options) {
  AnchorFeatures features = emptyAnchors(options.target_lanes, options.target_points, tta, options);
  const Pose2& ego = ways.ego.state.pose;
  const double reached = std::max(ways.ego.past_speeds[0], 0.0) * tta;
  const double reach = reached + options.target_spacing * options.target_points;
  std::vector<std::size_t> near = lanes.lanesWithin(ego.position(), reach);
  near.resize(std::min(near.size(), static_cast<std::size_t>(options.target_lanes)));
  for (std::size_t lane = 0; lane < near.size(); ++lane) {
    const Polyline& line = *lanes.centerline(near[lane]);
    const auto group = static_cast<Eigen::Index>(lane);
    features.groups(group, 0) = lanes.map().lanes[near[lane]].is_connector ? 1.0F : 0.0F;
    const double spacing = std::max(options.target_spacing, line.length() / options.target_points);
    for (int i = 0; i < options.target_points && i * spacing <= line.length(); ++i) {
      const Eigen::Index row = group * features.group_size + i;
      placeAnchor(ego, line.poseAt(i * spacing), row, features);
      fillFreely(ways.ego, tta, row, features);
      features.prior[row] = 0.0F;
    }
  }
  if (near.empty()) {  // without lanes the ego drives on
    placeAnchor(ego, compose(ego, {reached, 0.0, 0.0}), 0, features);
    fillFreely(ways.ego, tta, 0, features);
    features.prior[0] = 0.0F;
  }
  features.along_scale = std::max(features.along_scale, static_cast<float>(options.target_spacing));
  features.across_scale = features.along_scale;
  return features;
}

AnchorFeatures straightOn(const EgoWays& ways, double tta, const PatternFeatureOptions& options) {
  AnchorFeatures features = emptyAnchors(1, 1, tta, options);
  const double reached = ways.ego.past_speeds[0] * tta;
  placeAnchor(ways.ego.state.pose, compose(ways.ego.state.pose, {reached, 0.0, 0.0}), 0, features);
  fillFreely(ways.ego, tta, 0, features);
  features.prior[0] = 0.0F;
  features.across_scale = features.along_scale;
  return features;
}

}  // namespace

const char* toString(EgoHead head) {
  switch (head) {
    case EgoHead::kRegionProposal:
      return "region_proposal";
    case EgoHead::kTargetPoints:
      return "target_points";
    case EgoHead::kRegression:
      return "regression";
  }
  return "unknown";
}

EgoHead egoHeadFromString(const std::string& name) {
  for (const EgoHead head :
       {EgoHead::kRegionProposal, EgoHead::kTargetPoints, EgoHead::kRegression}) {
    if (name == toString(head)) return head;
  }
  throw std::invalid_argument("head = " + name +
                              " is none of region_proposal, target_points, regression");
}

Snapshot observedSnapshot(const Snapshot& snapshot, const std::set<std::string>& hidden) {
  Snapshot observed = snapshot;
  const auto lookBack = [](Track& track) {
    for (std::size_t i = track.states.size(); i-- > 1;) {
      const AgentState& before = track.states[i - 1];
      AgentState& state = track.states[i];
      state.velocity =
          (state.pose.position() - before.pose.position()) / (state.time - before.time);
    }
    if (track.states.size() > 1) track.states[0].velocity = track.states[1].velocity;
  };
  lookBack(observed.ego);
  for (Track& agent : observed.agents) {
    lookBack(agent);
    if (hidden.count(agent.id) > 0 && agent.states.size() > 1) {
      agent.states.erase(agent.states.begin(), agent.states.end() - 1);
    }
  }
  return observed;
}

EgoWays egoWays(const Snapshot& observed, const LaneIndex& lanes, double horizon,
                const EgoFutureOptions& options, int max_ways) {
  EgoWays ways{egoNow(observed.ego), {}, {}};
  ways.paths = egoPaths(ways.ego, lanes, horizon, options.paths);
  std::stable_sort(ways.paths.begin(), ways.paths.end(),
                   [](const EgoPath& a, const EgoPath& b) { return a.weight > b.weight; });
  const auto count = std::min(ways.paths.size(), static_cast<std::size_t>(max_ways));
  ways.paths.erase(ways.paths.begin() + static_cast<std::ptrdiff_t>(count), ways.paths.end());
  double sum = 0.0;
  for (const EgoPath& path : ways.paths) sum += path.weight;
  for (EgoPath& path : ways.paths) {
    path.weight /= sum;
    ways.ahead.push_back(wayAhead(path, ways.ego, observed));
  }
  return ways;
}

SceneFeatures sceneFeatures(const Snapshot& observed, const LaneIndex& lanes,
                            const PatternFeatureOptions& options) {
  requireFinite(observed.ego);
  for (const Track& agent : observed.agents) requireFinite(agent);
  const int frames = options.history_frames;
  const SceneEncoding encoding = encodeScene(observed, lanes, frames, options.encoding);
  SceneFeatures features;
  const Eigen::Index agent_rows = (1 + options.max_agents) * frames;
  const Eigen::Index lane_rows = options.encoding.max_lanes * options.encoding.lane_points;
  features.agents = RowMatrix::Zero(agent_rows, kAgentVector);
  features.agent_mask = Eigen::VectorXf::Zero(agent_rows);
  features.lanes = RowMatrix::Zero(lane_rows, kLaneVector);
  features.lane_mask = Eigen::VectorXf::Zero(lane_rows);
  takeAgents(encoding, nearestAgents(observed, options.max_agents), options, features);
  takeLanes(encoding, options.encoding.lane_points, features);
  features.ego = egoFeatures(egoNow(observed.ego));
  return features;
}

AnchorFeatures anchorFeatures(const EgoWays& ways, const LaneIndex& lanes, double tta,
                              const EgoFutureOptions& futures,
                              const PatternFeatureOptions& options) {
  if (!(tta > 0.0 && std::isfinite(tta))) {
    throw std::invalid_argument("tta = " + std::to_string(tta) + " s is not positive");
  }
  switch (options.head) {
    case EgoHead::kRegionProposal:
      return wayAnchors(ways, tta, futures, options);
    case EgoHead::kTargetPoints:
      return targetPoints(ways, lanes, tta, options);
    case EgoHead::kRegression:
      return straightOn(ways, tta, options);
  }
  return {};
}

Eigen::VectorXf requestFeatures(std::optional<CollisionType> type, double tta) {
  Eigen::VectorXf features = Eigen::VectorXf::Zero(kRequestFeatures);
  for (int i = 0; i < 5; ++i) {
    if (type && *type == kCollisionTypes[i]) features[i] = 1.0F;
  }
  features[5] = static_cast<float>((tta - 0.5) / (kLongestTta - 0.5));
  features[6] = static_cast<float>(std::sqrt(tta) / 3.0);
  features[7] = static_cast<float>(1.0 / (1.0 + tta));
  return features;
}

CandidateNow candidateNow(const Track& observed, const Pose2& ego_now) {
  const AgentState& state = observed.states.back();
  return {relativeTo(ego_now, state.pose), state.velocity.dot(state.pose.heading())};
}

Eigen::VectorXf candidateFeatures(const CandidateNow& candidate, double ego_speed,
                                  const Pose2& ego_at_impact, double tta, CollisionType type) {
  const double speed = candidate.speed;
  const Pose2& now = candidate.pose;
  const Pose2 at_impact = relativeTo(ego_at_impact, now);
  const Vector2 reached = now.position() + tta * speed * now.heading();
  const Pose2 straight = relativeTo(ego_at_impact, {reached.x(), reached.y(), now.yaw});
  const Vector2 way = ego_at_impact.position() - now.position();
  const double needed = way.norm() / tta;
  const double bearing = angleBetween(now.yaw, std::atan2(way.y(), way.x()));
  const double values[19] = {held(now.x / 40.0, kMaxChange),
                             held(now.y / 40.0, kMaxChange),
                             std::cos(now.yaw),
                             std::sin(now.yaw),
                             speed / kSpeed,
                             ego_speed / kSpeed,
                             held(at_impact.x / 40.0, kMaxChange),
                             held(at_impact.y / 40.0, kMaxChange),
                             std::cos(at_impact.yaw),
                             std::sin(at_impact.yaw),
                             held(straight.x / 20.0, kMaxChange),
                             held(straight.y / 20.0, kMaxChange),
                             std::log1p(std::hypot(straight.x, straight.y)) / 3.0,
                             std::min(needed / kSpeed, kMaxChange),
                             held((needed - speed) / kSpeed, kMaxChange),
                             held((needed - speed) / tta / kAcceleration, kMaxChange) / 2.0,
                             std::cos(bearing),
                             std::sin(bearing),
                             tta / kLongestTta};
  Eigen::VectorXf features = Eigen::VectorXf::Zero(kCandidateFeatures);
  for (int i = 0; i < 19; ++i) features[i] = static_cast<float>(values[i]);
  for (int i = 0; i < 5; ++i) {
    if (type == kCollisionTypes[i]) features[19 + i] = 1.0F;
  }
  return features;
}

}  // namespace forge
