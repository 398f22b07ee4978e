#pragma once

#include <collision_forge/CollisionAnswer.h>
#include <ros/ros.h>

#include <memory>
#include <optional>
#include <string>

#include "collision_forge/data/pattern_network_file.h"
#include "collision_forge/ros/node_support.h"
#include "collision_forge/ros/service_search.h"
#include "collision_forge/scene/moment.h"
#include "collision_forge/settings/config.h"

namespace forge {

/// Answers what is asked of a scene. The default method goes by way of predict_pattern and
/// realize_trajectory, all others run here, and so do vehicles that are added. The private
/// parameter `recording` names the bag on replay. Replay mode needs it; in the other modes a
/// request about one of its frames is declined if the recording ends before the impact. If that bag
/// has an attack already, every request is declined. Thread-safe.
class AttackFinder {
 public:
  /// `config` must outlive it. Throws what the loading of methods and weights throws.
  AttackFinder(ros::NodeHandle& node, const ros::NodeHandle& private_node, const Config& config);

  const MethodRegistry& methods() const { return methods_; }
  const std::string& defaultMethod() const { return default_method_; }
  const Foresight& foresight() const { return foresight_; }
  /// Null until a usable map has come.
  std::shared_ptr<const LaneIndex> lanes() const { return map_.lanes(); }

  /// Type, tta, code and message are always filled in, attack, alternatives and summary with kOk
  /// alone.
  /// An empty `method` is the default one. Throws what the conversion of messages throws.
  collision_forge::CollisionAnswer answer(const collision_forge::SceneSnapshot& scene,
                                          const collision_forge::CollisionRequest& asked,
                                          const std::string& method) const;

  /// What the ego drives in an answer to the request: as recorded in replay mode, else the
  /// likeliest of the futures that the default method foresees.
  Track egoFuture(const Snapshot& snapshot, const CollisionRequest& request) const;

  /// The bag on replay has an attack of its own.
  bool isRecordingAttacked() const { return !attack_in_recording_.empty(); }

  /// Takes the patterns of the last request from predicted_patterns.
  void forgetPatterns() const { search_.forgetPatterns(); }

 private:
  void loadRecording(const std::string& path);
  Status find(const std::string& method, const collision_forge::SceneSnapshot& scene,
              collision_forge::CollisionRequest asked,
              collision_forge::CollisionAnswer& answer) const;
  Status generateHere(const std::string& name, const Moment& moment,
                      const CollisionRequest& request,
                      collision_forge::CollisionAnswer& answer) const;
  void addAlternatives(const std::string& name, const Moment& moment,
                       const CollisionRequest& request,
                       collision_forge::CollisionAnswer& answer) const;
  Status checkRecording(const CollisionRequest& request, Moment& moment) const;
  Status checkContact(const collision_forge::CollisionReport& report) const;
  std::optional<double> recordedFrame(double now) const;

  const Config& config_;
  MethodRegistry methods_;
  Foresight foresight_;
  std::string default_method_;
  std::optional<Scene> recording_;
  std::string attack_in_recording_;  // why a bag with an attack is no recording; empty: it has none
  LaneMapSubscriber map_;
  ServiceSearch search_;
};

}  // namespace forge
