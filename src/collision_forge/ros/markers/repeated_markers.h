#pragma once

#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>

namespace forge {

/// A latched marker topic whose newest message can be repeated. RViz deletes all markers when time
/// jumps back or Reset is pressed, and receives a latched message only once. Not thread-safe.
class RepeatedMarkers {
 public:
  static constexpr double kInterval = 1.0;  ///< s of the wall clock between two calls of repeat()

  /// Has no topic; assign an object with a topic before publish(). repeat() does nothing.
  RepeatedMarkers() = default;
  /// Advertises `topic`, resolved by `node`, as latched; publishes nothing yet.
  RepeatedMarkers(ros::NodeHandle& node, const char* topic)
      : publisher_(node.advertise<visualization_msgs::MarkerArray>(topic, 1, true)) {}

  /// Publishes the markers and keeps them for repeat().
  void publish(const visualization_msgs::MarkerArray& markers) {
    newest_ = markers;
    publisher_.publish(markers);
  }

  /// Publishes the newest message again, if there is one; call it every kInterval.
  void repeat() const {
    if (newest_) publisher_.publish(*newest_);
  }

 private:
  ros::Publisher publisher_;
  std::optional<visualization_msgs::MarkerArray> newest_;
};

}  // namespace forge
