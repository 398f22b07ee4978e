#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace forge {

/// A timeout for calls that may block forever: if it exists for longer than `seconds`, prints what
/// is awaited to stderr and ends the process with EXIT_FAILURE, without cleaning up.
class Patience {
 public:
  /// `awaited` completes the message "process 12 has waited 3 s for ".
  Patience(double seconds, std::string awaited);
  ~Patience();
  Patience(const Patience&) = delete;
  Patience& operator=(const Patience&) = delete;

 private:
  void wait(double seconds, const std::string& awaited);

  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
  std::thread thread_;  // last: it uses the members above
};

}  // namespace forge
