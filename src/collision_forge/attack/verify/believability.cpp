#include "collision_forge/attack/verify/believability.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "collision_forge/attack/verify/reversing.h"
#include "collision_forge/base/geometry/arc_path.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

constexpr double kStandstill = 0.1;  // m/s
constexpr double kBraking = 6.0;     // m/s2, hard: of a driver who sees the kerb
constexpr double kTurning = 6.0;     // m/s2 to the side, hard
constexpr double kTightest = 0.2;    // 1/m; curvature of a car at full lock
constexpr double kMostOff = 0.5;     // share of the box that may leave the road: an overhang
constexpr double kArcStep = 0.2;     // s
constexpr double kStep = 0.5;  // m between the points searched for road; the raster's cell size

/// Number of a box's samplePointsOf() on each kind of ground.
struct Ground {
  std::size_t off_road = 0;  // 0 if the map has no drivable area
  std::size_t on_walkway = 0;
};

Ground groundBelow(const OrientedBox& box, const LaneIndex& lanes) {
  const bool knows_road = !lanes.drivable().empty();
  Ground ground;
  for (const Vector2& place : samplePointsOf(box)) {
    if (lanes.drivable().contains(place)) continue;
    ground.off_road += knows_road;
    ground.on_walkway += lanes.walkways().contains(place);
  }
  return ground;
}

/// Returns true if there is drivable area within `reach` (m) of `from` in the unit vector
/// `direction`.
bool findsRoad(const Vector2& from, const Vector2& direction, const AreaRaster& drivable,
               double reach) {
  const int steps = static_cast<int>(reach / kStep);
  for (int i = 1; i <= steps; ++i) {
    if (drivable.contains(from + i * kStep * direction)) return true;
  }
  return false;
}

/// Returns true if the vehicle stays on the road while it brakes and turns with `turning` (m/s2,
/// positive to the left); see staysOnRoad().
bool staysOnRoadTurning(double turning, TrajectoryPoint from, const BoxSize& size,
                        const LaneIndex& lanes) {
  const auto off_road = [&](const Pose2& pose) {
    return static_cast<double>(groundBelow({pose, size}, lanes).off_road) / kBoxSamples;
  };
  const double most = off_road(from.pose) + kMostOff;
  while (std::abs(from.speed) > kStandstill) {
    const double braked = std::min(kBraking * kArcStep, std::abs(from.speed));
    const double mean = from.speed - std::copysign(0.5 * braked, from.speed);
    const double curvature = turning / std::max(mean * mean, kTurning / kTightest);
    from.pose = alongArc(from.pose, curvature, mean * braked / kBraking);
    from.speed -= std::copysign(braked, from.speed);
    if (off_road(from.pose) > most) return false;
  }
  return true;
}

/// Part of a trajectory in which the vehicle must keep to its lane: from `first` to the time
/// `until` (s).
struct LaneStretch {
  std::vector<TrajectoryPoint>::const_iterator first;
  double until;
};

/// Adds the ground use of one point to the sums in `use`.
void addGround(const Pose2& pose, const BoxSize& size, const LaneIndex& lanes,
               const BelievabilityOptions& options, RoadUse& use) {
  const Ground ground = groundBelow({pose, size}, lanes);
  use.off_road += static_cast<double>(ground.off_road);
  use.on_walkway += ground.on_walkway > 0;
  use.on_island += isOnIsland(pose, lanes, options.island_reach);
}

/// Adds the lane use of one point to the sums in `use`.
void addLanes(const Pose2& pose, const LaneIndex& lanes, const BelievabilityOptions& options,
              RoadUse& use) {
  const bool on_lane = lanes.grid().isOnLane(pose, options.lane_distance, options.lane_heading);
  use.on_lane += on_lane;
  use.wrong_way += !on_lane && lanes.grid().isWrongWay(pose, options.lane_distance);
}

/// Returns the ground use until `until` and the lane use along `on_lanes`, each including the first
/// point at or after its end.
RoadUse roadUseOf(const std::vector<TrajectoryPoint>& points, const BoxSize& size, double until,
                  const LaneStretch& on_lanes, const LaneIndex& lanes,
                  const BelievabilityOptions& options) {
  RoadUse use;
  std::size_t count = 0;
  for (const TrajectoryPoint& point : points) {
    addGround(point.pose, size, lanes, options, use);
    ++count;
    if (point.time >= until) break;
  }
  std::size_t on_lanes_count = 0;
  for (auto point = on_lanes.first; point != points.end(); ++point) {
    addLanes(point->pose, lanes, options, use);
    ++on_lanes_count;
    if (point->time >= on_lanes.until) break;
  }
  const auto divide = [](double& sum, std::size_t by) {
    if (by > 0) sum /= static_cast<double>(by);
  };
  use.off_road /= static_cast<double>(kBoxSamples);
  for (double* sum : {&use.off_road, &use.on_walkway, &use.on_island}) divide(*sum, count);
  for (double* sum : {&use.on_lane, &use.wrong_way}) divide(*sum, on_lanes_count);
  return use;
}

/// Returns true if a lane direction relative to the ego's (rad) fits the requested type's band,
/// widened by `slack` (rad).
bool directionFits(double relative_heading, const CollisionRequest& request,
                   DrivingSide driving_side, double slack) {
  const TypeDefinition band = request.bands();
  if (request.type == CollisionType::kLtap &&
      relative_heading * ltapSign(request.turning, driving_side) < 0.0) {
    return false;
  }
  const double size = std::abs(relative_heading);
  return size >= band.min_heading - slack && size <= band.max_heading + slack;
}

bool isByWalker(const CollisionRequest& request) {
  return request.attacker_class && isOnFoot(*request.attacker_class);
}

/// Returns true if some attacker of the requested kind could meet an ego that has turned by `turn`
/// (rad): one that does not turn itself, at the best heading of the type.
bool mayTurnTo(double turn, const CollisionRequest& request, DrivingSide driving_side) {
  const TypeDefinition band = request.bands();
  const AgentClass attacker = request.attacker_class.value_or(AgentClass::kCar);
  // As the ego drove at t0, or the other way.
  const std::pair<double, double> ways[] = {{std::abs(turn), -1.0}, {M_PI - std::abs(turn), 1.0}};
  return std::any_of(std::begin(ways), std::end(ways), [&](const auto& way) {
    const double heading = std::clamp(way.first, band.min_heading, band.max_heading);
    const double sign = way.second * std::copysign(1.0, turn);
    return egoTurns(request.type, {turn, 0.0, sign * heading}, attacker, band, driving_side);
  });
}

/// Returns true if an attacker of the requested kind can come to the ego's box: on a lane, on foot,
/// or out of a bay.
bool hasWayTo(const OrientedBox& ego, const CollisionRequest& request, const LaneIndex& lanes,
              const BelievabilityOptions& options) {
  if (isByWalker(request)) return true;
  if (!request.reverses()) return !fittingLanes(ego, request, lanes, options).empty();
  constexpr BoxSize kCar{4.6, 1.8};  // m
  for (const double sign : {-1.0, 1.0}) {
    const double heading = sign * request.bands().nominal_heading;
    if (bayBehind(compose(ego.center, {0.0, 0.0, heading}), kCar, lanes)) return true;
  }
  return false;
}

struct RoadRefusal {
  const char* type;
  const char* reason;
};

RoadRefusal roadRefusalOf(const CollisionRequest& request) {
  if (request.reverses()) {
    return {"backing out", "the map has no bay and no drive beside the ego's path"};
  }
  if (request.turning == Turning::kEgo) {
    if (request.type == CollisionType::kLtap) {
      return {"left turn of the ego across path",
              "the ego does not turn across a lane of the opposite direction"};
    }
    return {"collision of a turning ego",
            isByWalker(request) ? "the ego does not turn far enough into an arm that people cross"
                                : "the ego does not turn far enough onto or across a lane"};
  }
  switch (request.type) {
    case CollisionType::kRearEnd:
      return {"rear-end collision", "no lane at the ego's place has its direction"};
    case CollisionType::kLaneChange:
      return {"lane-change collision", "no lane leads beside the ego or into its lane"};
    case CollisionType::kOppositeDirection:
      return {"opposite-direction collision", "no lane near the ego has the opposite direction"};
    case CollisionType::kJunctionCrossing:
      return {"junction crossing", "no lane crosses the ego's path"};
    case CollisionType::kSideswipeSameDirection:
      return {"sideswipe", "no lane leads beside the ego or into its lane"};
    case CollisionType::kAngleSameDirection:
      return {"angle collision", "no lane crosses or joins the ego's path at 30 to 80 degrees"};
    case CollisionType::kAngleOppositeDirection:
      return {"angle collision", "no lane meets the ego's path at 100 to 170 degrees"};
    case CollisionType::kAny:
      return {"collision", "there is no lane near the ego"};
    case CollisionType::kLtap:
      break;
  }
  return {"left turn across path", "no lane crosses the ego's path from the opposite direction"};
}

}  // namespace

const LaneIndex& drivenLanes(const CollisionRequest& request, const LaneIndex& lanes) {
  return request.manoeuvre == Manoeuvre::kWrongWay ? lanes.reversed() : lanes;
}

RoadUse roadUse(const std::vector<TrajectoryPoint>& points, const BoxSize& size, double until,
                const LaneIndex& lanes, const BelievabilityOptions& options) {
  return roadUseOf(points, size, until, {points.begin(), until}, lanes, options);
}

bool isOnIsland(const Pose2& pose, const LaneIndex& lanes, double reach) {
  const AreaRaster& drivable = lanes.drivable();
  const Vector2 place = pose.position();
  if (drivable.contains(place) || lanes.walkways().contains(place)) return false;
  const Vector2 ahead = pose.heading();
  const Vector2 left(-ahead.y(), ahead.x());
  const auto isBetween = [&](const Vector2& direction) {
    return findsRoad(place, direction, drivable, reach) &&
           findsRoad(place, -direction, drivable, reach);
  };
  return isBetween(left) || isBetween(ahead);
}

std::vector<FittingLane> fittingLanes(const OrientedBox& ego, const CollisionRequest& request,
                                      const LaneIndex& lanes, const BelievabilityOptions& options) {
  const DrivingSide driving_side = lanes.map().driving_side;
  const Vector2 middle = ego.center.position();
  std::vector<FittingLane> found;
  std::pair<double, double> least;  // distances of the last one found: to the box, to its middle
  for (const LaneSample& sample :
       lanes.grid().samplesNear(middle, circumradius(ego.size) + options.road_distance)) {
    const double yaw = std::atan2(sample.heading.y(), sample.heading.x());
    const std::pair<double, double> distances(distanceToPoint(ego, sample.position),
                                              (sample.position - middle).norm());
    if (distances.first > options.road_distance ||
        !directionFits(angleBetween(ego.center.yaw, yaw), request, driving_side,
                       options.road_heading)) {
      continue;
    }
    const bool is_new = found.empty() || found.back().lane != sample.lane;
    if (!is_new && distances >= least) continue;
    if (is_new) found.emplace_back();
    found.back() = {
        sample.lane, sample.arc_length, {sample.position.x(), sample.position.y(), yaw}};
    least = distances;
  }
  return found;
}

RoadUse roadUseOfAttack(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                        double contact, const LaneIndex& lanes,
                        const BelievabilityOptions& options) {
  const auto moves = [](const TrajectoryPoint& point) {
    return std::abs(point.speed) > kStandstill;
  };
  const auto first = std::find_if(points.begin(), points.end(), moves);
  const bool pulls_out = first != points.begin();
  const double until = contact - (pulls_out ? options.pull_out : options.before_contact);
  RoadUse use = roadUseOf(points, size, contact, {first, until}, lanes, options);
  if (pulls_out && (first == points.end() || first->time >= until)) {
    use.on_lane = 1.0;
    use.wrong_way = 0.0;
  }
  return use;
}

bool staysOnRoad(const TrajectoryPoint& from, const BoxSize& size, const LaneIndex& lanes) {
  for (const double share : {0.0, 0.5, -0.5, 1.0, -1.0}) {
    if (staysOnRoadTurning(share * kTurning, from, size, lanes)) return true;
  }
  return false;
}

std::string implausibilityOf(const RoadUse& road, const std::vector<TrajectoryPoint>& points,
                             const BoxSize& size, double contact, const LaneIndex& lanes,
                             const BelievabilityOptions& options) {
  const auto share = [](double value) {
    return std::to_string(static_cast<int>(std::lround(100.0 * value))) + " %";
  };
  if (lanes.map().lanes.empty()) return "";
  if (road.on_walkway > 0.0)
    return "is on a walkway for " + share(road.on_walkway) + " of its motion";
  if (road.on_island > 0.0)
    return "is on a traffic island for " + share(road.on_island) + " of its motion";
  const RoadUse now = roadUse(points, size, points.front().time, lanes, options);
  if (road.off_road > now.off_road + options.max_off_road) {
    return "is off the road with " + share(road.off_road) + " of its box";
  }
  if (road.wrong_way > options.max_wrong_way) {
    return "drives against the lane direction for " + share(road.wrong_way) + " of its motion";
  }
  if (road.on_lane < options.min_on_lane) {
    return "is on a lane for only " + share(road.on_lane) + " of its motion";
  }
  const auto at = std::find_if(points.begin(), std::prev(points.end()),
                               [&](const TrajectoryPoint& point) { return point.time >= contact; });
  if (!staysOnRoad(*at, size, lanes)) return "would leave the road if it did not hit the ego";
  return "";
}

bool passesJunction(const Track& ego, double from, double to, const LaneIndex& lanes,
                    const BelievabilityOptions& options) {
  const auto isOfJunction = [](const Lane& lane) {
    return lane.is_intersection || lane.is_connector;
  };
  const std::vector<Lane>& known = lanes.map().lanes;
  if (std::none_of(known.begin(), known.end(), isOfJunction)) return true;
  return std::any_of(ego.states.begin(), ego.states.end(), [&](const AgentState& state) {
    if (state.time < from || state.time > to) return false;
    const auto matches = lanes.lanesNear(state.pose, options.lane_distance, options.lane_heading);
    return !matches.empty() && isOfJunction(known[matches.front().lane]);
  });
}

bool roadAllows(const Track& ego, double now, const CollisionRequest& request,
                const LaneIndex& lanes, const BelievabilityOptions& options) {
  if (lanes.map().lanes.empty()) return true;
  if (request.type == CollisionType::kAny) {
    return std::any_of(std::begin(kAllCollisionTypes), std::end(kAllCollisionTypes),
                       [&](CollisionType type) {
                         CollisionRequest one = request;
                         one.type = type;
                         return roadAllows(ego, now, one, lanes, options);
                       });
  }
  const DrivingSide driving_side = lanes.map().driving_side;
  const LaneIndex& driven = drivenLanes(request, lanes);
  const Pose2 start = stateAt(ego, now).value_or(ego.states.front()).pose;
  for (const double share : {0.0, -0.5, 0.5, -1.0, 1.0}) {
    const double time = now + request.tta + share * request.crash.time_tolerance;
    const Pose2 pose = stateAt(ego, time).value_or(ego.states.back()).pose;
    const OrientedBox box = boxAt(ego, pose);
    const bool turns =
        request.turning == Turning::kAttacker ||
        (mayTurnTo(angleBetween(start.yaw, pose.yaw), request, driving_side) &&
         (request.type == CollisionType::kLtap || passesJunction(ego, now, time, lanes, options)));
    if (turns && hasWayTo(box, request, driven, options)) return true;
  }
  return false;
}

bool roadAllows(const Future& future, double now, const CollisionRequest& request,
                const LaneIndex& lanes, const BelievabilityOptions& options) {
  constexpr std::size_t kStride = 8;
  if (future.ego_samples.empty()) return roadAllows(future.ego, now, request, lanes, options);
  for (std::size_t i = 0; i < future.ego_samples.size(); i += kStride) {
    if (roadAllows(future.ego_samples[i], now, request, lanes, options)) return true;
  }
  return false;
}

std::string roadRefusal(const CollisionRequest& request) {
  const RoadRefusal refusal = roadRefusalOf(request);
  return std::string(refusal.type) + " is not feasible here: " + refusal.reason + " at t0 + " +
         numberText(request.tta) + " s";
}

}  // namespace forge
