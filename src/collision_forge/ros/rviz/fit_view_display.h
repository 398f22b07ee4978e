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
  void update(float wall_dt, float ros_dt) override;
  void reset() override;

 protected:
  void onEnable() override;
  void onDisable() override;

 private:
  void receive(const geometry_msgs::PolygonStampedConstPtr& area);
  bool canFit(rviz::ViewController& view) const;

  ros::Subscriber subscriber_;
  geometry_msgs::PolygonStampedConstPtr area_;  ///< null: none received
  FollowingView following_;
};

}  // namespace forge
