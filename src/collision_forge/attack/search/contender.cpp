#include "collision_forge/attack/search/contender.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/search/placement.h"
#include "collision_forge/attack/search/walker_path.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/attack/verify/reversing.h"
#include "collision_forge/attack/verify/verification.h"

namespace forge {
namespace {

constexpr int kBranches = 8;           // paths ahead of a lane that are examined
constexpr double kBeyondReach = 10.0;  // m of path beyond the reachable distance

/// Adds the paths on which a pedestrian can walk to the patterns.
void addWalks(Contender& entry, const SearchInput& input, const SpeedVariation& variation) {
  constexpr std::size_t kMostWalks = 4;
  for (const CollisionPattern& pattern : input.patterns) {
    if (pattern.attacker_id != entry.track->id || entry.routes.size() >= kMostWalks) continue;
    const Pose2 meeting = compose(pattern.ego.center, pattern.attacker_offset);
    const auto way = walkerPath(entry.track->states.back().pose, meeting);
    if (!way) continue;
    entry.routes.emplace_back(ReferencePath(*way), entry.drive_start, entry.driver->limits(),
                              variation);
  }
}

/// Adds the paths along lanes that come near one of the ego's predicted positions at the contact.
void addRoutes(Contender& entry, const SearchInput& input, const AttackOptions& options) {
  const double tta = input.request.tta;
  const DriveState& now = entry.drive_start;
  SpeedVariation variation = variationOf(entry.track->id, input.request.seed);
  if (input.underway != nullptr && !input.underway->driven.empty()) {
    const double since = input.snapshot.now - input.underway->driven.front().time;
    variation.phase += variation.frequency() * since;
  }
  if (const auto way = input.ways.find(entry.track->id); way != input.ways.end()) {
    entry.routes.emplace_back(way->second, now, entry.driver->limits(), variation);
    return;
  }
  if (isOnFoot(entry.track->agent_class)) {
    addWalks(entry, input, variation);
    return;
  }
  if (input.underway != nullptr) {
    entry.routes.emplace_back(input.underway->way, now, entry.driver->limits(), variation);
  }
  const double reach = now.speed * tta + 0.5 * kDrivingStyles.back().forward * tta * tta;
  const auto nearEgo = [&](const Polyline& way) {
    return std::any_of(input.egos.begin(), input.egos.end(), [&](const Track* ego) {
      const auto state = stateAt(*ego, input.snapshot.now + tta).value_or(ego->states.back());
      return way.project(state.pose.position()).distance < kRouteReach;
    });
  };
  const Pose2& pose = entry.track->states.back().pose;
  const LaneIndex& lanes = drivenLanes(input.request, input.lanes);
  // A vehicle that stands beside a lane may pull out into it.
  const double aside =
      now.speed > 0.0 ? kOnLaneDistance : std::max(kOnLaneDistance, kParkingDistance);
  for (const LaneMatch& match : lanes.lanesNear(pose, aside, kOnLaneHeading)) {
    for (const LanePath& path :
         lanes.pathsAhead(match.lane, match.projection.arc_length, reach + kBeyondReach,
                          static_cast<std::size_t>(kBranches))) {
      if (static_cast<int>(entry.routes.size()) >= options.route.ways) return;
      const Polyline way(path.points);
      if (nearEgo(way)) {
        entry.routes.emplace_back(ReferencePath(way), now, entry.driver->limits(), variation);
      }
    }
  }
}

std::unique_ptr<Contender> contenderOf(const Track& agent, const SearchInput& input,
                                       const AttackOptions& options, const VehicleLimits& limits,
                                       int points) {
  auto entry = std::make_unique<Contender>();
  entry->track = &agent;
  entry->start = {estimateMotion(agent), input.snapshot.now, options.search.step, points};
  Motion& motion = entry->start.motion;
  motion.speed = std::clamp(motion.speed, 0.0, limits.max_speed);
  if (motion.speed < kStandstillSpeed) motion.acceleration = 0.0;
  const CrashDefinition& crash = input.request.crash;
  if (crash.limits == LimitSet::kDrivable || crash.believable || input.underway != nullptr) {
    const bool reverses = input.request.reverses();
    entry->limits = reverses ? reversingLimits(agent, options.verification)
                             : driveLimitsOf(agent, options.verification);
    entry->driver.emplace(entry->limits, kLimitShare, kPreview, options.search.step);
    if (input.underway != nullptr) {
      entry->drive_start = input.underway->state;
    } else {
      entry->drive_start = reverses ? reversingStateNow(agent, options.verification)
                                    : driveStateNow(agent, options.verification);
    }
  }
  if (input.isByRoutes()) {
    entry->conduct = conductOf(agent.agent_class, input, options.verification);
    addRoutes(*entry, input, options);
  }
  return entry;
}

/// Returns the future in which the ego is nearest to the pattern's box at the pattern's time.
std::size_t nearestFuture(const std::vector<const Track*>& egos, const CollisionPattern& pattern) {
  const auto apart = [&](const Track* ego) {
    const Pose2 pose = stateAt(*ego, pattern.time).value_or(ego->states.back()).pose;
    return cornerMiss(missBetween(pattern.ego.center, pose), ego->size);
  };
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < egos.size(); ++i) {
    const double distance = apart(egos[i]);
    if (distance < least) nearest = i;
    least = std::min(least, distance);
  }
  return nearest;
}

bool haveOneEgo(const CollisionPattern& a, const CollisionPattern& b) {
  return a.time == b.time && a.ego.center.x == b.ego.center.x && a.ego.center.y == b.ego.center.y &&
         a.ego.center.yaw == b.ego.center.yaw;
}

}  // namespace

std::vector<std::unique_ptr<Contender>> contendersOf(const SearchInput& input,
                                                     const AttackOptions& options,
                                                     const VehicleLimits& limits, int points) {
  std::vector<std::unique_ptr<Contender>> contenders;
  Aim aim;
  for (const CollisionPattern& pattern : input.patterns) {
    auto entry = std::find_if(contenders.begin(), contenders.end(), [&](const auto& other) {
      return other->track->id == pattern.attacker_id;
    });
    if (entry == contenders.end()) {
      if (static_cast<int>(contenders.size()) >= options.search.max_attackers) continue;
      const auto& agents = input.snapshot.agents;
      const auto agent = std::find_if(agents.begin(), agents.end(), [&](const Track& track) {
        return track.id == pattern.attacker_id;
      });
      if (agent == agents.end()) continue;
      contenders.push_back(contenderOf(*agent, input, options, limits, points));
      entry = std::prev(contenders.end());
    }
    // Most patterns share one ego pose.
    if (!aim.pattern || !haveOneEgo(*aim.pattern, pattern)) {
      aim.ego = nearestFuture(input.egos, pattern);
    }
    aim.pattern = &pattern;
    aim.touching =
        touchingOffset(input.snapshot.ego.size, (*entry)->track->size, pattern.attacker_offset);
    (*entry)->aims.push_back(aim);
  }
  return contenders;
}

}  // namespace forge
