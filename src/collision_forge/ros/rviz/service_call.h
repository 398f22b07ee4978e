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

/// Calls a service outside the thread of the GUI, one call at a time.
template <typename Service>
class ServiceCall {
 public:
  /// Empty when nobody answered.
  using Answer = std::optional<typename Service::Response>;

  /// `then` is called with each answer, in the thread of the GUI.
  explicit ServiceCall(std::function<void(const Answer&)> then) {
    QObject::connect(&watcher_, &QFutureWatcherBase::finished,
                     [this, then = std::move(then)] { then(watcher_.result()); });
  }

  /// Does nothing while a call is under way.
  void start(const std::string& name, typename Service::Request request) {
    if (watcher_.isRunning()) return;
    watcher_.setFuture(QtConcurrent::run(&caller_, [name, request]() mutable -> Answer {
      typename Service::Response response;
      if (!ros::service::call(name, request, response)) return std::nullopt;
      return response;
    }));
  }

 private:
  QFutureWatcher<Answer> watcher_;
  QThreadPool caller_;  ///< last: it waits for the call in flight, then this may be unloaded
};

}  // namespace forge
