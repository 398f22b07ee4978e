#pragma once

#include <geometry_msgs/PolygonStamped.h>
#include <ros/subscriber.h>
#include <rviz/display.h>

#include "collision_forge/ros/rviz/following_view.h"

namespace rviz {
class ViewController;
}

namespace forge {

/// RViz display that moves and zooms the current view to the area of the topic `shown_area`. Only a
/// TopDownOrtho view whose target frame is the fixed frame is changed.
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
  geometry_msgs::PolygonStampedConstPtr area_;  ///< null before the first
  FollowingView following_;
};

}  // namespace forge
