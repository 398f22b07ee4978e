#include "collision_forge/attack/contender.h"

#include <algorithm>

namespace forge {
namespace {

constexpr double kBeyondReach = 10.0;  // m that ways go on beyond what can be driven

std::unique_ptr<Contender> contenderOf(const Track& agent, const SearchInput& input,
                                       const AttackOptions& options, const VehicleLimits& limits,
                                       int points) {
  auto entry = std::make_unique<Contender>();
  const PredictionOptions& prediction = options.prediction;
  entry->track = &agent;
  entry->start = {estimateMotion(agent, prediction.motion_frames), input.snapshot.now,
                  options.search.step, points};
  Motion& motion = entry->start.motion;
  motion.speed = std::clamp(motion.speed, 0.0, limits.max_speed);
  if (motion.speed < prediction.standstill_speed) motion.acceleration = 0.0;
  const double tta = input.request.tta;
  const double reach =
      tta * std::min(limits.max_speed, motion.speed + 0.5 * limits.max_forward_acceleration * tta);
  entry->paths = pathsAhead(input.lanes, agent.states.back().pose, reach + kBeyondReach,
                            prediction.on_lane_distance, prediction.on_lane_heading,
                            static_cast<std::size_t>(options.search.lane_paths));
  entry->quintics.push_back(std::make_unique<QuinticFamily>());
  for (const ReferencePath& path : entry->paths) {
    entry->quintics.push_back(std::make_unique<QuinticFamily>(path));
  }
  return entry;
}

}  // namespace

std::vector<std::unique_ptr<Contender>> contendersOf(const SearchInput& input,
                                                     const AttackOptions& options,
                                                     const VehicleLimits& limits, int points) {
  std::vector<std::unique_ptr<Contender>> contenders;
  for (const CollisionPattern& pattern : input.patterns) {
    if (static_cast<int>(contenders.size()) >= options.search.max_attackers) break;
    const auto same = [&](const auto& other) { return other->track->id == pattern.attacker_id; };
    if (std::any_of(contenders.begin(), contenders.end(), same)) continue;
    for (const Track& agent : input.snapshot.agents) {
      if (agent.id != pattern.attacker_id) continue;
      contenders.push_back(contenderOf(agent, input, options, limits, points));
    }
  }
  return contenders;
}

}  // namespace forge
