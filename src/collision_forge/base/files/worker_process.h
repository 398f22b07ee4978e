#pragma once

#include <sys/types.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace forge {

/// File descriptor of the stream to the parent, in the worker process.
inline constexpr int kWorkerStream = 3;

/// Returns the absolute path of the program `name` of this package: in folder collision_forge
/// beside the package's libraries, in the build and the install space. Does not test whether it
/// exists.
std::string packageProgram(const std::string& name);

/// Thrown if a worker process does not respond in time.
struct WorkerTimeout : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Descriptors of the child process that carry the byte stream.
enum class WorkerStream {
  kOwn,       ///< kWorkerStream, in both directions; the child's stdout goes to stderr
  kStandard,  ///< the child's stdin and stdout
};

/// A child process, in a process group of its own, with a byte stream to it. The destructor closes
/// the stream, waits until the child ends by itself, at most `grace`, and kills the group. Not
/// thread-safe.
class WorkerProcess {
 public:
  /// Starts `command` (path of the program, which is not searched in PATH, and its arguments).
  /// `grace`: s that the process has to end by itself after its stream has closed. Throws
  /// std::runtime_error if it cannot be started.
  explicit WorkerProcess(const std::vector<std::string>& command,
                         WorkerStream stream = WorkerStream::kOwn, double grace = 0.0);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// Sets the deadline of send(), receive() and receiveLine() to `seconds` (steady clock) from now.
  /// Must be called before them: the first deadline is over from the start.
  void setTimeout(double seconds);
  /// Send and receive exactly `size` bytes; wait until then. Throw WorkerTimeout at the deadline,
  /// std::runtime_error if the process has closed its stream or ended; the message says how it
  /// ended. After receiveLine(), receive() misses the bytes that it read ahead: use one of the two
  /// only.
  void send(const void* data, std::size_t size);
  void receive(void* data, std::size_t size);
  /// Waits for text up to a line end ('\n') and returns it without the line end. Throws as
  /// receive(), and std::runtime_error for a line of more than `longest` bytes.
  std::string receiveLine(std::size_t longest);

  /// Sends SIGINT to the process group; does nothing after send() or a receive function has thrown
  /// because the process ended.
  void interrupt() const;
  /// Returns true if the process has ended; does not wait.
  bool hasEnded() const;

 private:
  /// Waits until the stream is ready for `events` of poll(). Throws WorkerTimeout at the deadline.
  void await(short events);
  /// Receives at least one and at most `size` bytes; returns their number.
  std::size_t receiveSome(char* bytes, std::size_t size);
  /// Waits `grace` at most until the process ends by itself.
  void awaitEnd() const;
  /// Kills the process group if the process still runs, and returns its wait status.
  int end();
  /// Ends the process and throws std::runtime_error with its exit code or signal.
  [[noreturn]] void failGone();

  pid_t pid_ = 0;          // 0: ended
  int status_ = 0;         // wait status
  int stream_ = -1;        // socket to the process
  double grace_ = 0.0;     // s
  std::string unread_;     // received behind the last line
  double timeout_ = 0.0;   // s, for messages
  double deadline_ = 0.0;  // s, of the steady clock
};

}  // namespace forge
