#pragma once

#include <collision_forge/SceneSnapshot.h>
#include <ros/ros.h>

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "collision_forge/base/scene/moment.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/nodes/node_support.h"
#include "collision_forge/ros/nodes/stage_services.h"

namespace forge {

/// Runs generateCollision() for a scene received by ROS, as `forge inject` does for a recording.
/// The default method calls the services predict_pattern and realize_trajectory; all other methods
/// run in this process. The private parameter `recording` names the bag on replay: if the scene is
/// a frame of that bag, its past and future come from the bag. Mode replay requires the bag. In
/// every mode a request is rejected if the bag ends before the contact, or if it already contains
/// an attack. Thread-safe.
class AttackFinder {
 public:
  /// `config` must outlive the object. Throws the exceptions of loadMethods() and loadForesight().
  /// A recording that cannot be read is logged and ignored.
  AttackFinder(ros::NodeHandle& node, const ros::NodeHandle& private_node, const Config& config);

  const MethodRegistry& methods() const { return methods_; }
  const std::string& defaultMethod() const { return default_method_; }
  const Foresight& foresight() const { return foresight_; }

  /// Returns the moment for `scene`, or kNoScene if no usable lane map has arrived. Throws
  /// MessageError and InputError if the scene is invalid.
  std::variant<Moment, Status> momentOf(const collision_forge::SceneSnapshot& scene) const;

  /// Returns the attack for `request`, or a rejection with its reason. An empty `method` selects
  /// the default one; only that calls `on_prediction`, with each prediction, in the calling thread.
  /// Throws MessageError and InputError if a service returns invalid data.
  Realization answer(
      const Moment& moment, const CollisionRequest& request, const std::string& method,
      const PatternPredictorService::OnPrediction& on_prediction = [](const auto&) {}) const;

  /// Returns true if the bag on replay already contains an attack.
  bool isRecordingAttacked() const { return !attack_in_recording_.empty(); }

 private:
  void loadRecording(const std::string& path);
  Realization find(const Moment& moment, const CollisionRequest& request, const std::string& method,
                   const PatternPredictorService::OnPrediction& on_prediction) const;
  Status checkRecording(const Moment& moment, const CollisionRequest& request) const;
  Status checkContact(const Moment& moment, const CollisionReport& report) const;
  std::optional<double> recordedFrame(const Snapshot& snapshot) const;
  double secondsLeft(const Moment& moment) const;

  const Config& config_;
  MethodRegistry methods_;
  Foresight foresight_;
  std::string default_method_;
  std::optional<IndexedScene> recording_;
  std::string attack_in_recording_;  // reason for rejecting every request; empty: none
  LaneMapSubscriber map_;
  mutable ServiceCaller predict_;
  mutable ServiceCaller realize_;
};

}  // namespace forge
