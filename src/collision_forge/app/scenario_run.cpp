#include "collision_forge/app/scenario_run.h"

#include <stdexcept>

#include "collision_forge/app/options.h"
#include "collision_forge/io/answers/request_solver.h"
#include "collision_forge/io/batch/run.h"
#include "collision_forge/io/scenarios/request_file.h"
#include "collision_forge/io/weights/pattern_network_file.h"

namespace forge {
namespace {

/// Returns the fingerprints of all inputs of the scenarios.
ResumableFile::Options runOptions(const ScenarioRun& asked, const LogSource& logs,
                                  const Config& config) {
  ResumableFile::Options options = inputsOf(config, logs);
  if (!asked.method.empty()) options["method"] = asked.method;
  addWeightsOf(asked.method, config, options);
  options["mode"] = toString(asked.mode);
  options["requests"] = fingerprintOf(asked.requests);
  return options;
}

/// Throws std::runtime_error if the scenario at `where` belongs to a request other than `request`.
/// An answer to a request for any type has the type of its attack.
void checkAnswer(const std::string& where, SceneRequest asked, const SceneRequest& request) {
  if (request.request.type == CollisionType::kAny) asked.request.type = CollisionType::kAny;
  if (requestLine(asked) == requestLine(request) && asked.request.mode == request.request.mode) {
    return;
  }
  throw std::runtime_error(where + ": belongs to the request " + requestLine(asked) +
                           " instead of " + requestLine(request) + "; choose another --out");
}

}  // namespace

void writeScenarios(const ScenarioRun& asked, const LogSource& logs, SceneSource& scenes,
                    const Config& config, const std::function<void(const Scenario&)>& take) {
  const MethodMaker method = loadMethod(asked.method, config, config.attack);
  Run run;
  run.path = asked.path;
  run.options = runOptions(asked, logs, config);
  run.items = "requests";
  run.count = asked.requests.size();
  run.jobs = asked.jobs;
  run.work = [&](std::size_t index) {
    try {
      const SceneRequest& request = asked.requests[index];
      const RequestSolver solver(scenes, method, request.request.crash, config.ego_vehicle,
                                 config.adaptive);
      return scenarioLine(solver.answer(request));
    } catch (const std::exception& error) {
      throw std::runtime_error(asked.list + ": line " + std::to_string(index + 1) +
                               " failed: " + error.what());
    }
  };
  run.take = [&](std::size_t index, const std::string& where, const std::string& line) {
    const Scenario scenario = readScenarioLine(where, line, config.input_limits);
    checkAnswer(where, scenario.asked, asked.requests[index]);
    take(scenario);
  };
  carryOut(run);
}

}  // namespace forge
