#include "collision_forge/base/scene/scene_history.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "collision_forge/base/scene/clock.h"

namespace forge {

bool isUsable(const Track& agent) {
  return agent.states.size() == 1 && agent.states.front().pose.isFinite() &&
         std::isfinite(agent.size.length) && agent.size.length > 0.0 &&
         std::isfinite(agent.size.width) && agent.size.width > 0.0;
}

std::vector<Track> agentsAt(const std::vector<Track>& tracks, double time) {
  std::vector<Track> agents;
  for (const Track& track : tracks) {
    const auto state = std::find_if(
        track.states.begin(), track.states.end(),
        [=](const AgentState& seen) { return std::abs(seen.time - time) < kTimeEpsilon; });
    if (state == track.states.end()) continue;
    agents.push_back({track.id, track.agent_class, track.size, {*state}, track.height});
  }
  return agents;
}

Frame newestFrame(const Snapshot& snapshot) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const Pose2 ego = endsAt(snapshot.ego, snapshot.now) ? snapshot.ego.states.back().pose
                                                       : Pose2{kUnknown, kUnknown, kUnknown};
  return {snapshot.now, ego, agentsAt(snapshot.agents, snapshot.now)};
}

SceneHistory::SceneHistory(int frames, const EgoVehicle& ego) : count_(frames), ego_(ego) {}

SceneHistory::SceneHistory(int frames, const EgoVehicle& ego, const Snapshot& start)
    : count_(frames), ego_(ego), map_(start.map) {
  for (const AgentState& state : start.ego.states) {
    frames_.push_back({state.time, state.pose, agentsAt(start.agents, state.time)});
  }
}

bool SceneHistory::isLate(double time) const {
  return !frames_.empty() && time <= frames_.back().time && time >= frames_.back().time - kRestart;
}

int SceneHistory::add(Frame frame) {
  if (!frame.ego.isFinite()) throw std::invalid_argument("the ego's pose is not finite");
  if (!frames_.empty() && frame.time <= frames_.back().time) frames_.clear();
  const auto usable_end = std::stable_partition(frame.agents.begin(), frame.agents.end(), isUsable);
  const auto dropped = static_cast<int>(std::distance(usable_end, frame.agents.end()));
  frame.agents.erase(usable_end, frame.agents.end());
  frames_.push_back(std::move(frame));
  const double oldest = frames_.back().time - kFrameInterval * (count_ + 1);
  // At low frame rates, the frames of a snapshot are kept whatever their age.
  while (static_cast<int>(frames_.size()) > count_ && frames_.front().time < oldest) {
    frames_.pop_front();
  }
  return dropped;
}

Snapshot SceneHistory::snapshot() const {
  Snapshot snapshot;
  snapshot.ego = Track{kEgoId, AgentClass::kCar, ego_.size, {}};
  snapshot.map = map_;
  if (frames_.empty()) return snapshot;
  snapshot.now = frames_.back().time;
  std::vector<double> times;
  for (const Frame& frame : frames_) times.push_back(frame.time);
  const std::vector<double> shown = historyTimes(times, count_);
  std::map<std::string, Track> tracks;
  for (const Frame& frame : frames_) {
    if (!std::binary_search(shown.begin(), shown.end(), frame.time)) continue;
    snapshot.ego.states.push_back({frame.time, frame.ego, Vector2::Zero()});
    for (const Track& agent : frame.agents) {
      Track& track = tracks.try_emplace(agent.id, Track{agent.id, {}, {}, {}}).first->second;
      track.agent_class = agent.agent_class;
      track.size = agent.size;
      track.height = agent.height;
      if (track.states.empty() || track.states.back().time < frame.time) {
        track.states.push_back({frame.time, agent.states.front().pose, Vector2::Zero()});
      }
    }
  }
  deriveVelocities(snapshot.ego);
  for (auto& [id, track] : tracks) {
    deriveVelocities(track);
    snapshot.agents.push_back(std::move(track));
  }
  return snapshot;
}

}  // namespace forge
