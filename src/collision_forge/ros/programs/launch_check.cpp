#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/injection/after_contact.h"
#include "collision_forge/ros/nodes/node_support.h"

/// usage: launch_check NAME:=VALUE...
///
/// Checks arguments of a launch file before roslaunch starts a node: a file or folder must be at
/// each path that is not empty, `bag` may not be empty, `config_dir` must hold valid
/// files of a configuration, and `after_contact` is a word. The first wrong argument is named in
/// one line on stderr, and the exit code is 1.
namespace forge {
namespace {

void check(const std::string& argument) {
  const std::size_t separator = argument.find(":=");
  if (separator == std::string::npos) throw std::runtime_error("not NAME:=VALUE");
  const std::string name = argument.substr(0, separator);
  const std::string path = argument.substr(separator + 2);
  if (name == "after_contact") {
    liveAfterContact(path);
    return;
  }
  if (name == "bag" && path.empty()) {
    throw std::runtime_error("it is required: the bag to replay, as bag:=out/demo/scene-0005.bag");
  }
  if (path.empty()) return;
  if (!std::filesystem::exists(path)) {
    throw std::runtime_error("no such file or folder");
  }
  if (access(path.c_str(), R_OK) != 0) throw std::runtime_error("not readable");
  if (name == "config_dir") loadConfig(packageConfig(path));
}

}  // namespace
}  // namespace forge

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    try {
      forge::check(argv[i]);
    } catch (const std::exception& error) {
      std::cerr << "launch argument " << argv[i] << ": " << error.what() << "\n";
      return EXIT_FAILURE;
    }
  }
  std::cout << "ok";
  return EXIT_SUCCESS;
}
