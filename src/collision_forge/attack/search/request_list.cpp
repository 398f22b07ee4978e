#include "collision_forge/attack/search/request_list.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

double nearestFrame(const std::vector<double>& frames, double time) {
  const auto after = std::lower_bound(frames.begin(), frames.end(), time);
  if (after == frames.end()) return frames.back();
  if (after == frames.begin() || *after - time < time - *std::prev(after)) return *after;
  return *std::prev(after);
}

/// Returns the frames nearest to the multiples of `stride`, each once.
std::vector<double> framesEvery(double stride, const std::vector<double>& frames) {
  std::vector<double> chosen;
  if (frames.empty()) return chosen;
  const double first = frames.front();
  const auto steps = static_cast<int>(std::floor((frames.back() - first) / stride + 0.5));
  for (int i = 0; i <= steps; ++i) {
    const double frame = nearestFrame(frames, first + i * stride);
    if (chosen.empty() || frame > chosen.back()) chosen.push_back(frame);
  }
  return chosen;
}

/// Bicycles and pedestrians are attackers only if `wanted` is their class.
std::vector<std::optional<std::string>> attackersOf(const Snapshot& snapshot, Attackers attackers,
                                                    const std::optional<AgentClass>& wanted) {
  if (attackers == Attackers::kAny) return {std::nullopt};
  std::vector<std::optional<std::string>> ids;
  for (const Track& agent : snapshot.agents) {
    if (isMotorVehicle(agent.agent_class) || agent.agent_class == wanted)
      ids.emplace_back(agent.id);
  }
  return ids;
}

double speedOf(const Track& ego) { return ego.states.empty() ? 0.0 : estimateMotion(ego).speed; }

}  // namespace

std::vector<SceneRequest> listRequests(const Scene& scene, const RequestListOptions& list,
                                       const PredictionOptions& options, double time_tolerance,
                                       const CollisionRequest& asked, RequestTally* tally) {
  if (!(list.stride > 0.0)) {
    throw std::invalid_argument("stride = " + numberText(list.stride) + " s is not positive");
  }
  std::vector<SceneRequest> requests;
  RequestTally unused;
  RequestTally& counts = tally ? *tally : unused;
  if (scene.ego.states.empty()) return requests;
  for (const double now : framesEvery(list.stride, scene.frame_times)) {
    ++counts.instants;
    const Snapshot snapshot = snapshotAt(scene, now, options.history_frames);
    const bool is_slow = speedOf(snapshot.ego) < list.min_ego_speed;
    counts.slow += is_slow;
    if (is_slow) continue;
    const double end = std::min(scene.frame_times.back(), scene.ego.states.back().time);
    counts.late += std::all_of(list.ttas.begin(), list.ttas.end(),
                               [&](double tta) { return now + tta + time_tolerance > end; });
    const auto attackers = attackersOf(snapshot, list.attackers, asked.attacker_class);
    for (const double tta : list.ttas) {
      if (now + tta + time_tolerance > end) continue;
      for (const CollisionType type : list.types) {
        for (const auto& attacker : attackers) {
          CollisionRequest request = asked;
          request.type = type;
          request.tta = tta;
          request.attacker = attacker;
          request.seed = list.seed;
          if (checkRequest(request, snapshot, options).code != StatusCode::kOk) continue;
          requests.push_back({scene.name, now, request});
        }
      }
    }
  }
  return requests;
}

}  // namespace forge
