#include <collision_forge/PredictPattern.h>
#include <pluginlib/class_list_macros.hpp>

#include <optional>

#include "collision_forge/attack/network/network_pattern_predictor.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/nodes/node_support.h"
#include "collision_forge/ros/nodes/served_nodelet.h"

namespace forge {

/// Serves predict_pattern with the built-in predictor.
class PatternPredictorNodelet : public QueuedNodelet {
 private:
  void start(ros::NodeHandle node) override {
    config_ = loadNodeConfig(getPrivateNodeHandle());
    predictor_ = loadLogged("prediction models", [&] {
      return std::make_unique<NetworkPatternPredictor>(config_.attack,
                                                       loadPredictionModels(config_));
    });
    map_ = std::make_unique<LaneMapSubscriber>(node, config_.input_limits);
    service_ = std::make_unique<OwnThreadService>(node, names::kPredictPattern,
                                                  &PatternPredictorNodelet::answer, this);
  }

  bool answer(collision_forge::PredictPattern::Request& message,
              collision_forge::PredictPattern::Response& response) {
    return answerWith(response, [&] { return predict(message, response); });
  }

  Status predict(const collision_forge::PredictPattern::Request& message,
                 collision_forge::PredictPattern::Response& response) {
    const auto checked = checkedRequest(*map_, message.scene, message.request, config_);
    if (const Status* refusal = std::get_if<Status>(&checked)) return *refusal;
    const auto& [lanes, snapshot, request] = std::get<CheckedRequest>(checked);
    std::optional<Future> recorded;
    if (request.mode == Mode::kReplay) {
      recorded = fromMessage(message.recorded_future);
      checkFuture(*recorded, config_.input_limits, "recorded_future");
    }
    const PatternPrediction prediction =
        predictor_->predict(snapshot, *lanes, request, recorded ? &*recorded : nullptr);
    for (const CollisionPattern& pattern : prediction.patterns) {
      response.patterns.push_back(toMessage(pattern, snapshot.now));
    }
    response.future = toMessage(prediction.future);
    return prediction.status;
  }

  Config config_;
  std::unique_ptr<const PatternPredictor> predictor_;
  std::unique_ptr<LaneMapSubscriber> map_;
  std::unique_ptr<OwnThreadService> service_;
};

using ServedPatternPredictor = Served<PatternPredictorNodelet>;

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::ServedPatternPredictor, nodelet::Nodelet)
