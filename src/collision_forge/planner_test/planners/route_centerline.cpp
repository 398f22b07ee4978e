#include "collision_forge/planner_test/planners/route_centerline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace forge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A candidate lane of the route at one of its places, or none.
struct Choice {
  std::optional<std::size_t> lane;
  double lateral = 0.0;    // m from the route to the centreline, positive to the left
  double cost = 0.0;       // m, of the best sequence up to here
  std::size_t before = 0;  // index of the choice at the previous place
};

using Choices = std::vector<Choice>;

Choices choicesAt(const LaneIndex& lanes, const Pose2& place,
                  const RouteCenterlineOptions& options) {
  Choices choices;
  for (const LaneMatch& match :
       lanes.lanesNear(place, options.route_lane_distance, options.route_lane_heading)) {
    const double lateral = relativeTo(place, match.projection.pose).y;
    choices.push_back({match.lane, lateral, match.projection.distance, 0});
  }
  choices.push_back({std::nullopt, 0.0, options.off_lane_cost, 0});
  return choices;
}

double costBetween(const LaneIndex& lanes, const Choice& from, const Choice& to,
                   const RouteCenterlineOptions& options) {
  if (from.lane == to.lane) return 0.0;
  if (!from.lane || !to.lane) return options.lane_change_cost;
  const std::vector<std::size_t>& next = lanes.successors(*from.lane);
  const bool follows = std::find(next.begin(), next.end(), *to.lane) != next.end();
  return follows ? 0.0 : options.lane_change_cost;
}

void connect(const LaneIndex& lanes, const Choices& before, Choices& choices,
             const RouteCenterlineOptions& options) {
  for (Choice& choice : choices) {
    double least = kInfinity;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double cost = before[i].cost + costBetween(lanes, before[i], choice, options);
      if (cost < least) {
        least = cost;
        choice.before = i;
      }
    }
    choice.cost += least;
  }
}

std::vector<Choice> cheapest(const std::vector<Choices>& places) {
  std::vector<Choice> chosen(places.size());
  const Choices& last = places.back();
  auto choice = static_cast<std::size_t>(
      std::min_element(last.begin(), last.end(),
                       [](const Choice& a, const Choice& b) { return a.cost < b.cost; }) -
      last.begin());
  for (std::size_t i = places.size(); i-- > 0;) {
    chosen[i] = places[i][choice];
    choice = chosen[i].before;
  }
  return chosen;
}

/// Returns the lateral offset of the line at each place of the route; changes from lane to lane are
/// smoothed over `reach` places before and after.
std::vector<double> lateralsOf(const LaneIndex& lanes, const std::vector<Choice>& chosen, int reach,
                               const RouteCenterlineOptions& options) {
  const int count = static_cast<int>(chosen.size());
  std::vector<double> laterals;
  for (const Choice& choice : chosen) laterals.push_back(choice.lateral);
  for (int i = 1; i < count; ++i) {
    const Choice& before = chosen[static_cast<std::size_t>(i - 1)];
    const Choice& after = chosen[static_cast<std::size_t>(i)];
    if (costBetween(lanes, before, after, options) == 0.0) continue;
    const double jump = after.lateral - before.lateral;
    for (int j = std::max(i - reach, 0); j < std::min(i + reach, count); ++j) {
      const double nearness = 1.0 - std::abs(j + 0.5 - i) / reach;
      laterals[static_cast<std::size_t>(j)] += (j < i ? 0.5 : -0.5) * jump * nearness;
    }
  }
  return laterals;
}

}  // namespace

Polyline routeCenterline(const LaneIndex& lanes, const std::vector<Vector2>& route,
                         const RouteCenterlineOptions& options) {
  const Polyline line(route);
  const int count = std::max(1, static_cast<int>(std::lround(line.length() / options.spacing)));
  std::vector<Pose2> poses;
  std::vector<Choices> places;
  for (int i = 0; i <= count; ++i) {
    poses.push_back(line.poseAt(line.length() * i / count));
    places.push_back(choicesAt(lanes, poses.back(), options));
    if (i > 0) connect(lanes, places[places.size() - 2], places.back(), options);
  }
  const int reach =
      static_cast<int>(std::lround(0.5 * options.lane_change_length / options.spacing));
  const std::vector<double> laterals = lateralsOf(lanes, cheapest(places), reach, options);
  std::vector<Vector2> points;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    points.push_back(compose(poses[i], {0.0, laterals[i], 0.0}).position());
  }
  return Polyline(points);
}

}  // namespace forge
