#include "collision_forge/study/commands/study_commands.h"

/// A program with the command train only, for builds without ROS.
int main(int argc, char** argv) {
  forge::CommandLine line;
  forge::addTrain(line);
  const auto exit_code = line.parse(argc, argv);
  return exit_code ? *exit_code : line.run();
}
