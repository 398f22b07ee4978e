#include "collision_forge/ros/bags/bag_reader.h"

#include <collision_forge/AgentArray.h>
#include <collision_forge/Attack.h>
#include <collision_forge/AttackRequest.h>
#include <collision_forge/LaneMap.h>
#include <collision_forge/TrafficLightArray.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <unordered_map>

#include "collision_forge/ros/bags/older_message.h"
#include "collision_forge/ros/bags/read_opened.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/same_instant.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr double kMicroseconds = 1e6;  // in a second

std::int64_t microseconds(double time) { return std::llround(time * kMicroseconds); }

/// Collects a scene message by message.
class SceneBuilder {
 public:
  explicit SceneBuilder(const EgoVehicle& ego) : center_offset_(ego.center_offset) {
    scene_.ego = Track{kEgoId, AgentClass::kCar, ego.size, {}};
  }

  void add(const tf2_msgs::TFMessage& message) {
    for (const auto& transform : message.transforms) {
      if (transform.header.frame_id != names::kMapFrame ||
          transform.child_frame_id != names::kBaseFrame) {
        continue;
      }
      const Pose2 base = fromMessage(transform.transform);
      if (!base.isFinite()) {
        ++skipped_["ego poses that are not finite"];
        continue;
      }
      addEgo({transform.header.stamp.toSec(), compose(base, {center_offset_, 0.0, 0.0}),
              Vector2::Zero()});
    }
  }

  void add(const collision_forge::AgentArray& message) {
    requireMapFrame(message.header, names::kAgents);
    const double time = message.header.stamp.toSec();
    if (!scene_.frame_times.empty() && !isLater(time, scene_.frame_times.back())) {
      ++skipped_["frames of agents whose stamp is not later than the previous one"];
      return;
    }
    scene_.frame_times.push_back(time);
    for (Track& agent : fromMessage(message)) {
      if (!agent.states.front().pose.isFinite() ||
          !(agent.size.length > 0.0 && agent.size.width > 0.0)) {
        ++skipped_["agents that are not finite or have no size"];
        continue;
      }
      const auto [place, is_new] = places_.try_emplace(agent.id, scene_.agents.size());
      if (is_new) {
        scene_.agents.push_back(std::move(agent));
      } else {
        append(scene_.agents[place->second], agent.states.front());
      }
    }
  }

  void add(const collision_forge::TrafficLightArray& message) {
    requireMapFrame(message.header, names::kTrafficLights);
    for (TrafficLight& light : fromMessage(message)) {
      const auto [place, is_new] = lights_.try_emplace(light.lane, scene_.lights.size());
      if (is_new) {
        scene_.lights.push_back(std::move(light));
        continue;
      }
      auto& states = scene_.lights[place->second].states;
      const LightState& state = light.states.front();
      if (state.time > states.back().time && state.color != states.back().color) {
        states.push_back(state);
      }
    }
  }

  void add(const collision_forge::EgoVehicle& message) {
    scene_.ego.size = egoSizeOf(message).value_or(scene_.ego.size);
  }

  void add(const collision_forge::LaneMap& message) {
    requireMapFrame(message.header, names::kLaneMap);
    scene_.map = std::make_shared<const LaneMap>(fromMessage(message));
  }

  Scene finish(std::vector<std::string>* warnings) {
    deriveVelocities(scene_.ego);
    for (Track& agent : scene_.agents) {
      if (hasNoVelocities(agent)) deriveVelocities(agent);
    }
    for (const auto& [what, count] : skipped_) {
      if (warnings) warnings->push_back(std::to_string(count) + " " + what + " left out");
    }
    return std::move(scene_);
  }

 private:
  static bool hasNoVelocities(const Track& track) {
    return std::all_of(track.states.begin(), track.states.end(),
                       [](const AgentState& state) { return state.velocity == Vector2::Zero(); });
  }

  /// Returns true if `time` is later than `before` by more than the rounding of stamps.
  static bool isLater(double time, double before) {
    const std::int64_t time_us = microseconds(time);
    const std::int64_t before_us = microseconds(before);
    return time_us > before_us && !isSameInstant(time_us, before_us);
  }

  /// Throws MessageError for a pose at the time of the previous one but kSamePlace away from it.
  void addEgo(const AgentState& state) {
    if (!scene_.ego.states.empty()) {
      const AgentState& last = scene_.ego.states.back();
      const std::int64_t time_us = microseconds(state.time);
      const double distance = (state.pose.position() - last.pose.position()).norm();
      if (isSameInstant(time_us, microseconds(last.time)) && distance > kSamePlace) {
        throw MessageError(std::string(names::kTf) + ": " + contradiction(distance, time_us));
      }
    }
    append(scene_.ego, state);
  }

  /// Appends a state; keeps the first of several states at one instant.
  void append(Track& track, const AgentState& state) {
    if (track.states.empty() || isLater(state.time, track.states.back().time)) {
      track.states.push_back(state);
    } else if (isLater(track.states.back().time, state.time)) {
      ++skipped_["poses whose stamp is earlier than the previous one"];
    }
  }

  double center_offset_;
  Scene scene_;
  std::unordered_map<std::string, std::size_t> places_;  // of ids, among the agents
  std::unordered_map<std::string, std::size_t> lights_;  // of lanes, among the lights
  std::map<std::string, int> skipped_;
};

/// Throws BagError naming the topics that a bag of this suite has and this one lacks.
void requireTopics(const std::string& path, const Scene& scene) {
  std::string missing;
  const auto add = [&](bool is_there, const std::string& what) {
    if (!is_there) missing += (missing.empty() ? "no " : ", no ") + what;
  };
  add(scene.map != nullptr, "message on " + bagTopic(names::kLaneMap));
  add(!scene.frame_times.empty(), "message on " + bagTopic(names::kAgents));
  add(!scene.ego.states.empty(), std::string("transform ") + names::kMapFrame + " -> " +
                                     names::kBaseFrame + " on " + names::kTf);
  if (missing.empty()) return;
  throw BagError(path + ": " + missing +
                 ": is not a bag of this suite; convert a bag of another stack with forge convert "
                 "--topics (docs/foreign_bags.md)");
}

/// Returns the last message on a topic; null if there is none.
template <typename Message>
boost::shared_ptr<Message> lastOn(const rosbag::Bag& bag, const char* name) {
  boost::shared_ptr<Message> last;
  rosbag::View view(bag, rosbag::TopicQuery(bagTopic(name)));
  for (const rosbag::MessageInstance& instance : view) last = readMessage<Message>(instance);
  return last;
}

/// Returns the last message on a topic; throws BagError if there is none.
template <typename Message>
Message requiredOn(const rosbag::Bag& bag, const char* name, const std::string& path) {
  const auto last = lastOn<Message>(bag, name);
  if (!last) throw BagError(path + ": no attack: no message on " + bagTopic(name));
  for (const rosbag::MessageInstance& instance :
       rosbag::View(bag, rosbag::TopicQuery(bagTopic(name)))) {
    if (instance.isType<Message>()) continue;
    throw BagError(path + ": " + bagTopic(name) +
                   ": was written by another version of this suite; inject the attack again");
  }
  return *last;
}

/// Rounds all times to microseconds: stamps have nanoseconds, but nuScenes tables have
/// microseconds, and the times of both must be equal.
void roundToMicroseconds(Scene& scene) {
  const auto round = [](double& time) { time = static_cast<double>(microseconds(time)) * 1e-6; };
  for (double& time : scene.frame_times) round(time);
  for (AgentState& state : scene.ego.states) round(state.time);
  deriveVelocities(scene.ego);
  for (Track& agent : scene.agents) {
    for (AgentState& state : agent.states) round(state.time);
  }
}

/// Reads a bag without checking the input limits.
Scene sceneIn(const std::string& path, const EgoVehicle& ego, std::vector<std::string>* warnings) {
  Scene scene = readOpened(path, [&](const rosbag::Bag& bag) {
    SceneBuilder builder(ego);
    const std::vector<std::string> topics = {
        names::kTf, bagTopic(names::kAgents), bagTopic(names::kLaneMap),
        bagTopic(names::kTrafficLights), bagTopic(names::kEgoVehicle)};
    for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery(topics))) {
      if (const auto transform = instance.instantiate<tf2_msgs::TFMessage>()) {
        builder.add(*transform);
      } else if (const auto agents = readMessage<collision_forge::AgentArray>(instance)) {
        if (instance.getCallerId() != names::kInBetween) builder.add(*agents);
      } else if (const auto map = readMessage<collision_forge::LaneMap>(instance)) {
        builder.add(*map);
      } else if (const auto lights = readMessage<collision_forge::TrafficLightArray>(instance)) {
        builder.add(*lights);
      } else if (const auto ego = readMessage<collision_forge::EgoVehicle>(instance)) {
        builder.add(*ego);
      }
    }
    return builder.finish(warnings);
  });
  requireTopics(path, scene);
  scene.name = std::filesystem::path(path).stem().string();
  return scene;
}

}  // namespace

Scene readBagAsWritten(const std::string& path, const DataOptions& options,
                       std::vector<std::string>* warnings) {
  Scene scene = sceneIn(path, options.ego_vehicle, warnings);
  roundToMicroseconds(scene);
  checkScene(scene, options.input_limits, path, warnings);
  return scene;
}

std::shared_ptr<const LaneMap> readLaneMap(const std::string& path, const InputLimits& limits) {
  const auto map = readOpened(path, [](const rosbag::Bag& bag) {
    const auto found = lastOn<collision_forge::LaneMap>(bag, names::kLaneMap);
    return found ? std::make_shared<const LaneMap>(fromMessage(*found)) : nullptr;
  });
  if (map) checkMap(*map, limits, path);
  return map;
}

Scene readBag(const std::string& path, const DataOptions& options,
              std::vector<std::string>* warnings) {
  Scene scene = sceneIn(path, options.ego_vehicle, warnings);
  std::sort(scene.agents.begin(), scene.agents.end(),
            [](const Track& one, const Track& other) { return one.id < other.id; });
  for (Track& agent : scene.agents) deriveVelocities(agent);
  checkScene(scene, options.input_limits, path, warnings);
  return scene;
}

Scenario readAttack(const std::string& path, const DataOptions& options,
                    const CrashDefinition& crash) {
  Scenario scenario;
  scenario.ego = options.ego_vehicle;
  readOpened(path, [&](const rosbag::Bag& bag) {
    const auto attack = requiredOn<collision_forge::Attack>(bag, names::kAttack, path);
    const auto asked = requiredOn<collision_forge::AttackRequest>(bag, names::kAttackRequest, path);
    const auto request = fromMessage(asked.request, crash);
    if (const auto* status = std::get_if<Status>(&request)) {
      throw BagError(path + ": " + bagTopic(names::kAttackRequest) + ": " + status->message);
    }
    scenario.asked.request = std::get<CollisionRequest>(request);
    scenario.asked.now = attack.header.stamp.toSec();
    scenario.answer = fromMessage(attack);
    const auto ego = lastOn<collision_forge::EgoVehicle>(bag, names::kEgoVehicle);
    if (ego) scenario.ego.size = egoSizeOf(*ego).value_or(scenario.ego.size);
    return 0;
  });
  checkTrajectory(scenario.answer.trajectory, options.input_limits, path);
  for (const SupportVehicle& support : scenario.answer.supports) {
    checkTrajectory(support.motion, options.input_limits, path);
  }
  checkPattern(scenario.answer.pattern, options.input_limits, path);
  scenario.asked.scene = std::filesystem::path(path).stem().string();
  return scenario;
}

}  // namespace forge
