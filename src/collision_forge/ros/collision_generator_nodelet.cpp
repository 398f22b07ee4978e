#include <collision_forge/EncodedScene.h>
#include <collision_forge/GenerateCollision.h>
#include <collision_forge/PredictPattern.h>
#include <collision_forge/PredictedPatterns.h>
#include <collision_forge/RealizeTrajectory.h>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include <chrono>
#include <cmath>
#include <future>
#include <mutex>
#include <optional>

#include "collision_forge/attack/request_check.h"
#include "collision_forge/ros/bag_reader.h"
#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/node_support.h"
#include "collision_forge/ros/topic_names.h"

namespace forge {

/// The front door: answers generate_collision by way of predict_pattern and realize_trajectory and
/// publishes what came out. Replay mode needs the private parameter `recording`, the bag on replay.
class CollisionGeneratorNodelet : public nodelet::Nodelet {
 private:
  using Request = collision_forge::GenerateCollision::Request;
  using Response = collision_forge::GenerateCollision::Response;
  static constexpr std::chrono::seconds kAnswerTimeout{10};  // hundreds of times the usual

  void onInit() override {
    ros::NodeHandle& node = getNodeHandle();
    const Config config = loadNodeConfig(getPrivateNodeHandle());
    options_ = config.attack;
    loadRecording(config.ego_vehicle);
    predicted_publisher_ =
        node.advertise<collision_forge::PredictedPatterns>(names::kPredictedPatterns, 1, true);
    pattern_publisher_ =
        node.advertise<collision_forge::CollisionPattern>(names::kCollisionPattern, 1, true);
    trajectory_publisher_ =
        node.advertise<collision_forge::AttackerTrajectory>(names::kAttackerTrajectory, 1, true);
    report_publisher_ =
        node.advertise<collision_forge::CollisionReport>(names::kCollisionReport, 1, true);
    scene_subscriber_ =
        node.subscribe(names::kEncodedScene, 1, &CollisionGeneratorNodelet::receive, this);
    predict_name_ = node.resolveName(names::kPredictPattern);
    realize_name_ = node.resolveName(names::kRealizeTrajectory);
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

  void receive(const collision_forge::EncodedScene::ConstPtr& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    scene_ = message;
  }

  bool answer(Request& message, Response& response) {
    const Status status = generate(message, response);
    response.code = static_cast<std::uint8_t>(status.code);
    response.message = status.message;
    if (status.code != StatusCode::kOk) {
      NODELET_INFO_STREAM(toString(status.code) << ": " << status.message);
      return true;
    }
    pattern_publisher_.publish(response.pattern);
    trajectory_publisher_.publish(response.trajectory);
    report_publisher_.publish(response.report);
    return true;
  }

  collision_forge::EncodedScene::ConstPtr newestScene() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return scene_;
  }

  Status generate(const Request& message, Response& response) {
    collision_forge::PredictPattern predict;
    collision_forge::CollisionRequest& asked = predict.request.request;
    asked.collision_type = message.collision_type;
    asked.tta = message.tta;
    asked.attacker_id = message.attacker_id;
    asked.mode = message.mode;
    asked.seed = message.seed;
    const auto parsed = fromMessage(asked);
    if (const Status* refusal = std::get_if<Status>(&parsed)) return *refusal;
    const auto& request = std::get<CollisionRequest>(parsed);

    const auto scene = newestScene();
    if (!scene) {
      return {StatusCode::kNoScene,
              "no encoded_scene yet: agents, lane_map and /tf must be published"};
    }
    const Status check = checkRequest(request, fromMessage(*scene), options_.prediction);
    if (check.code != StatusCode::kOk) return check;
    if (request.mode == Mode::kReplay) {
      const Status status =
          fillRecorded(scene->header.stamp.toSec(), predict.request.recorded_future);
      if (status.code != StatusCode::kOk) return status;
    }
    predict.request.scene = *scene;
    return predictAndRealize(predict, response);
  }

  Status predictAndRealize(collision_forge::PredictPattern& predict, Response& response) {
    if (!callService(predict_name_, predict)) return unavailable(predict_name_);
    if (predict.response.code != Response::OK) return statusOf(predict.response);

    collision_forge::PredictedPatterns predicted;
    predicted.header = predict.request.scene.header;
    predicted.patterns = predict.response.patterns;
    predicted_publisher_.publish(predicted);
    collision_forge::RealizeTrajectory realize;
    realize.request.scene = std::move(predict.request.scene);
    realize.request.request = predict.request.request;
    realize.request.patterns = std::move(predict.response.patterns);
    realize.request.future = std::move(predict.response.future);
    if (!callService(realize_name_, realize)) return unavailable(realize_name_);
    if (realize.response.code != Response::OK) return statusOf(realize.response);
    response.pattern = std::move(realize.response.pattern);
    response.trajectory = std::move(realize.response.trajectory);
    response.report = std::move(realize.response.report);
    return {};
  }

  Status fillRecorded(double now, collision_forge::Future& future) const {
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
    future = toMessage(recordedFuture(*recording_, *frame));
    return {};
  }

  /// True when the service has answered within kAnswerTimeout.
  template <typename Service>
  static bool callOnce(const std::string& name, Service& service) {
    // A persistent client, because shutting it down ends a call that is under way.
    ros::ServiceClient client = ros::NodeHandle().serviceClient<Service>(name, true);
    auto answer = std::async(std::launch::async, [&] { return client.call(service); });
    if (answer.wait_for(kAnswerTimeout) == std::future_status::timeout) client.shutdown();
    return answer.get();
  }

  /// roscpp loses a connection now and then (seen: 1 call in 20,000). The nodes behind answer the
  /// same again, so a call that failed at once is tried once more.
  template <typename Service>
  static bool callService(const std::string& name, Service& service) {
    const auto start = std::chrono::steady_clock::now();
    if (callOnce(name, service)) return true;
    return std::chrono::steady_clock::now() - start < kAnswerTimeout && callOnce(name, service);
  }

  static Status unavailable(const std::string& service) {
    return {StatusCode::kNodeUnavailable, "the node behind " + service + " does not answer"};
  }

  template <typename ServiceResponse>
  static Status statusOf(const ServiceResponse& response) {
    return {static_cast<StatusCode>(response.code), response.message};
  }

  AttackOptions options_;
  std::optional<Scene> recording_;
  std::mutex mutex_;
  collision_forge::EncodedScene::ConstPtr scene_;
  std::string predict_name_;
  std::string realize_name_;
  ros::Subscriber scene_subscriber_;
  ros::Publisher predicted_publisher_;
  ros::Publisher pattern_publisher_;
  ros::Publisher trajectory_publisher_;
  ros::Publisher report_publisher_;
  std::unique_ptr<OwnThreadService> service_;
};

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::CollisionGeneratorNodelet, nodelet::Nodelet)
