#pragma once

#include <collision_forge/Agent.h>
#include <rosbag/bag.h>
#include <sensor_msgs/CameraInfo.h>
#include <visualization_msgs/ImageMarker.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/ros/bags/bag_frames.h"

namespace forge {

/// Marks agents on the pictures of a bag's cameras: the edges of their boxes as lines. The pictures
/// themselves do not change.
class CameraBoxes {
 public:
  /// Finds the topics of sensor_msgs/CameraInfo, and reads the transforms of the bag if there are
  /// any. `attacker`: id of the agent whose box is red; the boxes of others are orange.
  CameraBoxes(const rosbag::Bag& source, std::string attacker);

  /// Returns true for the topics of cameras.
  bool has(const std::string& topic) const { return counts_.count(topic) > 0; }

  /// Returns the topic of the boxes of a camera: NAMESPACE/attack_box for NAMESPACE/camera_info,
  /// and NAMESPACE/NAME_attack_box for NAMESPACE/NAME, so that cameras of one namespace have their
  /// own.
  static std::string boxTopic(const std::string& info_topic);

  /// Returns one marker per agent (in the map frame) that is in the picture, at the stamp of
  /// `info`, and one that deletes the marker of each agent that was in the camera's picture before
  /// and is not any more. Empty if the camera's frame has no transform at that stamp.
  std::vector<visualization_msgs::ImageMarker> mark(
      const std::string& topic, const sensor_msgs::CameraInfo& info,
      const std::vector<collision_forge::Agent>& agents);

  /// Returns one line per camera: the number of its pictures with the attacker's box.
  std::vector<std::string> summary() const;

 private:
  struct Counts {
    std::size_t pictures = 0;
    std::size_t marked = 0;       ///< with the attacker's box
    std::size_t unplaced = 0;     ///< without transform
    std::set<std::string> shown;  ///< ids of the agents in the newest picture
  };

  std::string attacker_;
  BagFrames frames_;
  std::map<std::string, int> marker_ids_;  ///< by agent
  std::map<std::string, Counts> counts_;   ///< by topic
};

/// A line on a picture, pixels: x to the right, y down.
struct PictureLine {
  Eigen::Vector2d begin, end;
};

/// Returns the edges of an agent's box in the picture of a camera, cut off at the picture's border
/// and in front of the camera. `camera`: pose of the camera's optical frame (z forward, x right,
/// REP-103) in the frame of the agent. Pixels follow the projection matrix P of `info`, or K if P
/// is zero: positions are in the rectified picture.
std::vector<PictureLine> boxEdges(const collision_forge::Agent& agent,
                                  const Eigen::Isometry3d& camera,
                                  const sensor_msgs::CameraInfo& info);

}  // namespace forge
