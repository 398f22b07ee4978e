#include "collision_forge/base/files/worker_process.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <sstream>

extern char** environ;

namespace forge {
namespace {

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr std::size_t kBlock = 1 << 16;  // bytes received at once for a line

/// Starts the program in a process group of its own, so that Ctrl-C does not end it: its owner
/// decides when it ends. `stream` is its kWorkerStream, with its stdout redirected to stderr, or
/// its stdin and stdout.
pid_t spawn(const std::vector<std::string>& command, int stream, WorkerStream kind) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (kind == WorkerStream::kOwn) {
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, stream, kWorkerStream);
  } else {
    posix_spawn_file_actions_adddup2(&actions, stream, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, stream, STDOUT_FILENO);
  }
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setsigmask(&attributes, &none);
  pid_t pid = 0;
  const int problem =
      posix_spawn(&pid, command.front().c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (problem == 0) return pid;
  throw std::runtime_error(command.front() + ": cannot be started: " + std::strerror(problem));
}

int statusAtEnd(pid_t pid) {
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string howEnded(int status) {
  return WIFSIGNALED(status) ? "by signal " + std::to_string(WTERMSIG(status))
                             : "with exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

std::string packageProgram(const std::string& name) {
  Dl_info library;
  if (dladdr(reinterpret_cast<void*>(&packageProgram), &library) == 0) return name;
  return std::filesystem::absolute(library.dli_fname).parent_path() / "collision_forge" / name;
}

WorkerProcess::WorkerProcess(const std::vector<std::string>& command, WorkerStream stream,
                             double grace)
    : grace_(grace) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::runtime_error(command.front() + ": " + std::strerror(errno));
  }
  stream_ = ends[0];
  try {
    pid_ = spawn(command, ends[1], stream);
  } catch (...) {
    for (const int end : ends) close(end);
    throw;
  }
  close(ends[1]);
}

WorkerProcess::~WorkerProcess() {
  close(stream_);
  awaitEnd();
  end();
}

void WorkerProcess::interrupt() const {
  if (pid_ > 0) kill(-pid_, SIGINT);
}

bool WorkerProcess::hasEnded() const {
  siginfo_t found{};
  constexpr int kOptions = WEXITED | WNOHANG | WNOWAIT;
  return pid_ <= 0 || waitid(P_PID, static_cast<id_t>(pid_), &found, kOptions) != 0 ||
         found.si_pid != 0;
}

void WorkerProcess::awaitEnd() const {
  constexpr useconds_t kPoll = 2000;  // us
  const double last = steadySeconds() + grace_;
  while (!hasEnded() && steadySeconds() < last) usleep(kPoll);
}

int WorkerProcess::end() {
  if (pid_ <= 0) return status_;
  kill(-pid_, SIGKILL);
  status_ = statusAtEnd(pid_);
  pid_ = 0;
  return status_;
}

void WorkerProcess::setTimeout(double seconds) {
  timeout_ = seconds;
  deadline_ = steadySeconds() + seconds;
}

void WorkerProcess::await(short events) {
  pollfd wanted{stream_, events, 0};
  while (true) {
    const double left = deadline_ - steadySeconds();
    const int found =
        poll(&wanted, 1, static_cast<int>(std::ceil(1e3 * std::clamp(left, 0.0, 1e5))));
    if (found > 0) return;
    if (found < 0 && errno != EINTR) throw std::runtime_error(std::strerror(errno));
    if (found != 0) continue;
    std::ostringstream problem;
    problem << "no response within " << timeout_ << " s";
    throw WorkerTimeout(problem.str());
  }
}

void WorkerProcess::send(const void* data, std::size_t size) {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    await(POLLOUT);
    const ssize_t sent = ::send(stream_, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (sent < 0) failGone();
    bytes += sent;
    size -= static_cast<std::size_t>(sent);
  }
}

void WorkerProcess::receive(void* data, std::size_t size) {
  char* bytes = static_cast<char*>(data);
  while (size > 0) {
    const std::size_t received = receiveSome(bytes, size);
    bytes += received;
    size -= received;
  }
}

std::size_t WorkerProcess::receiveSome(char* bytes, std::size_t size) {
  while (true) {
    await(POLLIN);
    const ssize_t received = ::recv(stream_, bytes, size, MSG_DONTWAIT);
    if (received < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (received <= 0) failGone();
    return static_cast<std::size_t>(received);
  }
}

std::string WorkerProcess::receiveLine(std::size_t longest) {
  std::size_t searched = 0;
  while (true) {
    const std::size_t end = unread_.find('\n', searched);
    if (std::min(end, unread_.size()) > longest) {
      throw std::runtime_error("a line of its output has more than " + std::to_string(longest) +
                               " bytes");
    }
    if (end != std::string::npos) {
      std::string line = unread_.substr(0, end);
      unread_.erase(0, end + 1);
      return line;
    }
    searched = unread_.size();
    unread_.resize(searched + kBlock);
    std::size_t received = 0;
    try {
      received = receiveSome(&unread_[searched], kBlock);
    } catch (...) {
      unread_.resize(searched);
      throw;
    }
    unread_.resize(searched + received);
  }
}

void WorkerProcess::failGone() {
  awaitEnd();
  throw std::runtime_error("the process ended " + howEnded(end()));
}

}  // namespace forge
