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

/// Calls one service whose response has `code` and `message`. The service must be idempotent: a
/// failed call is repeated. Thread-safe.
///
/// Keeps connections for later calls. If each call closed its connection, roscpp's thread could
/// still use the socket while the next connection gets the same descriptor, and that call would
/// hang or fail (measured: 1 call in 20,000).
class ServiceCaller {
 public:
  /// `resolved_name`: of the service, with its namespace. `answer_within`: timeout of one attempt,
  /// s of the wall clock; a call makes up to two. Makes no connection yet.
  ServiceCaller(std::string resolved_name, double answer_within)
      : name_(std::move(resolved_name)), answer_within_(answer_within) {}

  /// Sends `service.request`, blocks, and fills `service.response`. Returns the status in the
  /// response (`code`, `message`); kNodeUnavailable, with the response unspecified, if neither of
  /// two attempts, the first with a kept connection if there is one, the second with a new one,
  /// gets a response in time. `Service`: a generated service type.
  template <typename Service>
  Status call(Service& service) {
    if (isAnswered(keptConnection<Service>(), service) ||
        isAnswered(freshConnection<Service>(), service)) {
      return {static_cast<StatusCode>(service.response.code), service.response.message};
    }
    return {StatusCode::kNodeUnavailable, "the node behind " + name_ + " does not respond"};
  }

 private:
  /// Makes one attempt; returns true, and keeps the connection, if a response arrived in time.
  template <typename Service>
  bool isAnswered(ros::ServiceClient client, Service& service) {
    auto answer = std::async(std::launch::async, [&] { return client.call(service); });
    const bool is_late = answer.wait_for(answer_within_) == std::future_status::timeout;
    if (is_late) client.shutdown();  // ends the call
    if (!answer.get()) return false;
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(client));
    return true;
  }

  /// Returns an idle connection, or a new one if none is idle.
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

  /// Returns a new connection, which stays open between calls.
  template <typename Service>
  ros::ServiceClient freshConnection() const {
    return ros::NodeHandle().serviceClient<Service>(name_, true);
  }

  std::string name_;
  std::chrono::duration<double> answer_within_;  // s
  std::mutex mutex_;                             // guards `idle_`
  std::vector<ros::ServiceClient> idle_;         // connections without a running call
};

}  // namespace forge
