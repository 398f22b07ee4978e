#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <rosbag/bag.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/ros/messages/posed_frames.h"

namespace forge {

/// Returns a frame id without the leading slash of tf's first version.
std::string frameName(const std::string& frame_id);

/// Returns the usable transforms of a message, in its order, with frameName() of both frames and
/// normalised quaternions. Omits transforms with a non-finite part or a zero quaternion, and stamps
/// in the last hour of the range of ros::Time, whose sums overflow in tf2.
std::vector<geometry_msgs::TransformStamped> usableTransforms(const tf2_msgs::TFMessage& message);

/// Poses of frames in the map frame, put together by tf2 from the transforms of a bag, which are
/// added in the order of their recording: first all static ones. Frame names are frameName()s. Not
/// thread-safe.
class BagFrames {
 public:
  /// `ego_frame`: the frame whose motion movesEgo() detects. `cache`: s; poseOf() knows poses up to
  /// this long before the newest transform. The default is the longest time that a pose waits for a
  /// slow source of transforms.
  BagFrames(std::string map_frame, const std::string& ego_frame, double cache = 30.0)
      : map_frame_(std::move(map_frame)),
        ego_movers_(ego_frame),
        cache_(cache),
        buffer_(ros::Duration(cache)) {}

  /// Adds an element of usableTransforms(), of /tf_static if `is_static`. If a frame has several
  /// parents, only the first one that leads to the map frame is used; until one does, the first
  /// parent of all is used. At that change all earlier transforms that are not static are dropped.
  /// Returns false if the transform is not used: because of its parent, or because it is not newer
  /// than the one before.
  bool add(const geometry_msgs::TransformStamped& transform, bool is_static);

  /// Adds the pose of `child` in the frame `parent` as a transform that is not static; ignored
  /// where usableTransforms() omits it or add() returns false.
  void addPose(const std::string& parent, const std::string& child, const ros::Time& time,
               const Eigen::Isometry3d& pose);

  /// Returns true if `transform`, of /tf, moves the ego (EgoMovers::has()).
  bool movesEgo(const geometry_msgs::TransformStamped& transform) const {
    return ego_movers_.has(transform);
  }

  /// Returns the pose of `frame` in the map frame, interpolated: the identity for the map frame
  /// itself; nullopt if no chain of the added transforms connects the two at `time`, as before the
  /// first and after the last transform of a moving frame (nothing is extrapolated).
  std::optional<Eigen::Isometry3d> poseOf(const std::string& frame, const ros::Time& time) const;

  /// Returns true if no further transform can change poseOf() at `time`, because `time` is more
  /// than `cache` s before the newest used transform, and the transforms of that time were dropped.
  bool isPast(const ros::Time& time) const;

  /// Returns the frames of all added transforms, also unused ones, as "map -> odom, odom ->
  /// base_link"; "none" without any.
  std::string described() const;

 private:
  /// Returns true if `parent` is, or becomes, the parent that is used for `child`.
  bool acceptsParent(const std::string& child, const std::string& parent);
  /// Returns true if the chain of used parents of `frame` ends at the map frame.
  bool leadsToMap(std::string frame) const;

  std::string map_frame_;
  EgoMovers ego_movers_;
  double cache_;  // s
  tf2::BufferCore buffer_;
  std::map<std::string, std::string> parents_;         // by child, as used
  std::set<std::pair<std::string, std::string>> all_;  // parent and child
  std::map<std::string, ros::Time> stamps_;            // of the newest used transform, by child
  ros::Time newest_;                                   // newest stamp of all used transforms
};

/// s before the newest transform: longer than bags last, for a BagFrames with all transforms of
/// one.
inline constexpr double kLongestBag = 24.0 * 3600.0;

/// Adds all transforms of a bag, first the static ones. `changed`, if set, receives each message of
/// /tf and returns what counts instead.
void addTransforms(
    const rosbag::Bag& source, BagFrames& frames,
    const std::function<tf2_msgs::TFMessage(const tf2_msgs::TFMessage&)>& changed = {});

}  // namespace forge
