#pragma once

#include <ros/service.h>

#include <QFutureWatcher>
#include <QThreadPool>
#include <QtConcurrent>

#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace forge {

/// Calls a ROS service in a worker thread, one call at a time. All functions must be called in the
/// GUI thread. The destructor waits for the running call, whose response is dropped.
template <typename Service>
class ServiceCall {
 public:
  /// The response; empty if the call failed.
  using Answer = std::optional<typename Service::Response>;

  /// `then` is called once for each start() that began a call, in the GUI thread, with the
  /// response, or with an empty Answer if the call failed.
  explicit ServiceCall(std::function<void(const Answer&)> then) {
    QObject::connect(&watcher_, &QFutureWatcherBase::finished,
                     [this, then = std::move(then)] { then(watcher_.result()); });
  }

  /// Calls the service `name` (relative to the node's namespace) without waiting and returns true.
  /// Returns false while another call runs: `request` is then dropped, and `then` is not called for
  /// it.
  bool start(const std::string& name, typename Service::Request request) {
    if (watcher_.isRunning()) return false;
    watcher_.setFuture(QtConcurrent::run(&caller_, [name, request]() mutable -> Answer {
      typename Service::Response response;
      if (!ros::service::call(name, request, response)) return std::nullopt;
      return response;
    }));
    return true;
  }

 private:
  QFutureWatcher<Answer> watcher_;
  QThreadPool caller_;  ///< last member: its destructor waits for the running call
};

}  // namespace forge
