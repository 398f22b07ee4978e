#include <collision_forge/AttackMethods.h>
#include <collision_forge/EncodedScene.h>
#include <collision_forge/GenerateCollision.h>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include <cmath>
#include <mutex>
#include <optional>

#include "collision_forge/attack/alternatives.h"
#include "collision_forge/data/pattern_network_file.h"
#include "collision_forge/ros/bag_reader.h"
#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/live_attacker.h"
#include "collision_forge/ros/node_support.h"
#include "collision_forge/ros/service_search.h"
#include "collision_forge/ros/topic_names.h"

namespace forge {

/// The front door: answers generate_collision and publishes the attack. The default method goes by
/// way of predict_pattern and realize_trajectory, all others run here, and so do vehicles that are
/// added. An attacker that sees and reacts is driven here, too. Replay mode needs the private
/// parameter `recording`, the bag on replay.
class CollisionGeneratorNodelet : public nodelet::Nodelet {
 private:
  using Request = collision_forge::GenerateCollision::Request;
  using Response = collision_forge::GenerateCollision::Response;

  static constexpr double kWatchInterval = 0.5;      // s of the wall clock
  static constexpr std::uint32_t kSceneQueue = 100;  // scenes that may wait for an attacker's look

  void onInit() override {
    ros::NodeHandle& node = getNodeHandle();
    config_ = loadNodeConfig(getPrivateNodeHandle());
    loadLogged("methods", [&] {
      methods_ = loadMethods(config_);
      foresight_ = loadForesight(config_);
    });
    default_method_ = defaultMethod(foresight_.network != nullptr);
    loadRecording(config_.ego_vehicle);
    map_ = std::make_unique<LaneMapSubscriber>(node);
    search_ = std::make_unique<ServiceSearch>(node);
    attacks_ = node.advertise<collision_forge::Attack>(names::kAttack, 1, true);
    publishMethods(node);
    live_ = std::make_unique<LiveAttacker>(
        [this](const collision_forge::Attack& attack) { attacks_.publish(attack); });
    scene_subscriber_ = node.subscribe(names::kEncodedScene, kSceneQueue,
                                       &CollisionGeneratorNodelet::receive, this);
    watch_ = node.createWallTimer(ros::WallDuration(kWatchInterval),
                                  [this](const ros::WallTimerEvent& /*event*/) {
                                    attempt([this] { live_->watch(ros::Time::now().toSec()); });
                                  });
    service_ = std::make_unique<OwnThreadService>(node, names::kGenerateCollision,
                                                  &CollisionGeneratorNodelet::answer, this);
  }

  void loadRecording(const EgoVehicle& ego) {
    const auto path = getPrivateNodeHandle().param<std::string>("recording", "");
    if (path.empty()) return;
    std::vector<std::string> warnings;
    try {
      recording_ = readBag(path, ego, &warnings);
    } catch (const BagError& error) {
      NODELET_ERROR_STREAM("no replay mode: " << error.what());
    }
    for (const std::string& warning : warnings) NODELET_WARN_STREAM(path << ": " << warning);
  }

  void publishMethods(ros::NodeHandle& node) {
    collision_forge::AttackMethods message;
    message.default_method = default_method_;
    for (const MethodRegistry::Entry& entry : methods_.entries()) {
      message.names.push_back(entry.name);
      message.descriptions.push_back(entry.description);
    }
    methods_publisher_ =
        node.advertise<collision_forge::AttackMethods>(names::kAttackMethods, 1, true);
    methods_publisher_.publish(message);
  }

  void receive(const collision_forge::EncodedScene::ConstPtr& message) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      scene_ = message;
    }
    attempt(
        [&] { live_->see(newestFrame(fromMessage(message->snapshot)), ros::Time::now().toSec()); });
  }

  template <typename Look>
  void attempt(const Look& look) {
    try {
      look();
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM_THROTTLE(1.0, "the attacker cannot look: " << error.what());
    }
  }

  bool answer(Request& message, Response& response) {
    answerWith(response, [&] { return generate(message, response); });
    if (response.code != Response::OK) {
      NODELET_INFO_STREAM(toString(static_cast<StatusCode>(response.code))
                          << ": " << response.message);
    }
    return true;
  }

  collision_forge::EncodedScene::ConstPtr newestScene() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return scene_;
  }

  Status generate(const Request& message, Response& response) {
    const collision_forge::CollisionRequest asked = requestIn(message);
    const auto parsed = fromMessage(asked, config_.crash);
    if (const Status* refusal = std::get_if<Status>(&parsed)) return *refusal;
    const CollisionRequest& request = std::get<CollisionRequest>(parsed);
    if (message.adaptive && request.mode == Mode::kReplay) {
      return {StatusCode::kInvalidInput,
              "adaptive = true is not for mode = replay, which knows what comes"};
    }
    const std::string method = message.method.empty() ? default_method_ : message.method;
    if (!methods_.has(method)) {
      return {StatusCode::kInvalidInput,
              "method = \"" + method + "\" is none of the topic attack_methods"};
    }
    const auto scene = newestScene();
    if (!scene) {
      return {StatusCode::kNoScene,
              "no encoded_scene yet: agents, lane_map and /tf must be published"};
    }
    if (request.mode == Mode::kAdaptive && !map_->lanes()) return noMap();
    const Status status = findAttack(method, *scene, asked, request, response);
    if (status.code == StatusCode::kOk) setOut(scene->snapshot, request, response.attack);
    return status;
  }

  static Status noMap() { return {StatusCode::kNoScene, "no usable lane_map has come yet"}; }

  /// Publishes the attack.
  void setOut(const collision_forge::SceneSnapshot& scene, const CollisionRequest& request,
              collision_forge::Attack& attack) {
    if (request.mode != Mode::kAdaptive) {
      live_->setOut(attack);
      return;
    }
    attack = live_->setOut(
        attack,
        {fromMessage(scene), map_->lanes(), config_.ego_vehicle, request,
         fromMessage(attack.pattern), fromMessage(attack.trajectory)},
        {foresight_.egoFutures(config_.attack.ego_futures), config_.attack, config_.adaptive});
  }

  Status findAttack(const std::string& method, const collision_forge::EncodedScene& scene,
                    const collision_forge::CollisionRequest& asked, const CollisionRequest& request,
                    Response& response) const {
    std::optional<Future> recorded;
    if (request.mode == Mode::kReplay) {
      const Status status = findRecorded(scene.header.stamp.toSec(), recorded);
      if (status.code != StatusCode::kOk) return status;
    }
    if (method != default_method_ || request.choice == AttackerChoice::kNew) {
      return generateHere(method, scene.snapshot, request, recorded, response);
    }
    Status status = search_->generate(scene.snapshot, asked, recorded, response.attack);
    response.attack.method = method;
    if (mayBeAnsweredHere(status, request)) {
      CollisionRequest again = request;
      again.alternatives = 1;
      const Status here = generateHere(method, scene.snapshot, again, recorded, response);
      if (here.code == StatusCode::kOk) status = here;
    }
    if (status.code == StatusCode::kOk && request.alternatives > 1) {
      addAlternatives(method, scene.snapshot, request, recorded, response);
    }
    return status;
  }

  /// Nobody who is there attacks as asked along a route, and the services know of no others: a new
  /// vehicle may, or somebody by any other motion.
  static bool mayBeAnsweredHere(const Status& status, const CollisionRequest& request) {
    if (!request.crash.believable) return false;
    return status.code == StatusCode::kNoCandidate ||
           status.code == StatusCode::kNoAttackWithinLimits ||
           status.code == StatusCode::kNotBelievable || status.code == StatusCode::kLowConfidence;
  }

  Status generateHere(const std::string& name, const collision_forge::SceneSnapshot& scene,
                      const CollisionRequest& request, const std::optional<Future>& recorded,
                      Response& response) const {
    const auto lanes = map_->lanes();
    if (!lanes) return noMap();
    const Moment moment{fromMessage(scene), recorded, lanes};
    const auto method = MethodMaker(name, methods_, config_.attack, foresight_).make();
    const Realization found =
        generateCollision(*method, moment, request, config_.attack.prediction);
    if (found.status.code != StatusCode::kOk) return found.status;
    response.attack = toMessage(found, name, moment.snapshot.now);
    setAlternatives(found.alternatives, name, moment.snapshot.now, response);
    return found.status;
  }

  /// Further attacks beside that of the response.
  void addAlternatives(const std::string& name, const collision_forge::SceneSnapshot& scene,
                       const CollisionRequest& request, const std::optional<Future>& recorded,
                       Response& response) const {
    const auto lanes = map_->lanes();
    if (!lanes) return;
    const Moment moment{fromMessage(scene), recorded, lanes};
    const auto method = MethodMaker(name, methods_, config_.attack, foresight_).make();
    Realization first;
    first.trajectory = fromMessage(response.attack.trajectory);
    first.report.manoeuvre = manoeuvreFromString(response.attack.report.manoeuvre).value();
    setAlternatives(findAlternatives(first, *method, moment, request, config_.attack.prediction),
                    name, moment.snapshot.now, response);
  }

  static void setAlternatives(const std::vector<Realization>& found, const std::string& method,
                              double now, Response& response) {
    for (const Realization& alternative : found) {
      response.alternatives.push_back(toMessage(alternative, method, now));
    }
  }

  Status findRecorded(double now, std::optional<Future>& recorded) const {
    if (!recording_) {
      return {StatusCode::kNoRecording,
              "mode = replay needs the parameter recording, the bag on replay"};
    }
    constexpr double kFrameTolerance = 1e-3;  // s
    const auto frame = lastFrameTime(*recording_, now);
    if (!frame || std::abs(*frame - now) > kFrameTolerance) {
      return {StatusCode::kNoRecording, "recording \"" + recording_->name +
                                            "\" has no frame at now = " + std::to_string(now) +
                                            " s: is another bag playing?"};
    }
    recorded = recordedFuture(*recording_, *frame);
    return {};
  }

  Config config_;
  MethodRegistry methods_;
  Foresight foresight_;
  std::string default_method_;
  std::optional<Scene> recording_;
  std::unique_ptr<LaneMapSubscriber> map_;
  std::unique_ptr<ServiceSearch> search_;
  std::mutex mutex_;
  collision_forge::EncodedScene::ConstPtr scene_;  // the newest, behind the mutex
  ros::Publisher attacks_;
  ros::Publisher methods_publisher_;
  std::unique_ptr<LiveAttacker> live_;
  ros::Subscriber scene_subscriber_;  // these two last: they call what is above
  ros::WallTimer watch_;
  std::unique_ptr<OwnThreadService> service_;
};

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::CollisionGeneratorNodelet, nodelet::Nodelet)
