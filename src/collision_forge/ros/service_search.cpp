#include "collision_forge/ros/service_search.h"

#include <collision_forge/PredictPattern.h>
#include <collision_forge/PredictedPatterns.h>
#include <collision_forge/RealizeTrajectory.h>

#include <utility>

#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/topic_names.h"

namespace forge {

ServiceSearch::ServiceSearch(ros::NodeHandle& node, double answer_within)
    : predict_(node.resolveName(names::kPredictPattern), answer_within),
      realize_(node.resolveName(names::kRealizeTrajectory), answer_within),
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
  const Status predicted = predict_.call(predict);
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
  const Status realized = realize_.call(realize);
  if (realized.code == StatusCode::kOk) attack = std::move(realize.response.attack);
  return realized;
}

void ServiceSearch::forgetPatterns() const {
  if (has_patterns_.exchange(false)) patterns_.publish(collision_forge::PredictedPatterns());
}

}  // namespace forge
