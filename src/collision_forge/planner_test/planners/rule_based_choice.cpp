#include "collision_forge/planner_test/planners/rule_based_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace forge {
namespace {

constexpr double kRoundingError = 1e-9;  // m
constexpr double kNoGap = std::numeric_limits<double>::infinity();

/// Computes the gap to the nearest of all futures at each step; skips futures that are too far
/// away.
class GapFinder {
 public:
  GapFinder(const BoxCircles& ego, const std::vector<ExpectedBox>& others)
      : ego_(ego), others_(others) {}

  double nearest(const PlacedCircles& ego, std::size_t step) const {
    double least = kNoGap;
    for (const ExpectedBox& other : others_) {
      const PlacedCircles& there = other.places[step];
      const double reaches = ego_.reach + other.circles.reach;
      const double limit = least + reaches;
      if (limit < 0.0 || (ego.middle - there.middle).squaredNorm() > limit * limit) continue;
      least = std::min(least, gapBetween(ego_, ego, other.circles, there));
    }
    return least;
  }

 private:
  const BoxCircles& ego_;
  const std::vector<ExpectedBox>& others_;
};

void weigh(WeighedProfile& weighed, const BoxCircles& circles, const LaneSpline& way,
           const std::vector<ExpectedBox>& others, const RuleBasedOptions& options) {
  const GapFinder gaps(circles, others);
  const std::vector<PlacedCircles> places = placesAlong(circles, way, weighed.profile.plan);
  double missed = 1.0;
  for (std::size_t step = 0; step < places.size(); ++step) {
    weighed.gaps.push_back(gaps.nearest(places[step], step));
    missed *= 1.0 - collisionProbability(weighed.gaps.back(), static_cast<int>(step), options);
  }
  weighed.probability = 1.0 - missed;
}

/// Returns the index of the best admissible profile, the first of equals.
template <class May, class Better>
std::optional<std::size_t> bestOf(const std::vector<WeighedProfile>& profiles, const May& may,
                                  const Better& better) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    if (may(profiles[i]) && (!best || better(profiles[i], profiles[*best]))) best = i;
  }
  return best;
}

std::size_t best(const std::vector<WeighedProfile>& profiles, bool takes_shortest,
                 double max_probability) {
  const auto distance = [](const WeighedProfile& of) { return of.profile.plan.distances.back(); };
  const auto is_safe = [&](const WeighedProfile& of) { return of.probability < max_probability; };
  const auto farther = [&](const WeighedProfile& a, const WeighedProfile& b) {
    return takes_shortest ? distance(a) < distance(b) : distance(a) > distance(b);
  };
  if (const auto found = bestOf(profiles, is_safe, farther)) return *found;
  return *bestOf(
      profiles, [](const WeighedProfile&) { return true; },
      [](const WeighedProfile& a, const WeighedProfile& b) {
        return a.probability < b.probability;
      });
}

/// Returns the index of the path that stays nearest to the route over the longest plan; the first
/// of equals.
std::size_t nearestTo(const Polyline& route, const std::vector<LaneSpline>& ways,
                      const std::vector<SpeedProfile>& profiles) {
  const std::vector<double>& distances =
      std::max_element(profiles.begin(), profiles.end(),
                       [](const SpeedProfile& a, const SpeedProfile& b) {
                         return a.plan.distances.back() < b.plan.distances.back();
                       })
          ->plan.distances;
  std::size_t nearest = 0;
  double least = kNoGap;
  for (std::size_t i = 0; i < ways.size() && ways.size() > 1; ++i) {
    double sum = 0.0;
    for (const double distance : distances) {
      sum += route.project(ways[i].at(distance).position).distance;
    }
    if (sum > least - kRoundingError) continue;
    nearest = i;
    least = sum;
  }
  return nearest;
}

}  // namespace

double collisionProbability(double gap, int step, const RuleBasedOptions& options) {
  if (gap < 0.0) return 1.0;
  return 1.0 + std::tanh(-gap * (options.distance_weight + options.distance_weight_rate * step));
}

RuleBasedChoice chooseProfile(const DrivenBox& ego, const LaneSpline& way, bool is_on_lane,
                              const std::vector<ExpectedBox>& others,
                              const RuleBasedOptions& options) {
  const BoxCircles circles = circlesOf(ego.size);
  RuleBasedChoice choice;
  for (SpeedProfile& profile : speedProfiles(ego.speed, options)) {
    WeighedProfile& weighed = choice.profiles.emplace_back();
    weighed.profile = std::move(profile);
    weigh(weighed, circles, way, others, options);
  }
  choice.chosen = best(choice.profiles, !is_on_lane && !others.empty(), options.max_probability);
  return choice;
}

Pose2 poseAfterStep(const Pose2& ego, const LaneSpline& way, const SpeedPlan& plan) {
  const double distance = plan.distances.at(1);
  const LaneSpline::Point there = way.at(distance);
  const Vector2 chord = there.position - ego.position();
  const double along = chord.dot(ego.heading());
  const bool is_on_side = distance > 0.0 ? along > 0.0 : along < 0.0;
  const Vector2 position =
      ego.position() + (is_on_side ? Vector2(std::abs(distance) * chord.normalized())
                                   : Vector2(distance * ego.heading()));
  return {position.x(), position.y(), std::atan2(there.heading.y(), there.heading.x())};
}

bool isNear(const Pose2& ego, const Pose2& other, const RuleBasedOptions& options) {
  return (other.position() - ego.position()).norm() <= options.interaction_radius;
}

RuleBasedPlan planOnLanes(const DrivenBox& ego, const std::vector<DrivenBox>& others,
                          const LaneGraph& graph, const Polyline* route,
                          const RuleBasedOptions& options) {
  std::vector<SpeedProfile> profiles = speedProfiles(ego.speed, options);
  std::vector<SpeedPlan> plans;
  for (const SpeedProfile& profile : profiles) plans.push_back(profile.plan);
  const std::vector<EdgeMatch> matches = matchedEdges(graph, ego.pose, options);
  std::vector<LaneSpline> ways =
      laneSplinesOf(graph, matches, ego.pose, ego.speed, reachOf(plans), options);
  const std::size_t taken = route ? nearestTo(*route, ways, profiles) : 0;
  std::vector<ExpectedBox> expected;
  for (const DrivenBox& other : others) {
    if (!isNear(ego.pose, other.pose, options)) continue;
    for (ExpectedBox& box : expectedBoxes(other, graph, options)) {
      expected.push_back(std::move(box));
    }
  }
  RuleBasedChoice choice = chooseProfile(ego, ways[taken], !matches.empty(), expected, options);
  return {ways[taken], expected.size(), std::move(choice)};
}

}  // namespace forge
