#include "collision_forge/planner_test/planners/red_lights.h"

#include <algorithm>

namespace forge {
namespace {

constexpr const char* kPrefix = "red_light_";
constexpr BoxSize kObstacle{1.0, 2.0};  // m; narrower than a lane, to keep clear of the next one

}  // namespace

bool isRedLight(const std::string& agent_id) { return agent_id.rfind(kPrefix, 0) == 0; }

std::vector<Track> withRedLights(const Observation& observation, const BoxSize& ego,
                                 const LaneIndex& lanes, const std::vector<std::size_t>& route) {
  std::vector<Track> agents = observation.agents;
  const auto& red = observation.red_lanes;
  const Pose2& pose = observation.ego.pose;
  const Vector2 front = compose(pose, {0.5 * ego.length, 0.0, 0.0}).position();
  for (const std::size_t lane : route) {
    const std::string& id = lanes.map().lanes[lane].id;
    const auto& line = lanes.centerline(lane);
    if (!line || std::find(red.begin(), red.end(), id) == red.end()) continue;
    const Pose2 stop = line->poseAt(0.0);
    if ((front - stop.position()).dot(stop.heading()) > 0.0) continue;
    const Pose2 middle = compose(stop, {0.5 * kObstacle.length, 0.0, 0.0});
    agents.push_back({kPrefix + id,
                      AgentClass::kStaticObject,
                      kObstacle,
                      {{observation.ego.time, middle, Vector2::Zero()}}});
  }
  return agents;
}

}  // namespace forge
