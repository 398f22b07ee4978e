#include "collision_forge/study/evaluation/study_program.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "collision_forge/base/files/worker_process.h"

extern char** environ;

namespace forge {
namespace {

constexpr const char* kPython = "/usr/bin/python3";

int runToEnd(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t pid = 0;
  const int problem = posix_spawn(&pid, words.front(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (problem != 0) {
    throw std::runtime_error(command.front() + ": cannot be started: " + std::strerror(problem));
  }
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

void runStudyProgram(const std::string& name, const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {kPython, packageProgram("study/" + name)};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const int status = runToEnd(command);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  throw std::runtime_error(
      command[1] + ": ended " +
      (WIFSIGNALED(status) ? "by signal " + std::to_string(WTERMSIG(status))
                           : "with exit code " + std::to_string(WEXITSTATUS(status))) +
      "; it needs Debian's python3-matplotlib, python3-scipy and python3-sklearn");
}

}  // namespace forge
