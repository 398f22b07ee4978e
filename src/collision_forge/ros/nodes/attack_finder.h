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

/// Generates attacks for scenes with generateCollision(), like `forge inject`. The default method
/// calls the services predict_pattern and realize_trajectory; all other methods run in-process.
/// The private parameter `recording` names the replayed bag: a moment of that bag is read from the
/// bag, with its past and future. Replay mode needs it. In every mode, a request is rejected if the
/// recording ends before the contact or already contains an attack. Thread-safe.
class AttackFinder {
 public:
  /// `node` resolves the services and topics. `config` must outlive the object. Throws as
  /// loadMethods() and the loaders of weights. A recording that cannot be read is logged; replay
  /// mode is then rejected.
  AttackFinder(ros::NodeHandle& node, const ros::NodeHandle& private_node, const Config& config);

  /// The available methods.
  const MethodRegistry& methods() const { return methods_; }
  /// Name of the method that answer() uses if none is requested.
  const std::string& defaultMethod() const { return default_method_; }
  /// The models of the configuration.
  const PredictionModels& models() const { return models_; }

  /// Returns the moment of `scene`, or the reason of rejection. Throws MessageError and InputError
  /// for an unusable scene.
  std::variant<Moment, Status> momentOf(const collision_forge::SceneSnapshot& scene) const;

  /// Returns the attack for `request`, or a status with the reason of rejection. An empty `method`
  /// selects the default; only then `on_prediction` is called, with each prediction. Throws
  /// MessageError and InputError for an unusable response of a service.
  Attack answer(
      const Moment& moment, const CollisionRequest& request, const std::string& method,
      const PatternPredictorService::OnPrediction& on_prediction = [](const auto&) {}) const;

  /// Returns true if the replayed bag already contains an attack.
  bool isRecordingAttacked() const { return !attack_in_recording_.empty(); }

 private:
  void loadRecording(const std::string& path);
  Attack find(const Moment& moment, const CollisionRequest& request, const std::string& method,
              const PatternPredictorService::OnPrediction& on_prediction) const;
  Status checkRecording(const Moment& moment, const CollisionRequest& request) const;
  Status checkContact(const Moment& moment, const CollisionReport& report) const;
  std::optional<double> recordedFrame(const Snapshot& snapshot) const;
  double secondsLeft(const Moment& moment) const;

  const Config& config_;
  MethodRegistry methods_;
  PredictionModels models_;
  std::string default_method_;
  std::optional<IndexedScene> recording_;
  std::string attack_in_recording_;  // reason of rejection; empty: the bag has no attack
  LaneMapSubscriber map_;
  mutable ServiceCaller predict_;
  mutable ServiceCaller realize_;
};

}  // namespace forge
