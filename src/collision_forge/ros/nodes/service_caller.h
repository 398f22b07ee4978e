#pragma once

#include <ros/ros.h>

#include <chrono>
#include <future>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// Calls one ROS service, whose response has `code` and `message`. The service must be idempotent,
/// since a call may be repeated. Thread-safe.
///
/// Connections are reused. If each call opened and closed one, roscpp's thread could still use the
/// closed socket when the next connection gets the same file descriptor; that call then hangs or
/// fails (observed: 1 call in 20,000).
class ServiceCaller {
 public:
  /// `answer_within`: time-out of one attempt, s of the wall clock.
  ServiceCaller(std::string resolved_name, double answer_within)
      : name_(std::move(resolved_name)), answer_within_(answer_within) {}

  /// Calls the service and returns the status of its response. Tries a kept connection, then a new
  /// one; returns kNodeUnavailable if both fail or time out. Blocks at most twice `answer_within`.
  template <typename Service>
  Status call(Service& service) {
    if (isAnswered(keptConnection<Service>(), service) ||
        isAnswered(freshConnection<Service>(), service)) {
      return {static_cast<StatusCode>(service.response.code), service.response.message};
    }
    return {StatusCode::kNodeUnavailable, "the node behind " + name_ + " does not answer"};
  }

 private:
  template <typename Service>
  bool isAnswered(ros::ServiceClient client, Service& service) {
    auto answer = std::async(std::launch::async, [&] { return client.call(service); });
    const bool is_late = answer.wait_for(answer_within_) == std::future_status::timeout;
    if (is_late) client.shutdown();  // makes call() return
    if (!answer.get()) return false;
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(client));
    return true;
  }

  /// Returns an idle connection, or a new one.
  template <typename Service>
  ros::ServiceClient keptConnection() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      while (!idle_.empty()) {
        const ros::ServiceClient client = idle_.back();
        idle_.pop_back();
        if (client.isValid()) return client;
      }
    }
    return freshConnection<Service>();
  }

  template <typename Service>
  ros::ServiceClient freshConnection() const {
    return ros::NodeHandle().serviceClient<Service>(name_, true);
  }

  std::string name_;
  std::chrono::duration<double> answer_within_;
  std::mutex mutex_;
  std::vector<ros::ServiceClient> idle_;
};

}  // namespace forge
