#include <collision_forge/RealizeTrajectory.h>
#include <pluginlib/class_list_macros.hpp>

#include "collision_forge/attack/search/realizer.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/nodes/node_support.h"
#include "collision_forge/ros/nodes/served_nodelet.h"

namespace forge {

/// Serves realize_trajectory with the built-in realizer.
class TrajectoryRealizerNodelet : public QueuedNodelet {
 private:
  void start(ros::NodeHandle node) override {
    config_ = loadNodeConfig(getPrivateNodeHandle());
    map_ = std::make_unique<LaneMapSubscriber>(node, config_.input_limits);
    service_ = std::make_unique<OwnThreadService>(node, names::kRealizeTrajectory,
                                                  &TrajectoryRealizerNodelet::answer, this);
  }

  bool answer(collision_forge::RealizeTrajectory::Request& message,
              collision_forge::RealizeTrajectory::Response& response) {
    return answerWith(response, [&] { return realizeInto(message, response); });
  }

  Status realizeInto(const collision_forge::RealizeTrajectory::Request& message,
                     collision_forge::RealizeTrajectory::Response& response) {
    const auto checked = checkedRequest(*map_, message.scene, message.request, config_);
    if (const Status* refusal = std::get_if<Status>(&checked)) return *refusal;
    const auto& [lanes, snapshot, request] = std::get<CheckedRequest>(checked);
    Future future = fromMessage(message.future);
    checkFuture(future, config_.input_limits, "future");
    std::vector<CollisionPattern> patterns;
    for (const auto& pattern : message.patterns) {
      patterns.push_back(fromMessage(pattern));
      checkPattern(patterns.back(), config_.input_limits, "patterns");
    }
    AttackerPaths ways;
    for (const auto& way : message.ways) ways.emplace(way.attacker_id, fromMessage(way));
    const Attack realization =
        realize({patterns,
                 {snapshot, future, request, *lanes},
                 static_cast<bool>(message.exact),
                 ways,
                 message.any_motion ? SearchedMotion::kAny : SearchedMotion::kByRoutes},
                config_.attack);
    if (realization.status.code != StatusCode::kOk) return realization.status;
    response.attack = toMessage(realization, "", snapshot.now);
    return realization.status;
  }

  Config config_;
  std::unique_ptr<LaneMapSubscriber> map_;
  std::unique_ptr<OwnThreadService> service_;
};

using ServedTrajectoryRealizer = Served<TrajectoryRealizerNodelet>;

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::ServedTrajectoryRealizer, nodelet::Nodelet)
