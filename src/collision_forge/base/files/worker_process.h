#pragma once

#include <sys/types.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace forge {

/// File descriptor of the stream to the parent, in the worker process.
inline constexpr int kWorkerStream = 3;

/// Returns the path of a program of this package: in folder collision_forge beside the package's
/// libraries, in the build and the install space.
std::string packageProgram(const std::string& name);

/// Thrown if a worker process does not respond in time.
struct WorkerTimeout : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A child process with a byte stream to it (its descriptor kWorkerStream). The destructor kills
/// it, whatever it is doing. Not thread-safe.
class WorkerProcess {
 public:
  /// Starts `command` (program path and arguments). Throws std::runtime_error if it cannot be
  /// started.
  explicit WorkerProcess(const std::vector<std::string>& command);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// Sets the deadline of send() and receive() to `seconds` (wall clock) from now.
  void setTimeout(double seconds);
  /// Send and receive exactly `size` bytes. Throw WorkerTimeout at the deadline, std::runtime_error
  /// if the process has ended; the message says how it ended.
  void send(const void* data, std::size_t size);
  void receive(void* data, std::size_t size);

 private:
  void await(short events);
  /// Kills the process if it still runs, and returns its wait status.
  int end();
  [[noreturn]] void failGone();

  pid_t pid_ = 0;   // 0: ended
  int status_ = 0;  // wait status
  int stream_ = -1;
  double timeout_ = 0.0;   // s, for messages
  double deadline_ = 0.0;  // s, of the steady clock
};

}  // namespace forge
