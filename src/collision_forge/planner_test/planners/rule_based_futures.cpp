#include "collision_forge/planner_test/planners/rule_based_futures.h"

#include <algorithm>

namespace forge {

std::vector<SpeedPlan> expectedSpeeds(double speed, const RuleBasedOptions& options) {
  std::vector<SpeedPlan> plans;
  for (const double speed_share : options.speed_shares) {
    for (const double acceleration_share : options.acceleration_shares) {
      plans.push_back(planTowards(speed, speed_share * speed,
                                  acceleration_share * options.max_acceleration, options.step,
                                  options.steps));
    }
  }
  return plans;
}

Reach reachOf(const std::vector<SpeedPlan>& plans) {
  Reach reach;
  for (const SpeedPlan& plan : plans) {
    const auto [least, most] = std::minmax_element(plan.distances.begin(), plan.distances.end());
    reach.ahead = std::max(reach.ahead, *most);
    reach.behind = std::max(reach.behind, -*least);
  }
  return reach;
}

std::vector<ExpectedBox> expectedBoxes(const DrivenBox& other,
                                       const std::vector<LaneSpline>& splines,
                                       const std::vector<SpeedPlan>& plans) {
  const BoxCircles circles = circlesOf(other.size);
  std::vector<ExpectedBox> boxes;
  for (const LaneSpline& spline : splines) {
    for (const SpeedPlan& plan : plans) {
      boxes.push_back({circles, placesAlong(circles, spline, plan)});
    }
  }
  return boxes;
}

std::vector<ExpectedBox> expectedBoxes(const DrivenBox& other, const LaneGraph& graph,
                                       const RuleBasedOptions& options) {
  const std::vector<SpeedPlan> plans = expectedSpeeds(other.speed, options);
  const std::vector<EdgeMatch> matches = matchedEdges(graph, other.pose, options);
  return expectedBoxes(
      other, laneSplinesOf(graph, matches, other.pose, other.speed, reachOf(plans), options),
      plans);
}

std::vector<PlacedCircles> placesAlong(const BoxCircles& circles, const LaneSpline& spline,
                                       const SpeedPlan& plan) {
  std::vector<PlacedCircles> places;
  places.reserve(plan.distances.size());
  for (const double distance : plan.distances) {
    const LaneSpline::Point point = spline.at(distance);
    places.push_back(placed(circles, point.position, point.heading.normalized()));
  }
  return places;
}

}  // namespace forge
