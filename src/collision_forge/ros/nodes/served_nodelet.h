#pragma once

#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

namespace forge {

/// Base class of the nodelets: their callbacks wait in a separate queue, which is destroyed after
/// all members of the derived class.
class QueuedNodelet : public nodelet::Nodelet {
 protected:
  void onInit() override {
    ros::NodeHandle node = getNodeHandle();
    node.setCallbackQueue(&callbacks_);
    start(node);
  }

  ros::CallbackQueue callbacks_;

 private:
  /// Subscribes, advertises topics and services. Called once by onInit(); callbacks of `node` are
  /// queued until it returns. An exception ends the loading of the nodelet.
  virtual void start(ros::NodeHandle node) = 0;
};

/// Runs the callbacks of a QueuedNodelet in one thread, after start() has returned. The destructor
/// waits for a running callback, which roscpp does not do at shutdown.
template <typename Queued>
class Served final : public Queued {
  void onInit() override {
    Queued::onInit();
    spinner_.start();
  }

  ros::AsyncSpinner spinner_{1, &this->callbacks_};
};

}  // namespace forge
