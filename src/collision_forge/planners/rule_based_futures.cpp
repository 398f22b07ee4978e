#include "collision_forge/planners/rule_based_futures.h"

#include <algorithm>

#include "collision_forge/planners/bent_path.h"
#include "collision_forge/planners/speed_plan.h"

namespace forge {
namespace {

constexpr double kStanding = 1e-3;  // m/s

bool follow(const LaneIndex& lanes, std::size_t a, std::size_t b) {
  const auto leadsTo = [&](std::size_t from, std::size_t to) {
    const std::vector<std::size_t>& next = lanes.successors(from);
    return std::find(next.begin(), next.end(), to) != next.end();
  };
  return leadsTo(a, b) || leadsTo(b, a);
}

/// The ways that an agent may drive, each starting beside it.
std::vector<Polyline> waysAhead(const LaneIndex& lanes, const Pose2& agent, double distance,
                                const RuleBasedOptions& options) {
  std::vector<Polyline> ways;
  for (const LaneMatch& match : drivenLanes(lanes, agent, options)) {
    for (const LanePath& path : lanes.pathsAhead(match.lane, match.projection.arc_length, distance,
                                                 static_cast<std::size_t>(options.max_paths))) {
      ways.emplace_back(path.points);
    }
  }
  if (ways.empty()) {
    ways.push_back(Polyline({agent.position(), agent.position() + agent.heading()}));
  }
  return ways;
}

}  // namespace

std::vector<LaneMatch> drivenLanes(const LaneIndex& lanes, const Pose2& agent,
                                   const RuleBasedOptions& options) {
  std::vector<LaneMatch> driven;
  for (const LaneMatch& match :
       lanes.lanesNear(agent, options.on_lane_distance, options.on_lane_heading)) {
    const bool is_known = std::any_of(driven.begin(), driven.end(), [&](const LaneMatch& nearer) {
      return follow(lanes, nearer.lane, match.lane);
    });
    if (!is_known) driven.push_back(match);
  }
  return driven;
}

ExpectedAgent expectedAgent(const Track& agent, const LaneIndex& lanes,
                            const RuleBasedOptions& options) {
  const AgentState& now = agent.states.back();
  ExpectedAgent expected{circlesOf(agent.size, options.circles), {}};
  const double speed = std::max(now.velocity.dot(now.pose.heading()), 0.0);
  if (speed < kStanding) {
    expected.futures.emplace_back(static_cast<std::size_t>(options.steps) + 1,
                                  placed(expected.chain, now.pose));
    return expected;
  }
  const double distance = speed * options.step * options.steps;
  for (const Polyline& way : waysAhead(lanes, now.pose, distance, options)) {
    const BentPath path(way, 0.0, now.pose.position(), options.bend_length, options.sample_spacing);
    for (const double share : options.speed_shares) {
      const SpeedPlan plan =
          planTowards(speed, share * speed, options.acceleration_share * options.max_acceleration,
                      options.step, options.steps);
      expected.futures.emplace_back();
      for (const double driven : plan.distances) {
        expected.futures.back().push_back(placed(expected.chain, path.at(driven)));
      }
    }
  }
  return expected;
}

}  // namespace forge
