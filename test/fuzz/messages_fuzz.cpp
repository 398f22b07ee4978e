#include <collision_forge/AgentArray.h>
#include <collision_forge/Attack.h>
#include <collision_forge/AttackRequest.h>
#include <collision_forge/EncodedScene.h>
#include <collision_forge/GenerateCollision.h>
#include <collision_forge/GenerateCollisions.h>
#include <collision_forge/LaneMap.h>
#include <collision_forge/ListCollisions.h>
#include <collision_forge/PlannedTrajectory.h>
#include <collision_forge/PredictPattern.h>
#include <collision_forge/RealizeTrajectory.h>
#include <collision_forge/TestPlanner.h>
#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <map>
#include <memory>

#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/config/config_file.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/trials/planner_grid.h"
#include "collision_forge/ros/injection/finite_parts.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/named_requests.h"
#include "collision_forge/ros/messages/planner_messages.h"
#include "collision_forge/ros/messages/possible_collisions.h"
#include "collision_forge/ros/messages/ros_bytes.h"
#include "fuzz/message_in.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

const InputLimits& limits() { return configuration().input_limits; }

/// Requires that a message survives the conversion to the type of this package and back.
template <typename Message>
void requireSameAgain(const Message& told) {
  std::string bytes;
  std::string again;
  appendRosBytes(bytes, told);
  appendRosBytes(again, toMessage(fromMessage(told)));
  requireSame(bytes, again);
}

void take(collision_forge::AgentArray message) {
  keepFinite(message);
  std::vector<Track> agents = fromMessage(message);
  keepWithin(agents, limits());
}

void take(const collision_forge::LaneMap& message) {
  const auto map = std::make_shared<const LaneMap>(fromMessage(message));
  checkMap(*map, limits(), "lane_map");
  const LaneIndex lanes(map);
}

void take(const collision_forge::AttackerTrajectory& message) {
  const AttackerTrajectory trajectory = fromMessage(message);
  checkTrajectory(trajectory, limits(), "trajectory");
  requireSameAgain(toMessage(trajectory));
}

void take(const collision_forge::Attack& message) {
  take(message.trajectory);
  checkPattern(fromMessage(message.pattern), limits(), "pattern");
}

/// Throws MessageError for a message with impossible values.
void take(const collision_forge::CollisionRequest& message) {
  const auto request = fromMessage(message, configuration().crash);
  if (const auto* refusal = std::get_if<Status>(&request)) throw MessageError(refusal->message);
  const auto told = toMessage(std::get<CollisionRequest>(request));
  const auto again = fromMessage(told, configuration().crash);
  require(std::holds_alternative<CollisionRequest>(again),
          "a request is rejected after its conversion");
  std::string bytes;
  std::string bytes_again;
  appendRosBytes(bytes, told);
  appendRosBytes(bytes_again, toMessage(std::get<CollisionRequest>(again)));
  requireSame(bytes, bytes_again);
}

void take(const collision_forge::AttackRequest& message) { take(message.request); }

void take(const collision_forge::SceneSnapshot& message) {
  Snapshot snapshot = fromMessage(message);
  checkSnapshot(snapshot, limits(), "scene");
  newestFrame(snapshot);
}

void take(const collision_forge::EncodedScene& message) { take(message.snapshot); }

void take(const collision_forge::PlannedTrajectory& message) { fromMessage(message); }

void take(tf2_msgs::TFMessage message) { keepFinite(message); }

void take(const nav_msgs::Odometry& message) { keepFinite(message); }

void take(const collision_forge::GenerateCollision::Request& message) {
  static const RequestVocabulary vocabulary =
      readVocabulary(std::string(COLLISION_FORGE_SOURCE_DIR "/config"));
  collision_forge::GenerateCollision::Response response;
  const auto requests = requestsOf(message, vocabulary, configuration().crash, response);
  if (const auto* refusal = std::get_if<Status>(&requests)) throw MessageError(refusal->message);
  take(requestIn(message));
}

/// For each type and time.
template <typename Asked>
void takeEach(const Asked& message) {
  const auto requests = requestsForEach(message.request, message.collision_types, message.ttas,
                                        configuration().requests.ttas, configuration().crash);
  if (const auto* refusal = std::get_if<Status>(&requests)) throw MessageError(refusal->message);
  for (const auto& request : std::get<std::vector<CollisionRequest>>(requests)) {
    take(toMessage(request));
  }
}

void take(const collision_forge::GenerateCollisions::Request& message) { takeEach(message); }

void take(const collision_forge::ListCollisions::Request& message) { takeEach(message); }

/// Checks a request for a scene as a node does.
void takeAsked(const collision_forge::SceneSnapshot& scene,
               const collision_forge::CollisionRequest& asked) {
  take(asked);
  take(scene);
  const Snapshot snapshot = fromMessage(scene);
  const auto request = std::get<CollisionRequest>(fromMessage(asked, configuration().crash));
  const Status status =
      checkRequest(withFullId(request, snapshot), snapshot, configuration().attack.prediction);
  if (status.code != StatusCode::kOk) throw MessageError(status.message);
}

void takeFuture(const collision_forge::Future& message) {
  Future future = fromMessage(message);
  checkFuture(future, limits(), "future");
}

void take(const collision_forge::PredictPattern::Request& message) {
  takeAsked(message.scene, message.request);
  takeFuture(message.recorded_future);
}

void take(const collision_forge::RealizeTrajectory::Request& message) {
  takeAsked(message.scene, message.request);
  takeFuture(message.future);
  for (const auto& pattern : message.patterns) {
    checkPattern(fromMessage(pattern), limits(), "patterns");
  }
}

void take(const collision_forge::TestPlanner::Request& message) {
  static const std::string path = COLLISION_FORGE_SOURCE_DIR "/config/planners.yaml";
  static const std::string text = bytesOf(path);
  PlannerValues values;
  for (const auto& parameter : message.parameters) values[parameter.name] = parameter.value;
  TrialOptions options;
  readConfigFile(openConfigText(path, withPlannerValues(path, text, values)), options,
                 configuration().attack.verification.limits);
  if (!message.scenario.empty()) readScenarioLine("scenario", message.scenario, limits());
  take(message.trajectory);
}

using Take = std::function<void(const std::string& bytes)>;

template <typename Message>
Take takeOf() {
  return [](const std::string& bytes) { take(messageIn<Message>(bytes)); };
}

const std::map<std::string, Take>& takers() {
  static const std::map<std::string, Take> by_type = {
      {"AgentArray", takeOf<collision_forge::AgentArray>()},
      {"Attack", takeOf<collision_forge::Attack>()},
      {"AttackRequest", takeOf<collision_forge::AttackRequest>()},
      {"EncodedScene", takeOf<collision_forge::EncodedScene>()},
      {"GenerateCollision", takeOf<collision_forge::GenerateCollision::Request>()},
      {"GenerateCollisions", takeOf<collision_forge::GenerateCollisions::Request>()},
      {"LaneMap", takeOf<collision_forge::LaneMap>()},
      {"ListCollisions", takeOf<collision_forge::ListCollisions::Request>()},
      {"Odometry", takeOf<nav_msgs::Odometry>()},
      {"PlannedTrajectory", takeOf<collision_forge::PlannedTrajectory>()},
      {"PredictPattern", takeOf<collision_forge::PredictPattern::Request>()},
      {"RealizeTrajectory", takeOf<collision_forge::RealizeTrajectory::Request>()},
      {"TFMessage", takeOf<tf2_msgs::TFMessage>()},
      {"TestPlanner", takeOf<collision_forge::TestPlanner::Request>()},
  };
  return by_type;
}

}  // namespace

/// Input: a message that a node receives, or a service request, as a line with its type, then its
/// bytes.
bool fuzzMessages(const std::string& input) {
  const auto [type, bytes] = firstLineOf(input);
  const auto taker = takers().find(type);
  return taker != takers().end() && isTaken("", [&, &told = bytes] { taker->second(told); });
}

}  // namespace forge
