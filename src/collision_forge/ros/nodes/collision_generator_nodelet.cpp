#include <collision_forge/AttackMethods.h>
#include <collision_forge/EncodedScene.h>
#include <collision_forge/GenerateCollision.h>
#include <collision_forge/GenerateCollisions.h>
#include <collision_forge/ListCollisions.h>
#include <collision_forge/PredictedPatterns.h>
#include <nav_msgs/Path.h>
#include <std_srvs/Trigger.h>
#include <boost/make_shared.hpp>
#include <pluginlib/class_list_macros.hpp>

#include <algorithm>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <variant>

#include "collision_forge/attack/network/network_ego_futures.h"
#include "collision_forge/attack/search/alternatives.h"
#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/batch/printable.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"
#include "collision_forge/ros/injection/live_attacker.h"
#include "collision_forge/ros/messages/attack_request.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/named_requests.h"
#include "collision_forge/ros/messages/paths.h"
#include "collision_forge/ros/messages/possible_collisions.h"
#include "collision_forge/ros/messages/report_text.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/nodes/attack_finder.h"
#include "collision_forge/ros/nodes/node_support.h"
#include "collision_forge/ros/nodes/scene_memory.h"
#include "collision_forge/ros/nodes/served_nodelet.h"

namespace forge {

/// Serves generate_collision and publishes the attack; serves list_collisions and
/// generate_collisions for many types and times at once. Drives adaptive attackers, too. With the
/// private parameter `keep_attack` an attack is tested again when its replay restarts; without, a
/// restart drops it.
class CollisionGeneratorNodelet : public QueuedNodelet {
 private:
  using Request = collision_forge::GenerateCollision::Request;
  using Response = collision_forge::GenerateCollision::Response;

  static constexpr double kWatchInterval = 0.5;      // s of the wall clock
  static constexpr std::uint32_t kSceneQueue = 100;  // scenes queued for an attacker's update step

  void start(ros::NodeHandle node) override {
    config_ = loadNodeConfig(getPrivateNodeHandle());
    NODELET_INFO_STREAM(describeWeights(config_));
    loadLogged("methods", [&] {
      finder_ = std::make_unique<AttackFinder>(node, getPrivateNodeHandle(), config_);
    });
    loadLogged("catalogue", [&] { vocabulary_ = readVocabulary(config_.folder); });
    configuration_ = fingerprintOfAll(config_, config_.folder);
    scenes_ = std::make_unique<SceneMemory>(config_.live);
    patterns_ =
        node.advertise<collision_forge::PredictedPatterns>(names::kPredictedPatterns, 1, true);
    attacks_ = node.advertise<collision_forge::Attack>(names::kAttack, 1, true);
    attacker_paths_ = node.advertise<nav_msgs::Path>(names::kAttackPath, 1, true);
    ego_paths_ = node.advertise<nav_msgs::Path>(names::kAttackEgoPath, 1, true);
    requests_ = node.advertise<collision_forge::AttackRequest>(names::kAttackRequest, 1, true);
    publishMethods(node);
    live_ = std::make_unique<LiveAttacker>(
        [this](const collision_forge::Attack& attack) { publish(attack); },
        getPrivateNodeHandle().param("keep_attack", false), config_.live.maxAttackAge());
    scene_subscriber_ = node.subscribe(names::kEncodedScene, kSceneQueue,
                                       &CollisionGeneratorNodelet::receive, this);
    watch_ = node.createWallTimer(
        ros::WallDuration(kWatchInterval), [this](const ros::WallTimerEvent& /*event*/) {
          attempt([this] { live_->checkForLostFrames(ros::Time::now().toSec()); });
        });
    services_.emplace_back(node, names::kGenerateCollision, &CollisionGeneratorNodelet::generate,
                           this);
    services_.emplace_back(node, names::kGenerateCollisions,
                           &CollisionGeneratorNodelet::generateEach, this);
    services_.emplace_back(node, names::kListCollisions, &CollisionGeneratorNodelet::list, this);
    services_.emplace_back(node, names::kReset, &CollisionGeneratorNodelet::reset, this);
  }

  /// Publishes the attack and its path; for an empty attack clears both paths.
  void publish(const collision_forge::Attack& attack) {
    attacks_.publish(attack);
    if (isNone(attack)) {
      attacker_paths_.publish(toPath({}));
      ego_paths_.publish(toPath({}));
    } else {
      attacker_paths_.publish(toPath(fromMessage(attack.trajectory).points));
    }
  }

  void publishMethods(ros::NodeHandle& node) {
    collision_forge::AttackMethods message;
    message.default_method = finder_->defaultMethod();
    for (const MethodRegistry::Entry& entry : finder_->methods().entries()) {
      message.names.push_back(entry.name);
      message.descriptions.push_back(entry.description);
    }
    methods_publisher_ =
        node.advertise<collision_forge::AttackMethods>(names::kAttackMethods, 1, true);
    methods_publisher_.publish(message);
  }

  void receive(const collision_forge::EncodedScene::ConstPtr& message) {
    const double clock = ros::Time::now().toSec();
    // A scene may arrive before the /clock message of the same time: separate connections.
    scenes_->add(boost::make_shared<collision_forge::SceneSnapshot>(message->snapshot),
                 std::max(clock, message->header.stamp.toSec()));
    attempt([&] { live_->addFrame(newestFrame(fromMessage(message->snapshot)), clock); });
  }

  template <typename Look>
  void attempt(const Look& look) {
    try {
      look();
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM_THROTTLE(
          1.0, "update step of the attacker failed: " << printable(error.what()));
    }
  }

  /// Returns the moment of the newest scene, or of the scene at a stamp.
  std::variant<Moment, Status> momentAt(const ros::Time& stamp) const {
    const auto scene =
        stamp.isZero() ? scenes_->newest(ros::Time::now().toSec()) : scenes_->at(stamp);
    if (const Status* none = std::get_if<Status>(&scene)) return *none;
    return finder_->momentOf(*std::get<SceneMemory::Scene>(scene));
  }

  /// Serves generate_collision. The published attack is the result of the last request: none if the
  /// scene does not allow it. An invalid request, or a bag that already contains an attack, changes
  /// nothing.
  bool generate(Request& message, Response& response) {
    const std::lock_guard<std::mutex> lock(shown_);
    answerWith(response, [&] { return generateOne(message, response); });
    const auto code = static_cast<StatusCode>(response.code);
    if (code != StatusCode::kOk) {
      if (dependsOnScene(code) && !finder_->isRecordingAttacked()) forget();
      NODELET_INFO_STREAM(toString(code) << ": " << printable(response.message));
    }
    return true;
  }

  /// Tries the requests that the message means, until one has an attack.
  Status generateOne(const Request& message, Response& response) {
    const auto requests = requestsOf(message, vocabulary_, config_.crash, response);
    if (const Status* refusal = std::get_if<Status>(&requests)) return *refusal;
    const auto& named = std::get<std::vector<NamedRequest>>(requests);
    if (message.adaptive && named.front().request.mode == Mode::kReplay) {
      return {
          StatusCode::kInvalidInput,
          "adaptive = true cannot be combined with mode = replay, which uses the recorded future"};
    }
    const auto found = momentAt(message.stamp);
    if (const Status* none = std::get_if<Status>(&found)) return *none;
    std::optional<Status> reason;
    for (const NamedRequest& one : named) {
      const Status status = answerTo(one.request, message, std::get<Moment>(found), response);
      response.name = one.name;
      if (status.code == StatusCode::kOk) return status;
      if (!reason) reason = status;
    }
    if (named.size() > 1) {
      reason->message =
          "no attack for any of " + counted(named.size(), "cell") + "; " + reason->message;
    }
    return *reason;
  }

  Status answerTo(CollisionRequest request, const Request& message, const Moment& moment,
                  Response& response) {
    if (message.alternative == 1) request.alternatives = 1;
    std::optional<PatternPrediction> first;  // alternatives are predicted for, too
    Attack answer =
        finder_->answer(moment, request, message.method, [&](const PatternPrediction& prediction) {
          if (!first) first = prediction;
        });
    if (message.alternative != 0) answer = attackOf(std::move(answer), message.alternative);
    if (answer.status.code != StatusCode::kOk) return answer.status;
    request = withTypeOf(request, answer);
    if (first) showPatterns(*first, moment.snapshot.now);
    collision_forge::CollisionAnswer shown =
        toMessage(request, answer, nameOf(message.method), moment.snapshot.now);
    showEgoPath(moment, first ? &first->future.ego : nullptr, answer.trajectory);
    requests_.publish(
        attackRequest(request, shown.attack, configuration_, std::max(1U, message.alternative)));
    start(moment, request, answer, shown.attack);
    response.attack = std::move(shown.attack);
    response.alternatives = std::move(shown.alternatives);
    response.summary = summaryOf(response.attack);
    return answer.status;
  }

  const std::string& nameOf(const std::string& method) const {
    return method.empty() ? finder_->defaultMethod() : method;
  }

  void showPatterns(const PatternPrediction& prediction, double now) {
    collision_forge::PredictedPatterns message;
    message.header.stamp = stampOf(now);
    message.header.frame_id = names::kMapFrame;
    for (const CollisionPattern& pattern : prediction.patterns) {
      message.patterns.push_back(toMessage(pattern, now));
    }
    patterns_.publish(message);
    has_patterns_ = !message.patterns.empty();
  }

  /// Publishes the expected path of the ego during the attack: predicted by the default method,
  /// else as recorded if available, else empty.
  void showEgoPath(const Moment& moment, const Track* expected,
                   const AttackerTrajectory& attacker) {
    if (!expected && moment.recorded) expected = &moment.recorded->ego;
    ego_paths_.publish(
        toPath(expected ? *expected : Track{}, moment.snapshot.now, attacker.points.back().time));
  }

  /// Publishes the attack.
  void start(const Moment& moment, const CollisionRequest& request, const Attack& answer,
             collision_forge::Attack& attack) {
    if (request.mode != Mode::kAdaptive) {
      live_->start(attack);
      return;
    }
    attack = live_->start(
        attack,
        {moment.snapshot,
         moment.lanes,
         {moment.snapshot.ego.size, config_.ego_vehicle.center_offset},
         request,
         answer.pattern,
         answer.trajectory,
         answer.effort},
        {std::make_shared<NetworkEgoFutures>(config_.attack.ego_futures, finder_->models()),
         config_.attack, config_.adaptive});
  }

  bool generateEach(collision_forge::GenerateCollisions::Request& message,
                    collision_forge::GenerateCollisions::Response& response) {
    return answerWith(response, [&]() -> Status {
      if (modeFromString(message.request.mode) == Mode::kAdaptive) {
        return {StatusCode::kInvalidInput,
                "mode = adaptive is not supported by generate_collisions: call "
                "generate_collision"};
      }
      return generateForEach(message, response, response.answers);
    });
  }

  bool list(collision_forge::ListCollisions::Request& message,
            collision_forge::ListCollisions::Response& response) {
    return answerWith(response, [&]() -> Status {
      std::vector<collision_forge::CollisionAnswer> answers;
      const Status status = generateForEach(message, response, answers);
      if (status.code != StatusCode::kOk) return status;
      return listPossible(answers, response.collisions);
    });
  }

  /// Runs one request per type and time of the message.
  template <typename Asked, typename Response>
  Status generateForEach(const Asked& message, Response& response,
                         std::vector<collision_forge::CollisionAnswer>& answers) const {
    const auto requests = requestsForEach(message.request, message.collision_types, message.ttas,
                                          config_.requests.ttas, config_.crash);
    if (const Status* refusal = std::get_if<Status>(&requests)) return *refusal;
    const auto found = momentAt(message.stamp);
    if (const Status* none = std::get_if<Status>(&found)) return *none;
    const Moment& moment = std::get<Moment>(found);
    const double now = moment.snapshot.now;
    response.now = stampOf(now);
    for (const CollisionRequest& request : std::get<std::vector<CollisionRequest>>(requests)) {
      answers.push_back(toMessage(request, finder_->answer(moment, request, message.method),
                                  nameOf(message.method), now));
    }
    return {};
  }

  /// Serves reset: waits for a running request, then drops the attack.
  bool reset(std_srvs::Trigger::Request& /*message*/, std_srvs::Trigger::Response& response) {
    const std::lock_guard<std::mutex> lock(shown_);
    response.success = static_cast<std::uint8_t>(true);
    response.message = forget() ? "the attack was removed" : "there was no attack";
    return true;
  }

  /// Returns true if this node had published an attack.
  bool forget() {
    if (has_patterns_) showPatterns({}, 0.0);
    return live_->end();
  }

  Config config_;
  RequestVocabulary vocabulary_;
  std::string configuration_;  // its fingerprint
  std::mutex shown_;           // serialises requests and resets
  bool has_patterns_ = false;  // patterns are published and not cleared
  std::unique_ptr<AttackFinder> finder_;
  std::unique_ptr<SceneMemory> scenes_;
  ros::Publisher patterns_;
  ros::Publisher attacks_;
  ros::Publisher attacker_paths_;
  ros::Publisher ego_paths_;
  ros::Publisher requests_;
  ros::Publisher methods_publisher_;
  std::unique_ptr<LiveAttacker> live_;
  ros::Subscriber scene_subscriber_;  // last, as its callbacks use the members above
  ros::WallTimer watch_;
  std::deque<OwnThreadService> services_;
};

using ServedCollisionGenerator = Served<CollisionGeneratorNodelet>;

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::ServedCollisionGenerator, nodelet::Nodelet)
