#include "planners/route_centerline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace forge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A lane that the route may be on at one of its places, or none.
struct Choice {
  std::optional<std::size_t> lane;
  double lateral = 0.0;    // m, of the centreline seen from the route, positive to the left
  double cost = 0.0;       // m, of the best way here
  std::size_t before = 0;  // the choice at the place before
};

using Choices = std::vector<Choice>;

Choices choicesAt(const LaneIndex& lanes, const Pose2& place,
                  const RouteCenterlineOptions& options) {
  Choices choices;
  for (const LaneMatch& match :
       lanes.lanesNear(place, options.lane_max_distance, options.lane_max_heading)) {
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

/// The lateral offsets of the cheapest choices.
std::vector<double> cheapestOffsets(const std::vector<Choices>& places) {
  std::vector<double> offsets(places.size());
  const Choices& last = places.back();
  std::size_t choice = static_cast<std::size_t>(
      std::min_element(last.begin(), last.end(),
                       [](const Choice& a, const Choice& b) { return a.cost < b.cost; }) -
      last.begin());
  for (std::size_t i = places.size(); i-- > 0;) {
    offsets[i] = places[i][choice].lateral;
    choice = places[i][choice].before;
  }
  return offsets;
}

/// Each value the mean of those up to `reach` before and behind it.
std::vector<double> smoothed(const std::vector<double>& values, std::size_t reach) {
  std::vector<double> means(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t around = std::min({reach, i, values.size() - 1 - i});
    double sum = 0.0;
    for (std::size_t j = i - around; j <= i + around; ++j) sum += values[j];
    means[i] = sum / (2.0 * static_cast<double>(around) + 1.0);
  }
  return means;
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
  const auto reach =
      static_cast<std::size_t>(std::lround(0.5 * options.lane_change_length / options.spacing));
  const std::vector<double> offsets = smoothed(cheapestOffsets(places), reach);
  std::vector<Vector2> points;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    points.push_back(compose(poses[i], {0.0, offsets[i], 0.0}).position());
  }
  return Polyline(points);
}

}  // namespace forge
