#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// The lanes as an attacker of the request comes along them: against their direction if it asks for
/// Manoeuvre::kWrongWay.
const LaneIndex& drivenLanes(const CollisionRequest& request, const LaneIndex& lanes);

/// Of the points up to and including the first at or after `until` (seconds, clock of the points);
/// all shares are 0 without points. Poses are box middles in the global map frame; the box's places
/// are those of placesOf(). Nobody is off a drivable area or on an island of it where the map has
/// none, nor on a lane or on the wrong side where it has no centrelines. About a
/// microsecond a point.
RoadUse roadUse(const std::vector<TrajectoryPoint>& points, const BoxSize& size, double until,
                const LaneIndex& lanes, const BelievabilityOptions& options);

/// The same until `contact`, with on_lane and wrong_way until the manoeuvre alone: until
/// before_contact seconds before `contact`, or pull_out seconds before it for who stands at the
/// first point. For an attacker that stands, these two shares begin where it moves off; they are 1
/// and 0 if it moves off no earlier.
RoadUse roadUseOfAttack(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                        double contact, const LaneIndex& lanes,
                        const BelievabilityOptions& options);

/// Why no driver would use the road as roadUseOfAttack() says of the points, for people; empty
/// where one could. A map without lanes tells nothing. Nobody is blamed for what of the box is off
/// the drivable area at the first point.
std::string whyUnbelievable(const RoadUse& road, const std::vector<TrajectoryPoint>& points,
                            const BoxSize& size, const LaneIndex& lanes,
                            const BelievabilityOptions& options);

/// The place is on ground that road encloses (a traffic island, a median): neither drivable nor a
/// walkway, with drivable area within `reach` metres to the left and right of the pose, or ahead
/// and behind it. Told to half a metre.
bool isOnIsland(const Pose2& pose, const LaneIndex& lanes, double reach);

/// A lane that somebody could come along to meet the ego.
struct FittingLane {
  std::size_t lane = 0;     ///< index into LaneMap::lanes
  double arc_length = 0.0;  ///< of the pose, metres from the centreline's first point
  Pose2 pose;               ///< on the centreline: of its fitting samples that nearest to the box
};

/// The lanes with a sample of the centreline (LaneGrid) at most road_distance from the ego's box,
/// global map frame, whose direction relative to the ego's fits the type: the absolute value is
/// within the band's min_heading to max_heading, widened by road_heading on either side. For ltap
/// it also points to where a vehicle goes that turned across the ego's path: to the ego's right in
/// right-hand traffic, to its left in left-hand traffic. By lane, each once. Samples inside the box
/// are told apart by the distance to its middle.
std::vector<FittingLane> fittingLanes(const OrientedBox& ego, const TypeDefinition& band,
                                      CollisionType type, const LaneIndex& lanes,
                                      const BelievabilityOptions& options);

/// A crash of the request's type and time is one that the road allows: the map has no lanes, or
/// some lane fits (fittingLanes()) the ego's box at the time asked for or up to the tolerance
/// before or after it; of drivenLanes(). `ego`: from `now` on, its last state beyond its end.
bool roadAllows(const Track& ego, double now, const CollisionRequest& request,
                const LaneIndex& lanes, const BelievabilityOptions& options);

/// The same in any of the ego's futures (every eighth sample is looked at), or in the known one.
bool roadAllows(const Future& future, double now, const CollisionRequest& request,
                const LaneIndex& lanes, const BelievabilityOptions& options);

}  // namespace forge
