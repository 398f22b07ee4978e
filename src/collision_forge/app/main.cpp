#include "collision_forge/app/command_line.h"

int main(int argc, char** argv) {
  forge::CommandLine line;
  forge::addCommands(line);
  forge::addStudyCommands(line);
  const auto exit_code = line.parse(argc, argv);
  return exit_code ? *exit_code : line.run();
}
