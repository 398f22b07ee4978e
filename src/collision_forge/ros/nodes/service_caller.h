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

/// Asks one service, from any thread, whose node answers the same when it is asked again. An answer
/// has `code` and `message`.
///
/// Connections are kept for later calls. Where one is closed after each call, roscpp's own thread
/// may still be at work on its socket while the next connection gets the same number: that one then
/// waits in vain, or is lost (seen: 1 call in 20,000).
class ServiceCaller {
 public:
  /// `answer_within`: s of the wall clock.
  ServiceCaller(std::string resolved_name, double answer_within)
      : name_(std::move(resolved_name)), answer_within_(answer_within) {}

  /// The answer's status; kNodeUnavailable when none has come over a kept connection, nor then over
  /// a fresh one, in time.
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
    if (is_late) client.shutdown();  // ends it
    if (!answer.get()) return false;
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(client));
    return true;
  }

  /// One that is not in use; a fresh one where there is none.
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
