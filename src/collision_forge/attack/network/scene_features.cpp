#include "collision_forge/attack/network/scene_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "collision_forge/attack/forecast/ego_paths.h"
#include "collision_forge/attack/network/feature_scales.h"
#include "collision_forge/attack/network/scene_encoding.h"

namespace forge {
namespace {

constexpr double kSeconds = 4.0;  // s, scale of times
constexpr double kLinks = 3.0;    // scale of numbers of successors and predecessors

void requireFinite(const Track& track) {
  for (const AgentState& state : track.states) {
    if (!state.pose.isFinite() || !state.velocity.allFinite() || !std::isfinite(state.time)) {
      throw std::invalid_argument("agent " + track.id +
                                  " has a state with a number that is not finite");
    }
  }
}

/// Returns rows of the encoding: the ego, then the agents present at t0, nearest first.
std::vector<std::size_t> nearestAgents(const Snapshot& observed, int count) {
  const Vector2 ego = observed.ego.states.back().pose.position();
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t i = 0; i < observed.agents.size(); ++i) {
    const Track& agent = observed.agents[i];
    if (!endsAt(agent, observed.now)) continue;
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
  const float scales[6] = {kPlaceScale, kPlaceScale, 1.0F, 1.0F, kSpeedScale, kSpeedScale};
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

/// Returns the last five entries of kLaneVector. A turn is measured from the lane's end to the
/// successor's end.
std::array<float, 5> linksOf(const LaneIndex& lanes, std::size_t lane) {
  const Polyline& line = *lanes.centerline(lane);
  const double end = line.poseAt(line.length()).yaw;
  const std::vector<std::size_t>& successors = lanes.successors(lane);
  std::vector<double> turns;
  bool into_intersection = false;
  for (const std::size_t successor : successors) {
    into_intersection = into_intersection || lanes.map().lanes[successor].is_intersection;
    const auto& next = lanes.centerline(successor);
    if (next) turns.push_back(angleBetween(end, next->poseAt(next->length()).yaw));
  }
  std::array<float, 5> links = {};
  links[0] = static_cast<float>(static_cast<double>(successors.size()) / kLinks);
  links[1] =
      static_cast<float>(static_cast<double>(lanes.map().lanes[lane].incoming.size()) / kLinks);
  if (!turns.empty()) {
    const auto [rightmost, leftmost] = std::minmax_element(turns.begin(), turns.end());
    links[2] = static_cast<float>(*leftmost);
    links[3] = static_cast<float>(*rightmost);
  }
  links[4] = into_intersection ? 1.0F : 0.0F;
  return links;
}

void takeLanes(const SceneEncoding& encoding, const LaneIndex& lanes, int points,
               SceneFeatures& features) {
  const Eigen::Index width = encoding.lane_features.shape[2];
  std::vector<std::array<float, 5>> links;
  for (const std::size_t lane : encoding.lanes) links.push_back(linksOf(lanes, lane));
  for (std::size_t cell = 0; cell < encoding.lane_mask.data.size(); ++cell) {
    if (encoding.lane_mask.data[cell] == 0.0F) continue;
    const auto row = static_cast<Eigen::Index>(cell);
    const float* values = encoding.lane_features.data.data() + row * width;
    for (int j = 0; j < 6; ++j) {
      features.lanes(row, j) = j < 2 ? values[j] / static_cast<float>(kPlaceScale) : values[j];
    }
    features.lanes(row, 6) = static_cast<float>(row % points) / static_cast<float>(points);
    const auto lane = static_cast<std::size_t>(row / points);
    for (std::size_t j = 0; j < 5; ++j) {
      features.lanes(row, 7 + static_cast<Eigen::Index>(j)) = links[lane][j];
    }
    features.lane_mask[row] = 1.0F;
  }
}

Eigen::VectorXf egoFeatures(const EgoNow& ego) {
  Eigen::VectorXf features(kEgoFeatures);
  for (int i = 0; i < 5; ++i) {
    features[i] = static_cast<float>(ego.past_speeds[static_cast<std::size_t>(i)] / kSpeedScale);
  }
  for (int i = 0; i < 3; ++i) {
    const auto newer = static_cast<std::size_t>(i);
    features[5 + i] = static_cast<float>((ego.past_speeds[newer] - ego.past_speeds[newer + 1]) /
                                         kProfileStep / kAccelerationScale);
  }
  features[8] = static_cast<float>(clampedTo(ego.turn_rate / kTurnRateScale, kMaxFeature));
  return features;
}

}  // namespace

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
  takeLanes(encoding, lanes, options.encoding.lane_points, features);
  features.ego = egoFeatures(egoNow(observed.ego));
  return features;
}

}  // namespace forge
