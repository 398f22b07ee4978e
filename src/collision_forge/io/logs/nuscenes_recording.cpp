#include "collision_forge/io/logs/nuscenes_recording.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "collision_forge/base/config/nearest_names.h"

namespace forge {
namespace {

constexpr double kSecondsPerMicrosecond = 1e-6;
constexpr double kMaxVelocityTimeDifference = 1.5;  // s, to one side

/// One annotation of an instance and its time.
struct Sighting {
  std::int64_t timestamp_us = 0;
  NuScenesAnnotation* annotation = nullptr;
};

double secondsBetween(const Sighting& a, const Sighting& b) {
  return static_cast<double>(b.timestamp_us - a.timestamp_us) * kSecondsPerMicrosecond;
}

Eigen::Vector3d velocityBetween(const Sighting& a, const Sighting& b) {
  return (b.annotation->translation - a.annotation->translation) / secondsBetween(a, b);
}

/// Returns the velocity of one instance at sighting `i`; times must increase strictly.
Eigen::Vector3d velocityAt(const std::vector<Sighting>& sightings, std::size_t i) {
  const bool has_previous = i > 0;
  const bool has_next = i + 1 < sightings.size();
  if (has_previous && has_next &&
      secondsBetween(sightings[i - 1], sightings[i + 1]) <= 2.0 * kMaxVelocityTimeDifference) {
    return velocityBetween(sightings[i - 1], sightings[i + 1]);
  }
  constexpr double kNever = 1e9;
  const double since = has_previous ? secondsBetween(sightings[i - 1], sightings[i]) : kNever;
  const double until = has_next ? secondsBetween(sightings[i], sightings[i + 1]) : kNever;
  if (std::min(since, until) > kMaxVelocityTimeDifference) return Eigen::Vector3d::Zero();
  const std::size_t first = since <= until ? i - 1 : i;
  return velocityBetween(sightings[first], sightings[first + 1]);
}

/// Has at least one entry per class; a subcategory comes before its category.
constexpr std::pair<const char*, AgentClass> kCategories[] = {
    {"vehicle.car", AgentClass::kCar},
    {"vehicle.truck", AgentClass::kTruck},
    {"vehicle.bus", AgentClass::kBus},
    {"vehicle.trailer", AgentClass::kTrailer},
    {"vehicle.construction", AgentClass::kConstructionVehicle},
    {"vehicle.emergency", AgentClass::kEmergencyVehicle},
    {"vehicle.motorcycle", AgentClass::kMotorcycle},
    {"vehicle.bicycle", AgentClass::kBicycle},
    {"human.pedestrian.child", AgentClass::kChild},
    {"human.pedestrian.personal_mobility", AgentClass::kScooter},
    {"human.pedestrian.runner", AgentClass::kRunner},  // not of nuScenes
    {"human.pedestrian", AgentClass::kPedestrian},
    {"animal", AgentClass::kAnimal},
    {"movable_object", AgentClass::kStaticObject},
    {"static_object", AgentClass::kStaticObject}};

/// Returns true if the category is `name` or one of its subcategories.
bool isKindOf(const std::string& category, const std::string& name) {
  return category.compare(0, name.size(), name) == 0 &&
         (category.size() == name.size() || category[name.size()] == '.');
}

Track egoTrack(const NuScenesRecording& recording, const EgoVehicle& ego) {
  Track track;
  track.id = kEgoId;
  track.agent_class = AgentClass::kCar;
  track.size = recording.ego_size.value_or(ego.size);
  track.states.reserve(recording.ego_poses.size());
  for (const NuScenesEgoPose& recorded : recording.ego_poses) {
    const Pose2 base{recorded.translation.x(), recorded.translation.y(), yawOf(recorded.rotation)};
    AgentState state;
    state.time = static_cast<double>(recorded.timestamp_us) * kSecondsPerMicrosecond;
    state.pose = compose(base, {ego.center_offset, 0.0, 0.0});
    track.states.push_back(state);
  }
  deriveVelocities(track);
  return track;
}

AgentState agentState(const NuScenesAnnotation& annotation, double time) {
  AgentState state;
  state.time = time;
  state.pose = {annotation.translation.x(), annotation.translation.y(), yawOf(annotation.rotation)};
  state.velocity = annotation.velocity.head<2>();
  return state;
}

template <typename IsWanted>
void deriveVelocitiesIf(NuScenesRecording& recording, const IsWanted& is_wanted) {
  std::unordered_map<std::string, std::vector<Sighting>> instances;
  for (NuScenesFrame& frame : recording.frames) {
    for (NuScenesAnnotation& annotation : frame.annotations) {
      if (!is_wanted(annotation.instance)) continue;
      instances[annotation.instance].push_back({frame.timestamp_us, &annotation});
    }
  }
  for (auto& [instance, sightings] : instances) {
    for (std::size_t i = 0; i < sightings.size(); ++i) {
      sightings[i].annotation->velocity = velocityAt(sightings, i);
    }
  }
}

}  // namespace

double yawOf(const Eigen::Quaterniond& rotation) {
  const Eigen::Vector3d heading = rotation * Eigen::Vector3d::UnitX();
  return std::atan2(heading.y(), heading.x());
}

std::optional<AgentClass> agentClassOfCategory(const std::string& category) {
  for (const auto& [name, agent_class] : kCategories) {
    if (isKindOf(category, name)) return agent_class;
  }
  return std::nullopt;
}

std::optional<AgentClass> agentClassOfCategory(const std::string& category,
                                               const std::map<std::string, AgentClass>& others) {
  if (const auto known = agentClassOfCategory(category)) return known;
  const std::string name = lowered(category);
  // Backwards: "vehicle.fire" comes after "vehicle".
  const auto found = std::find_if(others.rbegin(), others.rend(),
                                  [&](const auto& other) { return isKindOf(name, other.first); });
  return found == others.rend() ? std::nullopt : std::make_optional(found->second);
}

const char* categoryOf(AgentClass agent_class) {
  return std::find_if(std::begin(kCategories), std::end(kCategories),
                      [&](const auto& category) { return category.second == agent_class; })
      ->first;
}

void deriveVelocities(NuScenesRecording& recording) {
  deriveVelocitiesIf(recording, [](const std::string& /*instance*/) { return true; });
}

void deriveVelocities(NuScenesRecording& recording, const std::set<std::string>& instances) {
  if (instances.empty()) return;
  deriveVelocitiesIf(recording, [&](const std::string& id) { return instances.count(id) > 0; });
}

Scene toScene(const NuScenesRecording& recording, const EgoVehicle& ego,
              std::shared_ptr<const LaneMap> map) {
  Scene scene;
  scene.name = recording.name;
  scene.map = std::move(map);
  scene.ego = egoTrack(recording, ego);
  scene.lights = recording.lights;
  std::unordered_map<std::string, std::size_t> agent_of_instance;
  for (const NuScenesFrame& frame : recording.frames) {
    const double time = static_cast<double>(frame.timestamp_us) * kSecondsPerMicrosecond;
    scene.frame_times.push_back(time);
    for (const NuScenesAnnotation& annotation : frame.annotations) {
      const auto [entry, is_new] =
          agent_of_instance.try_emplace(annotation.instance, scene.agents.size());
      if (is_new) {
        const double height = annotation.size.z();
        const bool has_height = std::isfinite(height) && height > 0.0;
        scene.agents.push_back(
            {annotation.instance,
             agentClassOfCategory(annotation.category).value_or(AgentClass::kStaticObject),
             {annotation.size.x(), annotation.size.y()},
             {},
             has_height ? std::make_optional(height) : std::nullopt});
      }
      scene.agents[entry->second].states.push_back(agentState(annotation, time));
    }
  }
  return scene;
}

}  // namespace forge
