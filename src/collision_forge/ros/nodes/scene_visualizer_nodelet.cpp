#include <collision_forge/EncodedScene.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "collision_forge/attack/verify/contact_watch.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/ros/injection/after_contact.h"
#include "collision_forge/ros/markers/crash_words.h"
#include "collision_forge/ros/markers/live_scene.h"
#include "collision_forge/ros/markers/marker_parts.h"
#include "collision_forge/ros/markers/markers.h"
#include "collision_forge/ros/markers/repeated_markers.h"
#include "collision_forge/ros/markers/shown_motion.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/nodes/ego_poses.h"
#include "collision_forge/ros/nodes/node_support.h"
#include "collision_forge/ros/nodes/served_nodelet.h"

namespace forge {

/// Publishes markers of map, scene and attack for RViz. Markers depend only on time, newest scene,
/// ego poses and attack, so a jump of the clock needs no reset. The contact is detected here
/// (ContactWatch), because tested_report is published only after the next agents.
class SceneVisualizerNodelet : public QueuedNodelet {
 private:
  static constexpr double kPictureRate = 20.0;  // Hz, of the wall clock

  void start(ros::NodeHandle node) override {
    const Config config = loadNodeConfig(getPrivateNodeHandle());
    limits_ = config.input_limits;
    after_contact_ =
        loadLogged("choice", [this] { return nodeAfterContact(getPrivateNodeHandle()); });
    severity_ = config.attack.verification.severity;
    watch_.emplace(config.ego_vehicle.size, config.live.maxAttackAge(), config.attack.verification);
    map_markers_ = RepeatedMarkers(node, names::kMapMarkers);
    light_markers_ = RepeatedMarkers(node, names::kLightMarkers);
    scene_markers_ = node.advertise<visualization_msgs::MarkerArray>(names::kSceneMarkers, 1);
    pattern_markers_ = RepeatedMarkers(node, names::kPatternMarkers);
    attack_markers_ = RepeatedMarkers(node, names::kAttackMarkers);
    areas_ = node.advertise<geometry_msgs::PolygonStamped>(names::kShownArea, 1);
    subscribers_ = {
        node.subscribe(names::kLaneMap, 1, &SceneVisualizerNodelet::onMap, this),
        node.subscribe(names::kTrafficLights, 1, &SceneVisualizerNodelet::onLights, this),
        node.subscribe(names::kEncodedScene, 1, &SceneVisualizerNodelet::onScene, this),
        node.subscribe(names::kPredictedPatterns, 1, &SceneVisualizerNodelet::onPredicted, this),
        node.subscribe(names::kAttack, 1, &SceneVisualizerNodelet::onAttack, this),
        node.subscribe(names::kTestedReport, 1, &SceneVisualizerNodelet::onTested, this),
        node.subscribe(names::kPlannerTestShown, 1, &SceneVisualizerNodelet::onPlannerTest, this)};
    ego_poses_ = std::make_unique<EgoPoses>(node, config.ego_vehicle,
                                            [this](const AgentState& ego, const BoxSize& size) {
                                              watch_->setEgoSize(size);
                                              watch_->addEgo(ego);
                                            });
    // A wall timer: subscribers that start while the replay is paused receive the picture, too.
    timer_ = node.createWallTimer(ros::WallDuration(1.0 / kPictureRate),
                                  &SceneVisualizerNodelet::show, this);
    repeat_timer_ =
        node.createWallTimer(ros::WallDuration(RepeatedMarkers::kInterval),
                             [this](const ros::WallTimerEvent& /*event*/) { repeat(); });
  }

  /// Publishes all markers again, for an RViz that was reset.
  void repeat() const {
    for (const auto* markers :
         {&map_markers_, &light_markers_, &pattern_markers_, &attack_markers_}) {
      markers->repeat();
    }
  }

  /// Returns false and logs the exception if `check` throws.
  template <typename Check>
  bool isUsable(const char* topic, const Check& check) {
    try {
      check();
      return true;
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM_THROTTLE(1.0, topic << " not shown: " << printable(error.what()));
      return false;
    }
  }

  void onMap(const collision_forge::LaneMapConstPtr& map) {
    const auto check = [&] { checkMap(fromMessage(*map), limits_, names::kLaneMap); };
    if (isUsable(names::kLaneMap, check)) map_markers_.publish(mapMarkers(*map));
  }

  void onLights(const collision_forge::TrafficLightArrayConstPtr& lights) {
    light_markers_.publish(lightMarkers(*lights));
  }

  void onScene(const collision_forge::EncodedSceneConstPtr& scene) {
    const auto check = [&] {
      Snapshot snapshot = fromMessage(scene->snapshot);
      checkSnapshot(snapshot, limits_, names::kEncodedScene);
    };
    if (!isUsable(names::kEncodedScene, check)) return;
    const bool jumped_back = scene_ && scene->header.stamp < scene_->header.stamp;
    scene_ = scene;
    clearFuturePatterns(*scene);
    if (jumped_back) repeat();
    if (attack_ && attack_->adaptive) shown_ = Shown::kOutdated;
  }

  /// Shows the patterns of the newest scene, which requests refer to.
  void onPredicted(const collision_forge::PredictedPatternsConstPtr& predicted) {
    if (predicted->patterns.empty()) {
      showPatterns(noMarkers(predicted->header), ros::Time());
    } else if (scene_) {
      showPatterns(patternMarkers(*predicted, scene_->snapshot), predicted->header.stamp);
    }
  }

  void showPatterns(const visualization_msgs::MarkerArray& patterns, const ros::Time& start) {
    patterns_ = patterns;
    patterns_start_ = start;
    if (!is_planner_test_shown_) pattern_markers_.publish(patterns);
  }

  /// Hides scene and attack while a planner rollout is shown: it draws the same vehicles elsewhere.
  void onPlannerTest(const std_msgs::BoolConstPtr& message) {
    const bool is_shown = message->data != 0;
    if (is_planner_test_shown_ == is_shown) return;
    is_planner_test_shown_ = is_shown;
    shown_ = Shown::kOutdated;
    if (!scene_) return;
    const auto nothing = noMarkers(scene_->snapshot.header);
    if (is_planner_test_shown_) {
      scene_markers_.publish(nothing);
      attack_markers_.publish(nothing);
    }
    pattern_markers_.publish(is_planner_test_shown_ ? nothing : patterns_);
  }

  void onAttack(const collision_forge::AttackConstPtr& attack) {
    const bool goes_on = attack->adaptive && attack->plans > 1;
    if (!goes_on) tested_.reset();  // it may be of another attack by the same vehicle, now
    attack_.reset();
    shown_ = Shown::kOutdated;
    if (isNone(*attack)) return watch_->stop();
    AttackerTrajectory trajectory;
    const auto check = [&] {
      trajectory = fromMessage(attack->trajectory);
      checkTrajectory(trajectory, limits_, names::kAttack);
    };
    if (!isUsable(names::kAttack, check)) return watch_->stop();
    attack_ = attack;
    if (goes_on) {
      watch_->change(trajectory);
    } else {
      watch_->start(trajectory);
    }
  }

  void onTested(const collision_forge::CollisionReportConstPtr& report) {
    tested_ = report;
    shown_ = Shown::kOutdated;
  }

  /// Returns the ROS time; the time of the newest scene if that is ahead or there is no clock.
  ros::Time pictureTime() const {
    const ros::Time clock = ros::Time::now();
    const ros::Time& newest = scene_->header.stamp;
    const bool is_ahead = newest > clock && newest < clock + ros::Duration(kRestart);
    return clock.isZero() || is_ahead ? newest : clock;
  }

  void show(const ros::WallTimerEvent& /*event*/) {
    if (!scene_ || is_planner_test_shown_) return;
    LiveScene live;
    live.scene = &scene_->snapshot;
    live.now = pictureTime();
    const auto ego = shownState(watch_->ego(), live.now.toSec());
    if (ego) live.ego = ego->pose;
    if (attack_ && live.now >= attack_->header.stamp) {
      live.attack = attack_.get();
      live.verdict = verdictBy(live.now, *attack_, tested_.get());
      live.crash = crashBy(live, ego);
    }
    placeWords(live);
    scene_markers_.publish(liveMarkers(live));
    showPlan(live);
    if (const auto area = shownArea(live)) areas_.publish(toMessage(*area, live.scene->header));
  }

  /// Labels are positioned once when the attack arrives, and again at its contact.
  void placeWords(LiveScene& live) {
    if (!live.attack) return;
    const WordsOf words_of{live.attack->header.stamp, live.attack->trajectory.attacker_id,
                           live.crash.has_value()};
    if (words_of != words_of_) words_obstacles_ = coveredByOthers(live);
    words_of_ = words_of;
    live.words_obstacles = words_obstacles_;
  }

  /// Returns the motion after the contact; nullopt before it, or if both continue driving. If the
  /// contact is only known from the report (node started later), both stand where the boxes
  /// touched, because the speed of the ego is unknown.
  std::optional<PostCrashMotion> crashBy(const LiveScene& live,
                                         const std::optional<AgentState>& ego) const {
    if (after_contact_ == AfterContact::kDriveOn) return std::nullopt;
    const auto& known = watch_->crash();
    if (known) return live.now.toSec() >= known->contactTime() ? known : std::nullopt;
    const auto predicted = ego ? watch_->crashBefore(*ego) : std::nullopt;
    if (predicted) return predicted;
    if (!live.verdict || !live.verdict->contact) return std::nullopt;
    const double time = live.verdict->contact_time.toSec();
    const CrashedVehicle standing_ego{AgentClass::kCar,
                                      sizeOf(live.attack->pattern.ego_size),
                                      {time, fromMessage(live.verdict->ego_at_contact)}};
    const CrashedVehicle attacker{AgentClass::kCar,
                                  sizeOf(live.attack->trajectory.size),
                                  {time, fromMessage(live.verdict->attacker_at_contact)}};
    return PostCrashMotion(standing_ego, attacker, severity_);
  }

  /// Publishes only if something changed.
  void showPlan(const LiveScene& live) {
    const Shown due = !live.attack ? Shown::kNothing : !live.verdict ? Shown::kPlan : Shown::kPast;
    if (due == shown_) return;
    shown_ = due;
    attack_markers_.publish(due == Shown::kNothing ? noMarkers(live.scene->header)
                            : due == Shown::kPlan
                                ? attackMarkers(*live.attack, live.scene->header.stamp)
                                : pastAttackMarkers(*live.attack, *live.verdict));
  }

  /// Clears the patterns if the scene is older than they are: the replay restarted.
  void clearFuturePatterns(const collision_forge::EncodedScene& scene) {
    if (scene.header.stamp < patterns_start_) showPatterns(noMarkers(scene.header), ros::Time());
  }

  using WordsOf = std::tuple<ros::Time, std::string, bool>;  // t0, attacker, after the contact
  enum class Shown { kNothing, kPlan, kPast, kOutdated };

  InputLimits limits_;
  SeverityOptions severity_;
  AfterContact after_contact_ = AfterContact::kStop;
  std::optional<ContactWatch> watch_;
  std::unique_ptr<EgoPoses> ego_poses_;
  RepeatedMarkers map_markers_;
  RepeatedMarkers light_markers_;
  ros::Publisher scene_markers_;
  RepeatedMarkers pattern_markers_;
  RepeatedMarkers attack_markers_;
  ros::Publisher areas_;
  collision_forge::EncodedSceneConstPtr scene_;
  collision_forge::AttackConstPtr attack_;           ///< null: none
  collision_forge::CollisionReportConstPtr tested_;  ///< the newest
  Shown shown_ = Shown::kNothing;                    ///< on attack_markers
  bool is_planner_test_shown_ = false;
  WordsOf words_of_;
  std::vector<OrientedBox> words_obstacles_;
  visualization_msgs::MarkerArray patterns_;  ///< on pattern_markers
  ros::Time patterns_start_;                  ///< "now" of the patterns that are shown; zero: none
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer timer_;
  ros::WallTimer repeat_timer_;
};

using ServedSceneVisualizer = Served<SceneVisualizerNodelet>;

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::ServedSceneVisualizer, nodelet::Nodelet)
