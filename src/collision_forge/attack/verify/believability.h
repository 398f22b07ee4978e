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

/// Returns the lanes in the direction in which the requested attacker drives: `lanes.reversed()`
/// for Manoeuvre::kWrongWay, else `lanes`. The reference is valid as long as `lanes` lives.
const LaneIndex& drivenLanes(const CollisionRequest& request, const LaneIndex& lanes);

/// Returns the shares of RoadUse over the points up to and including the first at or after `until`
/// (s, clock of the points). Poses are box centres in the global map frame; off_road and on_walkway
/// test the points samplePointsOf() of the box. Shares that need a map layer are 0 if the map lacks
/// it: drivable areas for off_road and on_island, centrelines for on_lane and wrong_way. All shares
/// are 0 if `points` is empty. About 1 us per point.
RoadUse roadUse(const std::vector<TrajectoryPoint>& points, const BoxSize& size, double until,
                const LaneIndex& lanes, const BelievabilityOptions& options);

/// As roadUse() with until = `contact` (s, clock of the points), except that on_lane and wrong_way
/// end before the manoeuvre: options.before_contact seconds before the contact, or options.pull_out
/// seconds for an attacker that stands (at most 0.1 m/s) at the first point. For such an attacker
/// these two shares start where it starts to move; if it starts later than that end, they are 1 and
/// 0.
RoadUse roadUseOfAttack(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                        double contact, const LaneIndex& lanes,
                        const BelievabilityOptions& options);

/// Returns the reason why an attack with contact at `contact` (s, clock of the points) and the road
/// use `road` from roadUseOfAttack() is implausible, worded to follow the attacker ("is on a
/// walkway for 12 % of its motion"); empty if it is plausible or the map has no lanes. Tested in
/// this order: any point on a walkway, any on an island, RoadUse::off_road, wrong_way and on_lane
/// against `options`, staysOnRoad() at the contact; only the first reason is returned. `lanes` are
/// the drivenLanes() of the request. Area off the road at the first point is not counted: it was
/// recorded. `points` must not be empty.
std::string implausibilityOf(const RoadUse& road, const std::vector<TrajectoryPoint>& points,
                             const BoxSize& size, double contact, const LaneIndex& lanes,
                             const BelievabilityOptions& options);

/// Returns true if a vehicle with the pose, speed and box centre of `from` can brake to a
/// standstill with 6 m/s2, straight or in an arc with 3 or 6 m/s2 to either side (curvature at most
/// 0.2 1/m), so that every 0.2 s at most half of its box is off the drivable area, in addition to
/// the share that is off it at `from`. True if the map has no drivable area, or if the vehicle
/// stands (at most 0.1 m/s).
bool staysOnRoad(const TrajectoryPoint& from, const BoxSize& size, const LaneIndex& lanes);

/// Returns true if the position of `pose` (map frame) is on a traffic island or median: neither
/// drivable area nor walkway, with drivable area within `reach` (m) on both the left and right of
/// the pose, or both ahead and behind. Resolution 0.5 m.
bool isOnIsland(const Pose2& pose, const LaneIndex& lanes, double reach);

/// A lane from whose direction an attacker can hit the ego with the requested type.
struct FittingLane {
  std::size_t lane = 0;     ///< index into LaneMap::lanes of the index passed to fittingLanes()
  double arc_length = 0.0;  ///< m from the start of the centreline to `pose`
  /// of the fitting centreline sample nearest to the ego's box, map frame; yaw along the lane
  Pose2 pose;
};

/// Returns the lanes, each once, in the order of LaneMap::lanes, with a centreline sample within
/// options.road_distance of the ego's box (global map frame) whose direction fits the request:
/// |direction - ego yaw| within the type's band of headings widened by options.road_heading on both
/// sides. kLtap also needs the sign ltapSign(). Ties inside the box are broken by the distance to
/// its centre. Pass drivenLanes() as `lanes`. Empty if no lane fits. Throws as request.bands().
std::vector<FittingLane> fittingLanes(const OrientedBox& ego, const CollisionRequest& request,
                                      const LaneIndex& lanes, const BelievabilityOptions& options);

/// Returns true if the ego's box centre is on a lane of a junction at one of its states between
/// `from` and `to` (s, clock of the states, both included), or if the map marks no lane as part of
/// a junction (Lane::is_intersection, is_connector).
bool passesJunction(const Track& ego, double from, double to, const LaneIndex& lanes,
                    const BelievabilityOptions& options);

/// Returns true if the map has no lanes, or if at t0 + tta, or half or all of the request's time
/// tolerance before or after, one of drivenLanes() fits (see fittingLanes()) the ego's box, or the
/// request needs no lane: attacker_class is on foot, or the attacker reverses out of a bay
/// (bayBehind()) beside the ego. With Turning::kEgo, the ego must also have turned by then, so that
/// an attacker that does not turn could meet egoTurns(), and except for ltap at a junction
/// (passesJunction()). For kAny, returns true if it holds for one
/// of kAllCollisionTypes. `ego` holds the states (box centre, map frame) from `now` (t0, s, clock
/// of the states); after its end the last state is used. It must not be empty. Throws
/// std::out_of_range if `request.crash` is not set.
bool roadAllows(const Track& ego, double now, const CollisionRequest& request,
                const LaneIndex& lanes, const BelievabilityOptions& options);

/// Returns true if roadAllows() holds for any sampled ego future (tests every eighth), or for
/// `future.ego` if there are no samples.
bool roadAllows(const Future& future, double now, const CollisionRequest& request,
                const LaneIndex& lanes, const BelievabilityOptions& options);

/// Returns the message for a request that roadAllows() rejects, with type and tta of `request`, for
/// example "junction crossing is not feasible
/// here: no lane crosses the ego's path at t0 + 4 s".
std::string roadRefusal(const CollisionRequest& request);

}  // namespace forge
