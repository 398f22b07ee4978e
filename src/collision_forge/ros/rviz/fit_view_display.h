#pragma once

#include <geometry_msgs/PolygonStamped.h>
#include <ros/subscriber.h>
#include <rviz/display.h>

#include "collision_forge/ros/rviz/following_view.h"

namespace rviz {
class ViewController;
}

namespace forge {

/// RViz display that moves and scales the current view so that it shows the area of the topic
/// `shown_area`. Only for a TopDownOrtho view whose target frame is the fixed frame; other views
/// are not changed.
class FitViewDisplay : public rviz::Display {
  Q_OBJECT

 public:
  /// Called by RViz for each picture; `wall_dt`: s of the wall clock since the last call; `ros_dt`
  /// is not used. Moves the view a step towards the newest area (FollowingView); does nothing
  /// before the first area and for a view that canFit() rejects.
  void update(float wall_dt, float ros_dt) override;
  /// Called when the user presses Reset or time jumps back: drops the user's zoom and offset.
  void reset() override;

 protected:
  void onEnable() override;   ///< subscribes to the topic
  void onDisable() override;  ///< unsubscribes; drops the area and the user's zoom and offset

 private:
  /// Keeps the area; ignores one with fewer than three points.
  void receive(const geometry_msgs::PolygonStampedConstPtr& area);
  /// Returns true for a TopDownOrtho view whose target frame is the fixed frame.
  bool canFit(rviz::ViewController& view) const;

  ros::Subscriber subscriber_;
  geometry_msgs::PolygonStampedConstPtr area_;  ///< the newest, m, fixed frame; null: none received
  FollowingView following_;
};

}  // namespace forge
