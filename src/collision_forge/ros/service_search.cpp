#include "collision_forge/ros/service_search.h"

#include <collision_forge/PredictPattern.h>
#include <collision_forge/PredictedPatterns.h>
#include <collision_forge/RealizeTrajectory.h>

#include <chrono>
#include <future>
#include <utility>

#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/topic_names.h"

namespace forge {
namespace {

constexpr std::chrono::seconds kAnswerTimeout{10};  // hundreds of times the usual

/// True when the service has answered within kAnswerTimeout.
template <typename Service>
bool callOnce(const std::string& name, Service& service) {
  // A persistent client, because shutting it down ends a call that is under way.
  ros::ServiceClient client = ros::NodeHandle().serviceClient<Service>(name, true);
  auto answer = std::async(std::launch::async, [&] { return client.call(service); });
  if (answer.wait_for(kAnswerTimeout) == std::future_status::timeout) client.shutdown();
  return answer.get();
}

/// roscpp loses a connection now and then (seen: 1 call in 20,000). The nodes behind answer the
/// same again, so a call that failed at once is tried once more.
template <typename Service>
Status callService(const std::string& name, Service& service) {
  const auto start = std::chrono::steady_clock::now();
  const bool is_answered =
      callOnce(name, service) ||
      (std::chrono::steady_clock::now() - start < kAnswerTimeout && callOnce(name, service));
  if (!is_answered) {
    return {StatusCode::kNodeUnavailable, "the node behind " + name + " does not answer"};
  }
  return {static_cast<StatusCode>(service.response.code), service.response.message};
}

}  // namespace

ServiceSearch::ServiceSearch(ros::NodeHandle& node)
    : predict_name_(node.resolveName(names::kPredictPattern)),
      realize_name_(node.resolveName(names::kRealizeTrajectory)),
      patterns_(
          node.advertise<collision_forge::PredictedPatterns>(names::kPredictedPatterns, 1, true)) {}

Status ServiceSearch::generate(const collision_forge::SceneSnapshot& scene,
                               const collision_forge::CollisionRequest& request,
                               const std::optional<Future>& recorded,
                               collision_forge::Attack& attack) const {
  collision_forge::PredictPattern predict;
  predict.request.scene = scene;
  predict.request.request = request;
  if (recorded) predict.request.recorded_future = toMessage(*recorded);
  const Status predicted = callService(predict_name_, predict);
  if (predicted.code != StatusCode::kOk) {
    forgetPatterns();
    return predicted;
  }

  collision_forge::PredictedPatterns patterns;
  patterns.header = scene.header;
  patterns.patterns = predict.response.patterns;
  patterns_.publish(patterns);
  has_patterns_ = true;

  collision_forge::RealizeTrajectory realize;
  realize.request.scene = std::move(predict.request.scene);
  realize.request.request = request;
  realize.request.patterns = std::move(predict.response.patterns);
  realize.request.future = std::move(predict.response.future);
  const Status realized = callService(realize_name_, realize);
  if (realized.code == StatusCode::kOk) attack = std::move(realize.response.attack);
  return realized;
}

void ServiceSearch::forgetPatterns() const {
  if (has_patterns_.exchange(false)) patterns_.publish(collision_forge::PredictedPatterns());
}

}  // namespace forge
