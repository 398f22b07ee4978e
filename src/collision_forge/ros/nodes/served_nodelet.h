#pragma once

#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

namespace forge {

/// A nodelet with its own callback queue, which outlives the members of derived classes.
class QueuedNodelet : public nodelet::Nodelet {
 protected:
  void onInit() override {
    ros::NodeHandle node = getNodeHandle();
    node.setCallbackQueue(&callbacks_);
    start(node);
  }

  ros::CallbackQueue callbacks_;

 private:
  /// Subscribes to topics and advertises services. Called once, by onInit(); callbacks of `node`
  /// run later, in one thread. An exception makes the loading of the nodelet fail.
  virtual void start(ros::NodeHandle node) = 0;
};

/// Runs the callbacks of a QueuedNodelet in one thread, from the end of start() on. The destructor
/// waits for the running callback, which roscpp does not do at shutdown.
template <typename Queued>
class Served final : public Queued {
  void onInit() override {
    Queued::onInit();
    spinner_.start();
  }

  ros::AsyncSpinner spinner_{1, &this->callbacks_};
};

}  // namespace forge
