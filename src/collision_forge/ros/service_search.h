#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionRequest.h>
#include <collision_forge/SceneSnapshot.h>
#include <ros/ros.h>

#include <atomic>
#include <optional>

#include "collision_forge/ros/service_caller.h"
#include "collision_forge/scene/collision_request.h"
#include "collision_forge/scene/scene.h"

namespace forge {

/// The suite's own method over services: predict_pattern says where ego and attacker may stand,
/// realize_trajectory drives there. Either may be answered by a node outside this package.
class ServiceSearch {
 public:
  /// Publishes the patterns of every request on predicted_patterns. `answer_within`: s of the wall
  /// clock for either service.
  ServiceSearch(ros::NodeHandle& node, double answer_within);

  /// Fills `attack` with kOk only. Whether the request can be met at all is checked by those who
  /// answer the services; kNodeUnavailable when one does not answer.
  Status generate(const collision_forge::SceneSnapshot& scene,
                  const collision_forge::CollisionRequest& request,
                  const std::optional<Future>& recorded, collision_forge::Attack& attack) const;

  /// Publishes that there are no patterns, where there were some.
  void forgetPatterns() const;

 private:
  mutable ServiceCaller predict_;
  mutable ServiceCaller realize_;
  ros::Publisher patterns_;
  mutable std::atomic<bool> has_patterns_{false};
};

}  // namespace forge
