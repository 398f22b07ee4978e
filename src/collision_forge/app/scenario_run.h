#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// Requests whose results are written to a scenario file, one line per request in their order.
struct ScenarioRun {
  std::string path;  ///< scenario file; until complete PATH.part (ResumableFile)
  std::string list;  ///< file or option that the requests come from, for messages
  const std::vector<SceneRequest>& requests;  ///< must outlive this object
  std::string method;                         ///< name of the attack method; "": built-in default
  Mode mode = Mode::kReplay;  ///< mode that all `requests` have; an option of the resumable run
  int jobs = 1;               ///< threads
};

/// Solves the requests, writes the scenario file and passes each scenario (also rejected requests,
/// and scenarios of an earlier run) to `take`, in order, in the calling thread; resumes an
/// interrupted run. `logs`: the source of `scenes`, for the fingerprints; `config` gives the
/// options that a request does not set itself. Throws as carryOut(), and std::runtime_error for a
/// request that cannot be processed (naming `list` and its line) and for a scenario in the file
/// that belongs to another request (with another requestLine() or mode; the answer to a request
/// for type "any" may have any type).
void writeScenarios(const ScenarioRun& asked, const LogSource& logs, SceneSource& scenes,
                    const Config& config, const std::function<void(const Scenario&)>& take);

}  // namespace forge
