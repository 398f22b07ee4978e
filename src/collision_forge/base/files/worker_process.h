#pragma once

#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace forge {

/// The file descriptor of a process's stream, in that process.
inline constexpr int kWorkerStream = 3;

/// The path of a program of this package. It lies in a folder beside the package's libraries, built
/// and installed.
std::string packageProgram(const std::string& name);

/// Runs `command`, the path of a program and its arguments, and waits for its end; what it prints
/// goes to stderr. Returns how it ended, as "by signal 9" or "with exit code 1"; nullopt for exit
/// code 0. Throws std::runtime_error if it cannot be started.
std::optional<std::string> runProgram(const std::vector<std::string>& command);

/// A process that does not answer in time.
struct WorkerTimeout : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A process of our own, asked over a stream of bytes (its file descriptor kWorkerStream). It ends
/// with this object, whatever it is doing. For one thread at a time.
class WorkerProcess {
 public:
  /// Starts `command`, the path of a program and its arguments. Throws std::runtime_error where it
  /// cannot be started.
  explicit WorkerProcess(const std::vector<std::string>& command);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// From now on, so many seconds of the wall clock may pass.
  void setTimeout(double seconds);
  /// All of the bytes. Throw WorkerTimeout when the time is up, and std::runtime_error, which says
  /// how it ended, where the process is gone.
  void send(const void* data, std::size_t size);
  void receive(void* data, std::size_t size);

  /// s of the processor that it has used.
  double processorTime() const;

 private:
  void await(short events);
  /// Kills the process, unless it is gone, and returns its wait status.
  int end();
  [[noreturn]] void failGone();

  pid_t pid_ = 0;   // 0: gone
  int status_ = 0;  // how it ended
  int stream_ = -1;
  double timeout_ = 0.0;   // s, for messages
  double deadline_ = 0.0;  // s, of the steady clock
};

}  // namespace forge
