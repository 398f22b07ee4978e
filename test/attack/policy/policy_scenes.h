#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/policy/adaptive_attacker.h"
#include "collision_forge/attack/search/generate_collision.h"

namespace forge {

inline AdaptiveOptions shippedAdaptive() {
  static const AdaptiveOptions options = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").adaptive;
  return options;
}

inline AttackerSetup shippedSetupOfAttackers() {
  const AttackOptions options = shippedOptions();
  return {std::make_shared<KinematicEgoFutures>(options.ego_futures, nullptr), options,
          shippedAdaptive()};
}

/// An ego that drives east from x = 0, with a follower, at kNow.
struct Chase {
  std::shared_ptr<LaneMap> map = twoLaneRoad();
  std::shared_ptr<const LaneIndex> lanes = std::make_shared<const LaneIndex>(map);
  EgoVehicle ego{kEgoSize, 0.0};
  Snapshot snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, {0.0, 0.0, 0.0}, 8.0),
                                 {pastTrack("back", kCarSize, {-24.0, 0.0, 0.0}, 9.0)}, map);
  CollisionRequest request = believableRequestFor(CollisionType::kRearEnd, 4.0);

  Chase() { request.mode = Mode::kAdaptive; }

  Realization firstAttack() const {
    const AttackOptions options = shippedOptions();
    return generateCollision(searchMethod(options), {snapshot, std::nullopt, lanes, nullptr},
                             request, options.prediction);
  }

  AdaptiveAttacker attacker() const {
    const Realization first = firstAttack();
    return {{snapshot, lanes, ego, request, first.aim, first.trajectory},
            shippedSetupOfAttackers()};
  }
};

/// The ego's speed in m/s, `seconds` after kNow.
using SpeedOf = std::function<double(double seconds)>;

/// The ego from x = 0 at kNow on, straight on for ten seconds, a state each 0.1 s.
inline Track egoAt(const SpeedOf& speed) {
  Track ego{kEgoId, AgentClass::kCar, kEgoSize, {}};
  double x = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double time = 0.1 * i;
    ego.states.push_back({kNow + time, {x, 0.0, 0.0}, {speed(time), 0.0}});
    x += 0.1 * 0.5 * (speed(time) + speed(time + 0.1));
  }
  return ego;
}

inline Frame frameOf(const Track& ego, double time, std::vector<Track> agents = {}) {
  return {time, stateAt(ego, time).value().pose, std::move(agents)};
}

/// Calls observe() with the frames up to `until` seconds after kNow.
inline void watch(AttackerPolicy& policy, const Track& ego, double until, double interval = 0.1) {
  for (int i = 1; i * interval <= until + 1e-9; ++i) {
    policy.observe(frameOf(ego, kNow + i * interval));
  }
}

/// Returns the verification of the whole drive.
inline CollisionReport reportOf(const AttackerPolicy& policy, const Track& ego,
                                const Chase& chase) {
  Future future;
  future.ego = ego;
  return verify(policy.trajectory(), {chase.snapshot, future, chase.request, *chase.lanes},
                shippedOptions().verification);
}

}  // namespace forge
