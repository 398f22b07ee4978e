#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// Requests whose results are written to a scenario file.
struct ScenarioRun {
  std::string path;  ///< scenario file
  std::string list;  ///< file or option that the requests come from, for messages
  const std::vector<SceneRequest>& requests;
  std::string method;  ///< "": the built-in default
  Mode mode = Mode::kReplay;
  int jobs = 1;
};

/// Solves the requests and passes each scenario, in order, to `take`; resumes an interrupted run.
/// `logs` are the source of `scenes`. Throws as carryOut(), and std::runtime_error for a scenario
/// in the file that belongs to another request.
void writeScenarios(const ScenarioRun& asked, const LogSource& logs, SceneSource& scenes,
                    const Config& config, const std::function<void(const Scenario&)>& take);

}  // namespace forge
