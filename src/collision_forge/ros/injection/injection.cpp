#include "collision_forge/ros/injection/injection.h"

#include <nav_msgs/Odometry.h>
#include <rosbag/view.h>
#include <std_msgs/Time.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/older_message.h"
#include "collision_forge/ros/injection/attacked_frames.h"
#include "collision_forge/ros/injection/camera_boxes.h"
#include "collision_forge/ros/injection/finite_parts.h"
#include "collision_forge/ros/injection/header_stamp.h"
#include "collision_forge/ros/injection/lidar_injection.h"
#include "collision_forge/ros/injection/post_crash_ego.h"
#include "collision_forge/ros/markers/marker_parts.h"
#include "collision_forge/ros/markers/markers.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/object_array.h"
#include "collision_forge/ros/messages/paths.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr double kMapInterval = 1.0;  // s between two messages of map_markers
constexpr double kWordsReach = 40.0;  // m from the contact; the text is nearer

using Header = boost::shared_ptr<ros::M_string>;

/// Returns the connection's header with the caller id of additional frames.
Header markedInBetween(const Header& recorded) {
  auto header = boost::make_shared<ros::M_string>(*recorded);
  (*header)["callerid"] = names::kInBetween;
  return header;
}

/// Copies one bag to another and inserts the attack.
class Injection {
 public:
  Injection(const rosbag::Bag& source, NewBag& target, const BagAttack& attack,
            const RecordingContext& recording)
      : source_(source),
        target_(target),
        attack_(attack),
        shown_(attack.attack),
        trajectory_(fromMessage(attack.attack.trajectory)),
        recording_(recording),
        now_(attack.attack.trajectory.header.stamp),
        crash_(crash()),
        end_(end()),
        cameras_(source, attack.attack.trajectory.attacker_id),
        attacked_(source, attack, recording, crash_, end_),
        next_frame_(attacked_.frames().begin()) {
    shown_.report = attack.tested_report;
    if (crash_) ego_.emplace(*crash_, recording_.center_offset);
    if (attacked_.leftOut() > 0) left_out_[bagTopic(names::kAgents)] = attacked_.leftOut();
    findWordsObstacles();
    if (attack.lidar) openLidar(*attack.lidar);
  }

  InjectionNotes write(const std::function<void(double)>& on_progress) {
    rosbag::View view(source_);
    const double count = view.size();
    if (view.size() > 0) {
      report_time_ = std::min(attacked_.clock().recordedAt(reportTime()), view.getEndTime());
    }
    double done = 0.0;
    for (const rosbag::MessageInstance& instance : view) {
      on_progress(done++ / count);
      const ros::Time stamp = stampIn(instance);
      if (stamp > end_) continue;
      writeMadeBefore(instance.getTime());
      writeMapMarkersAt(instance.getTime());
      copy(instance, stamp);
    }
    writeMadeBefore(ros::TIME_MAX);
    on_progress(1.0);
    InjectionNotes notes;
    for (const auto& [topic, count] : left_out_) {
      notes.warnings.push_back(std::to_string(count) + " entries of " + topic +
                               " are not finite and left out");
    }
    notes.cameras = cameras_.summary();
    if (!lidar_) return notes;
    notes.lidar = lidar_->summary();
    for (const std::string& warning : lidar_->warnings()) notes.warnings.push_back(warning);
    return notes;
  }

 private:
  bool hasContact() const { return attack_.tested_report.contact; }

  /// Header stamp at which the outcome of the attack is known: at the contact, else at the end of
  /// the trajectory.
  ros::Time reportTime() const {
    return hasContact() ? attack_.tested_report.contact_time
                        : attack_.attack.trajectory.points.back().stamp;
  }

  /// Returns the motion after the contact, with AfterContact::kStop.
  std::optional<PostCrashMotion> crash() const {
    if (attack_.after_contact != AfterContact::kStop || !hasContact()) return std::nullopt;
    return motionAfterContact(attack_.tested_report.contact_time.toSec(), trajectory_,
                              recording_.ego, recording_.verification.severity);
  }

  /// Returns the greatest header stamp in the new bag.
  ros::Time end() const {
    const AttackedBagOptions& options = recording_.options;
    if (crash_) return stampOf(crash_->standTime() + options.seconds_after_stand);
    if (attack_.after_contact != AfterContact::kEnd || !hasContact()) return ros::TIME_MAX;
    return attack_.tested_report.contact_time + ros::Duration(options.end_time);
  }

  void openLidar(const LidarRequest& request) {
    LidarInjection::Setup setup;
    setup.topics = request.topics;
    setup.options = request.options;
    setup.seed = request.seed;
    setup.placed = [this](const ros::Time& time) { return attacked_.placedAt(time); };
    const auto is_recorded = [](const auto& motion) { return motion.past.empty(); };
    const auto& supports = attack_.attack.supports;
    if (is_recorded(attack_.attack.trajectory) ||
        std::any_of(supports.begin(), supports.end(),
                    [&](const auto& support) { return is_recorded(support.motion); })) {
      setup.vacated = [this](const ros::Time& time) { return attacked_.vacatedAt(time); };
    }
    setup.recorded = &attacked_.recorded();
    if (ego_) {
      setup.moved = [ego = *ego_](const tf2_msgs::TFMessage& message) mutable {
        return ego.changed(message);
      };
    }
    lidar_.emplace(source_, std::move(setup));
  }

  /// Returns the boxes of other agents near the contact from now on; the text avoids them.
  void findWordsObstacles() {
    const Vector2 contact = fromMessage(shown_.report.attacker_at_contact).position();
    for (const auto& [stamp, frame] : attacked_.frames()) {
      if (!hasContact() || !frame.is_recorded || frame.agents.header.stamp < now_) continue;
      for (const collision_forge::Agent& agent : frame.agents.agents) {
        const OrientedBox box{fromMessage(agent.pose), sizeOf(agent.size)};
        const bool is_near = (box.center.position() - contact).norm() < kWordsReach;
        if (is_near && agent.id != trajectory_.attacker_id) words_obstacles_.push_back(box);
      }
    }
  }

  /// Writes the new messages recorded before `time`: the attack at t0 and with every frame.
  void writeMadeBefore(const ros::Time& time) {
    while (next_frame_ != attacked_.frames().end() && next_frame_->second.recorded < time) {
      const AttackedFrame& frame = (next_frame_++)->second;
      writeAttackBefore(frame.recorded);
      writeReportBefore(frame.recorded);
      if (!frame.is_recorded) writeInBetween(frame);
      target_.writeLatched(bagTopic(names::kAttackMarkers), frame.recorded,
                           markersOf(frame.agents));
      target_.write(bagTopic(names::kAgentObjects), frame.recorded, toObjects(frame.agents));
    }
    writeAttackBefore(time);
    writeReportBefore(time);
  }

  void writeAttackBefore(const ros::Time& time) {
    const ros::Time recorded = attacked_.clock().recordedAt(now_);
    if (is_attack_written_ || time <= recorded) return;
    is_attack_written_ = true;
    target_.writeLatched(bagTopic(names::kAttack), recorded, attack_.attack);
    if (lidar_ && hasContact()) {
      std_msgs::Time contact;
      contact.data = attack_.tested_report.contact_time;
      target_.writeLatched(bagTopic(names::kSensorsMatchUntil), recorded, contact);
    }
    target_.writeLatched(bagTopic(names::kAttackRequest), recorded, attack_.request);
    target_.writeLatched(bagTopic(names::kAttackPath), recorded, toPath(trajectory_.points));
    target_.writeLatched(bagTopic(names::kAttackEgoPath), recorded,
                         toPath(recording_.ego, now_.toSec(), trajectory_.points.back().time));
  }

  void writeReportBefore(const ros::Time& time) {
    if (is_report_written_ || time <= report_time_) return;
    is_report_written_ = true;
    target_.writeLatched(bagTopic(names::kTestedReport), report_time_, attack_.tested_report);
  }

  void writeInBetween(const AttackedFrame& frame) {
    target_.write(bagTopic(names::kAgents), frame.recorded, frame.agents,
                  markedInBetween(attacked_.header()));
    if (!markers_header_) return;
    target_.write(bagTopic(names::kAnnotationMarkers), frame.recorded, shownAgents(frame.agents),
                  markers_header_);
  }

  /// The attacker is red from now on.
  visualization_msgs::MarkerArray shownAgents(const collision_forge::AgentArray& agents) const {
    std::vector<std::string> supports;
    for (const auto& support : shown_.supports) supports.push_back(support.motion.attacker_id);
    return annotationMarkers(
        agents, agents.header.stamp < now_ ? "" : shown_.trajectory.attacker_id, supports);
  }

  const collision_forge::Agent* attackerIn(const collision_forge::AgentArray& agents) const {
    const auto found = std::find_if(
        agents.agents.begin(), agents.agents.end(),
        [this](const auto& agent) { return agent.id == attack_.attack.trajectory.attacker_id; });
    return found == agents.agents.end() ? nullptr : &*found;
  }

  /// Returns the ego's pose according to the bag.
  std::optional<Pose2> egoAt(double time) const {
    if (crash_ && time > crash_->contactTime()) return crash_->egoAt(time).pose;
    const auto state = stateAt(recording_.ego, time);
    if (!state) return std::nullopt;
    return state->pose;
  }

  visualization_msgs::MarkerArray markersOf(const collision_forge::AgentArray& agents) const {
    CrashView view;
    view.header = agents.header;
    if (const auto ego = egoAt(agents.header.stamp.toSec())) {
      view.ego = OrientedBox{*ego, recording_.ego.size};
    }
    if (agents.header.stamp >= now_) {
      view.attack = &shown_;
      view.attacker = attackerIn(agents);
      view.words_obstacles = words_obstacles_;
    }
    return crashMarkers(view);
  }

  /// Returns the header stamp of a message that shows agents or the ego; for other messages, the
  /// stamp that corresponds to the record time.
  ros::Time stampIn(const rosbag::MessageInstance& instance) const {
    const auto stamp = headerStampOf(instance);
    return stamp ? *stamp : attacked_.clock().stampAt(instance.getTime());
  }

  void copy(const rosbag::MessageInstance& instance, const ros::Time& stamp) {
    if (copyChanged(instance, stamp)) return;
    target_.write(instance.getTopic(), instance.getTime(), instance,
                  instance.getConnectionHeader());
  }

  /// Returns false for a message to copy unchanged.
  bool copyChanged(const rosbag::MessageInstance& instance, const ros::Time& stamp) {
    const std::string& topic = instance.getTopic();
    if (topic == bagTopic(names::kLaneMap)) return copyMap(instance);
    for (const char* made_anew : {names::kMapMarkers, names::kAgentObjects}) {
      if (topic == bagTopic(made_anew)) return true;
    }
    if (topic == bagTopic(names::kAgents)) return copyAgents(instance, stamp);
    if (topic == bagTopic(names::kAnnotationMarkers)) return copyAnnotationMarkers(instance, stamp);
    if (topic == names::kTf) return copyEgo<tf2_msgs::TFMessage>(instance);
    if (topic == bagTopic(names::kOdometry)) return copyEgo<nav_msgs::Odometry>(instance);
    if (lidar_ && lidar_->has(topic)) return copyCloud(instance);
    if (cameras_.has(topic)) markPicture(instance);
    return false;
  }

  void markPicture(const rosbag::MessageInstance& instance) {
    const auto info = instance.instantiate<sensor_msgs::CameraInfo>();
    if (!info) return;
    const bool is_over = crash_ && info->header.stamp.toSec() > crash_->contactTime();
    const auto agents =
        is_over ? std::vector<collision_forge::Agent>() : attacked_.placedAt(info->header.stamp);
    for (const auto& marker : cameras_.mark(instance.getTopic(), *info, agents)) {
      target_.write(CameraBoxes::boxTopic(instance.getTopic()), instance.getTime(), marker);
    }
  }

  bool copyCloud(const rosbag::MessageInstance& instance) {
    const auto cloud = instance.instantiate<sensor_msgs::PointCloud2>();
    if (!cloud || !lidar_->edit(instance.getTopic(), *cloud)) return false;
    target_.write(instance.getTopic(), instance.getTime(), *cloud, instance.getConnectionHeader());
    return true;
  }

  /// Writes the markers of the map. Writes the map itself, and returns true, only if it was
  /// recorded in another version of the message.
  bool copyMap(const rosbag::MessageInstance& instance) {
    const auto map = readMessage<collision_forge::LaneMap>(instance);
    if (!map) return false;
    map_markers_ = mapMarkers(*map);
    map_markers_time_ = instance.getTime();
    writeMapMarkersAt(instance.getTime());
    if (instance.isType<collision_forge::LaneMap>()) return false;
    target_.writeLatched(instance.getTopic(), instance.getTime(), *map);
    return true;
  }

  /// At most once per kMapInterval. RViz drops its markers where a replay jumps back, and `rosbag
  /// play --loop` publishes a latched message from before its start once, not in every round.
  void writeMapMarkersAt(const ros::Time& time) {
    if (!map_markers_ || time < map_markers_time_) return;
    target_.writeLatched(bagTopic(names::kMapMarkers), time, *map_markers_);
    map_markers_time_ = time + ros::Duration(kMapInterval);
  }

  bool copyAgents(const rosbag::MessageInstance& instance, const ros::Time& stamp) {
    const auto frame = attacked_.frames().find({stamp, instance.getTime()});
    if (frame == attacked_.frames().end()) return false;
    if (!attacked_.isChangedAt(stamp) && !frame->second.is_mended) return false;
    target_.write(instance.getTopic(), instance.getTime(), frame->second.agents,
                  instance.getConnectionHeader());
    return true;
  }

  /// Copies the markers of the newest frame. The order of messages of one time is arbitrary.
  bool copyAnnotationMarkers(const rosbag::MessageInstance& instance, const ros::Time& stamp) {
    markers_header_ = instance.getConnectionHeader();
    const auto after = attacked_.frames().upper_bound({stamp, ros::TIME_MAX});
    if (after == attacked_.frames().begin() || !attacked_.isChangedAt(stamp)) return false;
    target_.write(instance.getTopic(), instance.getTime(),
                  shownAgents(std::prev(after)->second.agents), markers_header_);
    return true;
  }

  /// Returns true if nothing is left of a message after its non-finite parts were removed.
  static bool isEmpty(const tf2_msgs::TFMessage& message) { return message.transforms.empty(); }
  static bool isEmpty(const nav_msgs::Odometry& /*message*/) { return true; }

  /// Writes the ego's pose at the contact before the first later message.
  template <typename Message>
  void writeAtContact(const rosbag::MessageInstance& next, const Message& message) {
    const auto made = ego_->atContact(message);
    const ros::Time before = std::exchange(ego_times_[next.getTopic()], next.getTime());
    if (!made) return;
    target_.write(next.getTopic(), before + (next.getTime() - before) * made->ratio, made->message,
                  next.getConnectionHeader());
  }

  template <typename Message>
  bool copyEgo(const rosbag::MessageInstance& instance) {
    const auto message = instance.instantiate<Message>();
    if (!message) return false;
    const int left_out = keepFinite(*message);
    if (left_out > 0) left_out_[instance.getTopic()] += left_out;
    if (left_out > 0 && isEmpty(*message)) return true;
    if (ego_) writeAtContact(instance, *message);
    const Message changed = ego_ ? ego_->changed(*message) : *message;
    if (left_out == 0 && changed == *message) return false;
    target_.write(instance.getTopic(), instance.getTime(), changed, instance.getConnectionHeader());
    return true;
  }

  const rosbag::Bag& source_;
  NewBag& target_;
  const BagAttack& attack_;
  collision_forge::Attack shown_;  ///< with the report against the recording
  AttackerTrajectory trajectory_;
  const RecordingContext& recording_;
  ros::Time now_;                               ///< header stamp
  std::optional<PostCrashMotion> crash_;        ///< with AfterContact::kStop and a contact
  ros::Time end_;                               ///< greatest header stamp in the new bag
  std::optional<PostCrashEgo> ego_;             ///< the same
  std::map<std::string, ros::Time> ego_times_;  ///< by topic: record time of its last message
  std::optional<LidarInjection> lidar_;
  CameraBoxes cameras_;
  AttackedFrames attacked_;
  AttackedFrames::Frames::const_iterator next_frame_;  ///< first frame not yet written
  std::vector<OrientedBox> words_obstacles_;           ///< of all frames
  std::map<std::string, int> left_out_;                ///< by topic: number of dropped messages
  Header markers_header_;  ///< null until the first markers of annotations
  bool is_attack_written_ = false;
  bool is_report_written_ = false;
  ros::Time report_time_;  ///< record time of the report
  std::optional<visualization_msgs::MarkerArray> map_markers_;
  ros::Time map_markers_time_;  ///< record time of the next ones
};

}  // namespace

InjectionNotes injectIntoBag(const std::string& in, const std::string& out, const BagAttack& attack,
                             const RecordingContext& recording,
                             const std::function<void(double)>& on_progress) {
  try {
    const OpenedBag source(in);
    NewBag target(out);
    InjectionNotes notes = Injection(source.bag(), target, attack, recording).write(on_progress);
    target.commit();
    return notes;
  } catch (const rosbag::BagException& error) {
    throw BagError(in + " to " + out + ": " + error.what());
  }
}

}  // namespace forge
