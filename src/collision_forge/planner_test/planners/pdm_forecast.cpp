#include "collision_forge/planner_test/planners/pdm_forecast.h"

#include <algorithm>
#include <array>
#include <utility>

#include "collision_forge/planner_test/planners/red_lights.h"

namespace forge {
namespace {

constexpr std::size_t kRenewal = 2;  // steps between two changes of the positions

enum Kind { kVehicle, kPedestrian, kBicycle, kStatic, kKinds };

Kind kindOf(AgentClass agent_class) {
  switch (agent_class) {
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
    case AgentClass::kAnimal:
      return kPedestrian;
    case AgentClass::kBicycle:
    case AgentClass::kScooter:
      return kBicycle;
    case AgentClass::kStaticObject:
      return kStatic;
    default:
      return kVehicle;
  }
}

/// Returns the indices of the nearest agents of each kind, ascending.
std::vector<std::size_t> nearest(const std::vector<Track>& agents, const Vector2& ego,
                                 const PdmAgentOptions& options) {
  std::array<std::vector<std::pair<double, std::size_t>>, kKinds> by_kind;
  for (std::size_t i = 0; i < agents.size(); ++i) {
    if (agents[i].states.empty()) continue;
    const double distance = (agents[i].states.back().pose.position() - ego).norm();
    if (distance > options.radius) continue;
    by_kind[kindOf(agents[i].agent_class)].emplace_back(distance, i);
  }
  const std::array<int, kKinds> most = {options.vehicles, options.pedestrians, options.bicycles,
                                        options.static_objects};
  std::vector<std::size_t> chosen;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    std::sort(by_kind[kind].begin(), by_kind[kind].end());
    const std::size_t count = std::min(by_kind[kind].size(), static_cast<std::size_t>(most[kind]));
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(by_kind[kind][i].second);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

ForecastAgent forecastOf(const Track& track, const PdmAgentOptions& options) {
  const AgentState& now = track.states.back();
  const Vector2 heading = now.pose.heading();
  ForecastAgent agent;
  agent.id = track.id;
  agent.box = boxAt(track, now.pose);
  agent.speed = now.velocity.norm();
  agent.velocity = (now.velocity.dot(heading) < 0.0 ? -agent.speed : agent.speed) * heading;
  agent.radius = circumradius(agent.box.size);
  agent.is_static_object = track.agent_class == AgentClass::kStaticObject;
  agent.is_red_light = isRedLight(track.id);
  agent.is_standing = agent.is_static_object || agent.speed <= options.standing_speed;
  return agent;
}

}  // namespace

PdmForecast::PdmForecast(const std::vector<Track>& agents, const OrientedBox& ego, double step,
                         int steps, const PdmAgentOptions& options, std::set<std::string>& ignored)
    : step_(step) {
  for (const std::size_t index : nearest(agents, ego.center.position(), options)) {
    const ForecastAgent agent = forecastOf(agents[index], options);
    if (overlaps(agent.box, ego)) ignored.insert(agent.id);
    if (ignored.count(agent.id) == 0) agents_.push_back(agent);
  }
  const std::size_t renewals = static_cast<std::size_t>(steps) / kRenewal;
  for (std::size_t i = 0; i <= renewals; ++i) {
    positions_.emplace_back();
    for (const ForecastAgent& agent : agents_) {
      const double elapsed = static_cast<double>(i * kRenewal) * step;
      positions_.back().push_back(agent.box.center.position() + elapsed * agent.velocity);
    }
  }
}

const std::vector<Vector2>& PdmForecast::positions(std::size_t step) const {
  return positions_[step / kRenewal];
}

OrientedBox PdmForecast::box(std::size_t agent, std::size_t step) const {
  OrientedBox box = agents_[agent].box;
  const Vector2& position = positions(step)[agent];
  box.center.x = position.x();
  box.center.y = position.y();
  return box;
}

}  // namespace forge
