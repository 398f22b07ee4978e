#include "collision_forge/study/generators/traffic_clip.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/io/collide/collide_scene.h"

namespace forge {
namespace {

AgentFrames framesOf(const Track& track, const std::vector<double>& times) {
  AgentFrames frames;
  for (const double time : times) {
    const auto state = stateAt(track, time);
    frames.push_back(state ? std::optional<Pose2>(state->pose) : std::nullopt);
  }
  return frames;
}

/// Returns the frames of a track, extended by straight motion before its first observation.
AgentFrames fullFramesOf(const Track& track, const std::vector<double>& times) {
  AgentFrames frames = framesOf(track, times);
  const AgentState& first = track.states.front();
  const double speed = first.velocity.dot(first.pose.heading());
  for (std::size_t i = 0; i < times.size() && times[i] < first.time; ++i) {
    frames[i] = compose(first.pose, {speed * (times[i] - first.time), 0.0, 0.0});
  }
  return frames;
}

/// Returns the distance (m) between the first and last observed position up to frame `now`.
double motionUpTo(const AgentFrames& frames, std::size_t now) {
  const auto seen = std::find_if(frames.begin(), frames.end(), [](const auto& f) { return f; });
  return ((*seen)->position() - frames[now]->position()).norm();
}

struct Mover {
  std::string id;
  AgentFrames frames;
};

/// Returns the other agents that are observed at frame `now` and moved, nearest to the ego first.
std::vector<Mover> moversOf(const std::vector<Track>& agents, const std::string& attacker,
                            const std::vector<double>& times, const Vector2& ego,
                            const TrafficOptions& options) {
  const auto now = static_cast<std::size_t>(options.history_frames) - 1;
  std::vector<Mover> movers;
  for (const Track& agent : agents) {
    if (agent.id == attacker || !isMotorVehicle(agent.agent_class)) continue;
    AgentFrames frames = framesOf(agent, times);
    if (!frames[now] || motionUpTo(frames, now) < options.min_motion) continue;
    movers.push_back({agent.id, std::move(frames)});
  }
  std::stable_sort(movers.begin(), movers.end(), [&](const auto& a, const auto& b) {
    return (a.frames[now]->position() - ego).squaredNorm() <
           (b.frames[now]->position() - ego).squaredNorm();
  });
  const auto most = static_cast<std::size_t>(options.max_agents) - 2;
  if (movers.size() > most) movers.resize(most);
  return movers;
}

/// Fills in agents and lanes, in the frame of the ego at t0.
void fillIn(const Track& ego, const std::vector<Track>& agents, const std::string& attacker,
            const std::vector<double>& times, const TrafficOptions& options, const LaneIndex* lanes,
            TrafficClip& clip) {
  const Track* found = findTrack(agents, attacker);
  if (!found) {
    throw std::invalid_argument("no track \"" + attacker + "\" in the snapshot");
  }
  const auto now = static_cast<std::size_t>(options.history_frames) - 1;
  std::vector<AgentFrames> all = {fullFramesOf(ego, times), fullFramesOf(*found, times)};
  const Pose2 origin = *all[kEgoAgent][now];
  if (lanes && options.lanes.max_lanes > 0) {
    const Vector2 from = all[kAttackerAgent][now]->position();
    clip.lanes = lanesAround({origin.position(), from}, origin, *lanes, options.lanes);
  }
  clip.ids = {ego.id, attacker};
  for (Mover& mover : moversOf(agents, attacker, times, origin.position(), options)) {
    clip.ids.push_back(std::move(mover.id));
    all.push_back(std::move(mover.frames));
  }
  for (AgentFrames& frames : all) {
    for (auto& pose : frames) {
      if (pose) pose = relativeTo(origin, *pose);
    }
  }
  clip.agents = std::move(all);
}

}  // namespace

TrafficClip trafficOf(const CollideClip& clip, const CollideOptions& collide,
                      const TrafficOptions& options, const LaneIndex* lanes) {
  const Scene scene = toScene(clip, collide, nullptr);
  TrafficClip traffic{clip.scene, clip.type, clip.collision_frame, {}, {}, {}};
  fillIn(scene.ego, scene.agents, clip.attacker_id, clip.times, options, lanes, traffic);
  return traffic;
}

TrafficClip trafficOf(const Snapshot& snapshot, const std::string& attacker,
                      const CollisionRequest& request, const TrafficOptions& options,
                      const LaneIndex* lanes) {
  std::vector<double> times;
  for (int frame = 1 - options.history_frames; frame <= 0; ++frame) {
    times.push_back(snapshot.now + kFrameInterval * frame);
  }
  const int ahead = std::max(1, static_cast<int>(std::lround(request.tta / kFrameInterval)));
  TrafficClip traffic{"", request.type, options.history_frames - 1 + ahead, {}, {}, {}};
  fillIn(snapshot.ego, snapshot.agents, attacker, times, options, lanes, traffic);
  return traffic;
}

}  // namespace forge
