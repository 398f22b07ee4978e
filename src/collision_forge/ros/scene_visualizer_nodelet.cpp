#include <collision_forge/EncodedScene.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include "collision_forge/ros/markers.h"
#include "collision_forge/ros/node_support.h"
#include "collision_forge/ros/topic_names.h"

namespace forge {

/// Shows map, scene and attack in RViz.
class SceneVisualizerNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    ros::NodeHandle& node = getNodeHandle();
    map_markers_ = node.advertise<visualization_msgs::MarkerArray>(names::kMapMarkers, 1, true);
    scene_markers_ = node.advertise<visualization_msgs::MarkerArray>(names::kSceneMarkers, 1);
    pattern_markers_ =
        node.advertise<visualization_msgs::MarkerArray>(names::kPatternMarkers, 1, true);
    attack_markers_ =
        node.advertise<visualization_msgs::MarkerArray>(names::kAttackMarkers, 1, true);
    subscribers_ = {
        node.subscribe(names::kLaneMap, 1, &SceneVisualizerNodelet::onMap, this),
        node.subscribe(names::kEncodedScene, 1, &SceneVisualizerNodelet::onScene, this),
        node.subscribe(names::kPredictedPatterns, 1, &SceneVisualizerNodelet::onPredicted, this),
        node.subscribe(names::kAttack, 1, &SceneVisualizerNodelet::onAttack, this)};
  }

  void onMap(const collision_forge::LaneMapConstPtr& map) {
    map_markers_.publish(mapMarkers(*map));
  }

  void onScene(const collision_forge::EncodedSceneConstPtr& scene) {
    scene_ = scene;
    scene_markers_.publish(sceneMarkers(scene->snapshot));
    clearFutureAttack(*scene);
    if (attack_ && attack_->adaptive) showAttack();
  }

  /// Of the newest scene, as requests are.
  void onPredicted(const collision_forge::PredictedPatternsConstPtr& predicted) {
    if (predicted->patterns.empty()) {
      patterns_start_ = ros::Time();
      pattern_markers_.publish(noMarkers(predicted->header));
      return;
    }
    if (!scene_) return;
    pattern_markers_.publish(patternMarkers(*predicted, scene_->snapshot));
    patterns_start_ = predicted->header.stamp;
  }

  void onAttack(const collision_forge::AttackConstPtr& attack) {
    if (isNone(*attack)) {
      attack_.reset();
      attack_start_ = ros::Time();
      attack_markers_.publish(noMarkers(attack->header));
      return;
    }
    attack_ = attack;
    showAttack();
  }

  /// One that sees and reacts as driven up to the newest scene, and only from its now on: it comes
  /// again when the recording starts anew.
  void showAttack() {
    const ros::Time now = scene_ ? scene_->header.stamp : attack_->header.stamp;
    if (attack_->adaptive && now < attack_->header.stamp) return;
    attack_markers_.publish(attackMarkers(*attack_, now));
    attack_start_ = attack_->header.stamp;
  }

  /// A scene from before the attack was made means that the recording started anew.
  void clearFutureAttack(const collision_forge::EncodedScene& scene) {
    if (scene.header.stamp < patterns_start_) {
      pattern_markers_.publish(noMarkers(scene.header));
      patterns_start_ = ros::Time();
    }
    if (scene.header.stamp >= attack_start_) return;
    attack_markers_.publish(noMarkers(scene.header));
    attack_start_ = ros::Time();
  }

  ros::Publisher map_markers_;
  ros::Publisher scene_markers_;
  ros::Publisher pattern_markers_;
  ros::Publisher attack_markers_;
  collision_forge::EncodedSceneConstPtr scene_;
  collision_forge::AttackConstPtr attack_;
  ros::Time patterns_start_;  ///< "now" of the patterns that are shown; zero: none
  ros::Time attack_start_;    ///< "now" of the attack that is shown; zero: none
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::SceneVisualizerNodelet, nodelet::Nodelet)
