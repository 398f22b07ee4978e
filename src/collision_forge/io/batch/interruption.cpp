#include "collision_forge/io/batch/interruption.h"

#include <unistd.h>

namespace forge {
namespace {

std::string message_now;  // built in advance: a signal handler must not allocate

/// Writes the message and lets the signal end the process.
void onInterruption(int signal) {
  [[maybe_unused]] const ssize_t count =
      ::write(STDERR_FILENO, message_now.data(), message_now.size());
  ::raise(signal);
}

}  // namespace

InterruptionNotice::InterruptionNotice(const std::string& message) {
  message_now = message;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    struct sigaction action = {};
    action.sa_handler = onInterruption;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigaction(kSignals[i], &action, &before_[i]);
    const bool was_ignored = before_[i].sa_handler == SIG_IGN;
    if (was_ignored) ::sigaction(kSignals[i], &before_[i], nullptr);
  }
}

InterruptionNotice::~InterruptionNotice() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    ::sigaction(kSignals[i], &before_[i], nullptr);
  }
}

}  // namespace forge
