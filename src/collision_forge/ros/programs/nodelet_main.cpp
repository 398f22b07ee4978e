#include <nodelet/loader.h>
#include <ros/ros.h>

#include <cstdlib>

/// Runs one of the package's nodelets as a node of its own; the build names which.
int main(int argc, char** argv) {
  ros::init(argc, argv, NODE_NAME);
  nodelet::Loader loader;
  const nodelet::V_string arguments(argv + 1, argv + argc);
  if (!loader.load(ros::this_node::getName(), NODELET_TYPE, ros::names::getRemappings(),
                   arguments)) {
    ROS_FATAL_STREAM("cannot start " << NODELET_TYPE);
    return EXIT_FAILURE;
  }
  ros::spin();
  return EXIT_SUCCESS;
}
