#include <collision_forge/PredictPattern.h>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include <optional>

#include "attack/pattern_predictor.h"
#include "attack/request_check.h"
#include "ros/conversions.h"
#include "ros/node_support.h"
#include "ros/topic_names.h"

namespace forge {

/// Answers predict_pattern.
class PatternPredictorNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    options_ = loadNodeConfig(getPrivateNodeHandle()).attack;
    predictor_ = std::make_unique<KinematicPatternPredictor>(options_);
    ros::NodeHandle& node = getNodeHandle();
    map_ = std::make_unique<LaneMapSubscriber>(node);
    service_ = std::make_unique<OwnThreadService>(node, names::kPredictPattern,
                                                  &PatternPredictorNodelet::answer, this);
  }

  bool answer(collision_forge::PredictPattern::Request& message,
              collision_forge::PredictPattern::Response& response) {
    const Status status = predict(message, response);
    response.code = static_cast<std::uint8_t>(status.code);
    response.message = status.message;
    return true;
  }

  Status predict(const collision_forge::PredictPattern::Request& message,
                 collision_forge::PredictPattern::Response& response) {
    const auto lanes = map_->lanes();
    if (!lanes) return {StatusCode::kNoScene, "pattern_predictor has no lane_map"};
    const auto parsed = fromMessage(message.request);
    if (const Status* refusal = std::get_if<Status>(&parsed)) return *refusal;
    const auto& request = std::get<CollisionRequest>(parsed);
    try {
      const Snapshot snapshot = fromMessage(message.scene);
      const Status check = checkRequest(request, snapshot, options_.prediction);
      if (check.code != StatusCode::kOk) return check;
      std::optional<Future> recorded;
      if (request.mode == Mode::kReplay) recorded = fromMessage(message.recorded_future);
      const PatternPrediction prediction =
          predictor_->predict(snapshot, *lanes, request, recorded ? &*recorded : nullptr);
      for (const CollisionPattern& pattern : prediction.patterns) {
        response.patterns.push_back(toMessage(pattern, snapshot.now));
      }
      response.future = toMessage(prediction.future);
      return prediction.status;
    } catch (const std::exception& error) {
      return {StatusCode::kInvalidInput, error.what()};
    }
  }

  AttackOptions options_;
  std::unique_ptr<PatternPredictor> predictor_;
  std::unique_ptr<LaneMapSubscriber> map_;
  std::unique_ptr<OwnThreadService> service_;
};

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::PatternPredictorNodelet, nodelet::Nodelet)
