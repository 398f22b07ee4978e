#include "collision_forge/io/logs/scenario_net_lights.h"

#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace forge {
namespace {

/// Colours of ScenarioNet's states: of MetaDrive ("TRAFFIC_LIGHT_RED") and of Waymo
/// ("LANE_STATE_ARROW_STOP").
LightColor colorOf(const std::string& state) {
  const auto has = [&](const char* word) { return state.find(word) != std::string::npos; };
  if (has("FLASHING")) return LightColor::kUnknown;
  if (has("RED") || has("STOP")) return LightColor::kRed;
  if (has("YELLOW") || has("CAUTION")) return LightColor::kYellow;
  if (has("GREEN") || has("_GO")) return LightColor::kGreen;
  return LightColor::kUnknown;
}

std::vector<std::pair<std::string, PickleField>> entriesOf(const PickleField& states,
                                                           std::vector<std::string>& problems) {
  try {
    return states.entries();
  } catch (const std::runtime_error& error) {
    problems.push_back(error.what());
    return {};
  }
}

void readStates(const PickleField& field, const std::vector<double>& times, TrafficLight& light) {
  const std::vector<PickleField> rows = field.at("state").at("object_state").list();
  if (rows.size() != times.size()) field.fail("has not as many states as metadata.ts has times");
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const LightColor color = rows[row].isText() ? colorOf(rows[row].text()) : LightColor::kUnknown;
    if (light.states.empty() || light.states.back().color != color) {
      light.states.push_back({times[row], color});
    }
  }
}

}  // namespace

std::vector<TrafficLight> lightsOf(const PickleField& states, const std::vector<double>& times,
                                   const LaneMap& map, std::vector<std::string>& problems) {
  std::unordered_map<std::string, const Lane*> lanes;
  for (const Lane& lane : map.lanes) {
    if (!lane.centerline.empty()) lanes.emplace(lane.id, &lane);
  }
  std::vector<TrafficLight> lights;
  for (const auto& [id, field] : entriesOf(states, problems)) {
    try {
      const auto controlled = field.find("lane");
      const auto lane = lanes.find(controlled ? controlled->word() : id);
      if (lane == lanes.end()) continue;
      const auto place = field.find("stop_point");
      const auto point = place ? place->firstPoint() : std::nullopt;
      TrafficLight light{lane->first, point.value_or(lane->second->centerline[0].position()), {}};
      readStates(field, times, light);
      lights.push_back(std::move(light));
    } catch (const std::runtime_error& error) {
      problems.push_back(error.what());
    }
  }
  return lights;
}

}  // namespace forge
