#pragma once

#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

namespace forge {

/// A nodelet whose callbacks wait in a queue of its own. The queue goes after all that the nodelet
/// has.
class QueuedNodelet : public nodelet::Nodelet {
 protected:
  void onInit() override {
    ros::NodeHandle node = getNodeHandle();
    node.setCallbackQueue(&callbacks_);
    start(node);
  }

  ros::CallbackQueue callbacks_;

 private:
  /// Subscribes, and offers services. The callbacks of `node` wait in the queue.
  virtual void start(ros::NodeHandle node) = 0;
};

/// Serves the queue of a QueuedNodelet. No callback comes before start() has ended, and the nodelet
/// goes only after the one that is at work: when ROS shuts down, roscpp does not wait for it.
template <typename Queued>
class Served final : public Queued {
  void onInit() override {
    Queued::onInit();
    spinner_.start();
  }

  ros::AsyncSpinner spinner_{1, &this->callbacks_};
};

}  // namespace forge
