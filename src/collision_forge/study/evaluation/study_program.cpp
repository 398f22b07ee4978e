#include "collision_forge/study/evaluation/study_program.h"

#include <stdexcept>

#include "collision_forge/base/files/worker_process.h"

namespace forge {

void runStudyProgram(const std::string& name, const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {"/usr/bin/python3", packageProgram("study/" + name)};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const auto ended = runProgram(command);
  if (!ended) return;
  throw std::runtime_error(
      command[1] + " failed: ended " + *ended +
      "; it needs the packages python3-matplotlib, python3-scipy and python3-sklearn");
}

}  // namespace forge
