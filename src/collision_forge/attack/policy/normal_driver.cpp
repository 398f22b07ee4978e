#include "collision_forge/attack/policy/normal_driver.h"

#include <algorithm>
#include <limits>

#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/search/route_driver.h"
#include "collision_forge/attack/search/track_driver.h"
#include "collision_forge/attack/verify/verification.h"

namespace forge {
namespace {

// Shares of the speed now that are tried, the first at which the vehicle touches no other agent is
// driven.
constexpr double kSpeedShares[] = {1.0, 0.8, 0.6, 0.4, 0.2, 0.0};
constexpr double kBackTime = 3.0;      // s in which the vehicle returns to the middle of its lane
constexpr double kClearance = 0.2;     // m to all other agents
constexpr double kWayBeyond = 20.0;    // m of way beyond what can be driven
constexpr double kShortestWay = 10.0;  // m

/// Along the nearest lane and on; straight on where none is near.
ReferencePath wayOf(const Pose2& pose, double reach, const LaneIndex& lanes) {
  const auto matches = lanes.lanesNear(pose, kMaxDeparture, kOnLaneHeading);
  if (!matches.empty()) {
    const LaneMatch& match = matches.front();
    return ReferencePath(lanes.pathAhead(match.lane, match.projection.arc_length, reach));
  }
  return ReferencePath(
      Polyline({pose.position(), Vector2(pose.position() + reach * pose.heading())}));
}

/// Everybody that is not to be touched, and was not already.
std::vector<const Track*> othersOf(const DriveOnInput& input, const OrientedBox& now) {
  std::vector<const Track*> others;
  const auto add = [&](const Track& track) {
    const auto state = stateAt(track, input.time);
    if (!state || !overlaps(now, boxAt(track, state->pose))) others.push_back(&track);
  };
  for (const Track& agent : input.future.agents) {
    if (agent.id != input.vehicle.id) add(agent);
  }
  add(input.future.ego);
  return others;
}

}  // namespace

std::optional<double> firstTouch(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                                 const std::vector<const Track*>& others) {
  std::optional<double> first;
  for (const Track* other : others) {
    const double reach = circumradius(size) + circumradius(other->size);
    for (const TrajectoryPoint& point : points) {
      if (first && point.time >= *first) break;
      const auto state = stateAt(*other, point.time);
      if (!state || (state->pose.position() - point.pose.position()).norm() > reach) continue;
      if (overlaps({point.pose, size}, boxAt(*other, state->pose))) first = point.time;
    }
  }
  return first;
}

std::vector<TrajectoryPoint> driveOn(const DriveOnInput& input, const AttackOptions& attack) {
  const double step = attack.search.step;
  const DriveLimits limits = driveLimitsOf(input.vehicle, attack.verification);
  const TrackDriver driver(limits, kLimitShare, kPreview, step);
  const Pose2 middle = compose(input.state.axle, {limits.axle_to_middle, 0.0, 0.0});
  const double duration = static_cast<double>(input.steps - 1) * step;
  const double reach = std::max(kShortestWay, input.state.speed * duration) + kWayBeyond;
  const RouteDriver along(wayOf(middle, reach, input.lanes), input.state, driver.limits());
  const std::vector<const Track*> others = othersOf(input, {middle, input.vehicle.size});
  RoutePlan plan;
  plan.arrival = std::max(duration, step);
  plan.departure = plan.arrival;
  plan.lead = std::max(0.0, plan.arrival - kBackTime);
  std::vector<PlannedStep> planned;
  std::vector<TrajectoryPoint> points;
  std::vector<TrajectoryPoint> best;
  double latest = -std::numeric_limits<double>::infinity();
  for (const double clearance : {kClearance, 0.0}) {
    const BoxSize size{input.vehicle.size.length + 2.0 * clearance,
                       input.vehicle.size.width + 2.0 * clearance};
    for (const double share : kSpeedShares) {
      for (std::size_t style = 0; style < kDrivingStyles.size(); ++style) {
        along.plan(plan, along.courseAt(plan, {style, share * input.state.speed}, step), step,
                   input.steps, planned);
        driver.drive(input.state, input.time, planned, points);
        const auto touch = firstTouch(points, size, others);
        if (!touch) return points;
        if (clearance == 0.0 && *touch >= latest) {
          latest = *touch;
          best = points;
        }
        if (share >= 1.0) break;  // no style is needed to keep a speed
      }
    }
  }
  return best;
}

}  // namespace forge
