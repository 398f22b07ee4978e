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

/// Answers requests about moments of the scene by generateCollision(), as `forge inject` does. The
/// stages of the default method are the services predict_pattern and realize_trajectory, all other
/// methods run here. The private parameter `recording` names the bag on replay. A moment of that
/// bag is taken from the bag, with its past and future. Replay mode needs it; in the other modes,
/// too, a request is rejection if the recording ends before the contact. If the bag has an attack
/// already, every request is rejection. Thread-safe.
class AttackFinder {
 public:
  /// `config` must outlive it. Throws what the loading of methods and weights throws.
  AttackFinder(ros::NodeHandle& node, const ros::NodeHandle& private_node, const Config& config);

  const MethodRegistry& methods() const { return methods_; }
  const std::string& defaultMethod() const { return default_method_; }
  const PredictionModels& foresight() const { return foresight_; }

  /// The moment of a scene, or why there is none. Throws MessageError and InputError.
  std::variant<Moment, Status> momentOf(const collision_forge::SceneSnapshot& scene) const;

  /// An empty `method` is the default one, whose predictions `on_prediction` gets. Throws
  /// MessageError and InputError for what the services answer.
  Attack answer(
      const Moment& moment, const CollisionRequest& request, const std::string& method,
      const PatternPredictorService::OnPrediction& on_prediction = [](const auto&) {}) const;

  /// The bag on replay has an attack of its own.
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
  PredictionModels foresight_;
  std::string default_method_;
  std::optional<IndexedScene> recording_;
  std::string attack_in_recording_;  // why a bag with an attack is no recording; empty: it has none
  LaneMapSubscriber map_;
  mutable ServiceCaller predict_;
  mutable ServiceCaller realize_;
};

}  // namespace forge
