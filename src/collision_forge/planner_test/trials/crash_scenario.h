#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// A generated crash that a planner is driven through. All times on the scene's clock.
struct CrashScenario {
  Snapshot snapshot;                             ///< known at now
  Future recorded;                               ///< what came: the ego and the others from now on
  AttackerTrajectory attacker;                   ///< from now on, in place of its recorded track
  CollisionType type = CollisionType::kRearEnd;  ///< asked for
  EgoVehicle ego;
  std::shared_ptr<const LaneIndex> lanes;

  double end() const { return attacker.points.back().time; }
};

/// The attacker's motion as a track; nothing before now.
Track attackerTrack(const CrashScenario& scenario);

/// Everybody but the ego from now on: the attacker first, as it drives, then the others as
/// recorded.
std::vector<Track> othersFromNow(const CrashScenario& scenario);

/// The ids of those, the attacker aside, whose recorded boxes overlap the ego's now: what is made
/// of a recording may be so, and is no contact.
std::set<std::string> overlappingNow(const CrashScenario& scenario);

/// Puts the past of an attacker that was added among what was seen up to now.
void showPast(CrashScenario& scenario);

/// Throws std::invalid_argument, naming what is wrong, for a scenario that nobody can be driven
/// through: without lanes, points of the attacker or an ego at now; times that do not increase; an
/// attacker that does not start now, or touches the ego then.
void checkScenario(const CrashScenario& scenario);

}  // namespace forge
