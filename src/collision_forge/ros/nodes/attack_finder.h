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
/// bag, with its past and future. Replay mode needs it. In every mode, a request at a moment of
/// that bag is rejected if the recording ends before the contact, and every request is rejected if
/// the recording already contains an attack. Subscribes to lane_map. Thread-safe.
class AttackFinder {
 public:
  /// `node` resolves the services and topics; `private_node` has the parameter `recording` (path of
  /// a bag; empty: none). `config` must outlive the object. Throws as loadMethods() and the loaders
  /// of weights. A recording that cannot be read is logged; replay mode is then rejected.
  AttackFinder(ros::NodeHandle& node, const ros::NodeHandle& private_node, const Config& config);

  /// Returns the available methods; valid as long as this object.
  const MethodRegistry& methods() const { return methods_; }
  /// Returns the name of the method that answer() uses if none is requested
  /// (forge::defaultMethod()).
  const std::string& defaultMethod() const { return default_method_; }
  /// Returns the models of the configuration; valid as long as this object.
  const PredictionModels& models() const { return models_; }

  /// Returns the moment at the t0 of `scene`. If the recording has a frame at that time (to 1 ms)
  /// with the same ego position (to 0.1 m), the moment comes from the recording, with its future
  /// and map; else it has the scene's states, no future, and the newest lane_map. In the second
  /// case returns kNoScene without a usable lane_map, for which the function waits as
  /// LaneMapSubscriber::lanesOfScene(). Throws MessageError and InputError for an unusable scene.
  std::variant<Moment, Status> momentOf(const collision_forge::SceneSnapshot& scene) const;

  /// Returns the attack for `request`, or a status with the reason of rejection: kInvalidInput for
  /// an unknown method, kNoRecording and kBeyondRecording as the class comment says, else the
  /// status of generateCollision(). `method`: a name of methods(); empty: the default. Only with
  /// the default method `on_prediction` is called, with each response of predict_pattern, in the
  /// calling thread. Throws MessageError and InputError for an unusable response of a service.
  Attack answer(
      const Moment& moment, const CollisionRequest& request, const std::string& method,
      const PatternPredictorService::OnPrediction& on_prediction = [](const auto&) {}) const;

  /// Returns true if the replayed bag already contains an attack; false without a recording.
  bool isRecordingAttacked() const { return !attack_in_recording_.empty(); }

 private:
  /// Sets `recording_` and `attack_in_recording_` from the bag at `path`; logs a failure.
  void loadRecording(const std::string& path);
  /// Runs the method without a check of the recording.
  Attack find(const Moment& moment, const CollisionRequest& request, const std::string& method,
              const PatternPredictorService::OnPrediction& on_prediction) const;
  /// Returns kOk, or why the recording does not allow the request.
  Status checkRecording(const Moment& moment, const CollisionRequest& request) const;
  /// Returns kOk, or kBeyondRecording for a contact after the end of the recording.
  Status checkContact(const Moment& moment, const CollisionReport& report) const;
  /// Returns the time (s) of the recorded frame that the snapshot shows; nullopt if there is none.
  std::optional<double> recordedFrame(const Snapshot& snapshot) const;
  /// Returns the time, s, from t0 to the last ego pose of the recording.
  double secondsLeft(const Moment& moment) const;

  const Config& config_;
  MethodRegistry methods_;
  PredictionModels models_;
  std::string default_method_;
  std::optional<IndexedScene> recording_;  // empty: not given, or not readable
  std::string attack_in_recording_;        // reason of rejection; empty: the bag has no attack
  LaneMapSubscriber map_;
  mutable ServiceCaller predict_;  // calls predict_pattern
  mutable ServiceCaller realize_;  // calls realize_trajectory
};

}  // namespace forge
