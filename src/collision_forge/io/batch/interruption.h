#pragma once

#include <signal.h>

#include <array>
#include <string>

namespace forge {

/// While it exists, SIGINT, SIGTERM and SIGHUP write a message to stderr before their default
/// action ends the process, without destructors. The destructor restores the former handlers.
/// Signals that are ignored at construction, as SIGHUP under nohup, stay ignored. Only one may
/// exist per process.
class InterruptionNotice {
 public:
  /// `message` is printed followed by a line end.
  explicit InterruptionNotice(const std::string& message);
  ~InterruptionNotice();
  InterruptionNotice(const InterruptionNotice&) = delete;
  InterruptionNotice& operator=(const InterruptionNotice&) = delete;

 private:
  static constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};
  /// Former handlers, in the order of kSignals.
  std::array<struct sigaction, kSignals.size()> before_;
};

}  // namespace forge
