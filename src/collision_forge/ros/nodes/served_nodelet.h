#pragma once

#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

namespace forge {

/// A nodelet with its own callback queue, which outlives the members of derived classes. Callbacks
/// run only if the queue is served: Served does this.
class QueuedNodelet : public nodelet::Nodelet {
 protected:
  /// Called by the nodelet loader; calls start() with a handle whose callbacks go to the queue.
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

/// Runs the callbacks of `Queued`, which derives from QueuedNodelet, in one thread, from the end of
/// start() on. The destructor waits for the running callback, which roscpp does not do at shutdown.
template <typename Queued>
class Served final : public Queued {
  void onInit() override {
    Queued::onInit();
    spinner_.start();
  }

  ros::AsyncSpinner spinner_{1, &this->callbacks_};
};

}  // namespace forge
