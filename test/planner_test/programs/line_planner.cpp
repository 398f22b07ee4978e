#include <iostream>
#include <stdexcept>

#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/planner_test/planners/planner_protocol.h"
#include "collision_forge/planner_test/settings/config.h"

/// usage: line_planner PLANNER: a built-in planner that speaks the line protocol.
int main(int, char** argv) {
  const forge::Config config = forge::loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  forge::PlannerUnderTest made;
  std::cout << forge::readyLine() << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    try {
      const forge::PlanRequest request = forge::readPlanRequest(line);
      if (request.is_begin) {
        made = forge::makePlanner(argv[1], config.planners, "");
        made.planner->initialize(request.task);
        std::cout << forge::begunLine() << std::endl;
      } else {
        std::cout << forge::pointsLine(made.planner->plan(request.observation)) << std::endl;
      }
    } catch (const std::exception& error) {
      std::cout << forge::errorLine(error) << std::endl;
    }
  }
}
