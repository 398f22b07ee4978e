#include <collision_forge/RealizeTrajectory.h>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include "attack/realizer.h"
#include "attack/request_check.h"
#include "ros/conversions.h"
#include "ros/node_support.h"
#include "ros/topic_names.h"

namespace forge {

/// Answers realize_trajectory.
class TrajectoryRealizerNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    options_ = loadNodeConfig(getPrivateNodeHandle()).attack;
    ros::NodeHandle& node = getNodeHandle();
    map_ = std::make_unique<LaneMapSubscriber>(node);
    service_ = std::make_unique<OwnThreadService>(node, names::kRealizeTrajectory,
                                                  &TrajectoryRealizerNodelet::answer, this);
  }

  bool answer(collision_forge::RealizeTrajectory::Request& message,
              collision_forge::RealizeTrajectory::Response& response) {
    const Status status = realizeInto(message, response);
    response.code = static_cast<std::uint8_t>(status.code);
    response.message = status.message;
    return true;
  }

  Status realizeInto(const collision_forge::RealizeTrajectory::Request& message,
                     collision_forge::RealizeTrajectory::Response& response) {
    const auto lanes = map_->lanes();
    if (!lanes) return {StatusCode::kNoScene, "trajectory_realizer has no lane_map"};
    const auto parsed = fromMessage(message.request);
    if (const Status* refusal = std::get_if<Status>(&parsed)) return *refusal;
    const auto& request = std::get<CollisionRequest>(parsed);
    try {
      const Snapshot snapshot = fromMessage(message.scene);
      const Status check = checkRequest(request, snapshot, options_.prediction);
      if (check.code != StatusCode::kOk) return check;
      const Future future = fromMessage(message.future);
      std::vector<CollisionPattern> patterns;
      for (const auto& pattern : message.patterns) patterns.push_back(fromMessage(pattern));
      const Realization realization =
          realize(patterns, {snapshot, future, request, *lanes}, options_);
      if (realization.status.code != StatusCode::kOk) return realization.status;
      response.pattern = toMessage(realization.pattern, snapshot.now);
      response.trajectory = toMessage(realization.trajectory);
      response.report =
          toMessage(realization.report, realization.trajectory.attacker_id, snapshot.now);
      return realization.status;
    } catch (const std::exception& error) {
      return {StatusCode::kInvalidInput, error.what()};
    }
  }

  AttackOptions options_;
  std::unique_ptr<LaneMapSubscriber> map_;
  std::unique_ptr<OwnThreadService> service_;
};

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::TrajectoryRealizerNodelet, nodelet::Nodelet)
