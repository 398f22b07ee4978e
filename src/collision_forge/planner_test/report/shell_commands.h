#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/trials/planner_result.h"

/// Commands that make a row of the page again, for a shell in the folder where the results were
/// made. They use the default configuration and method.
namespace forge {

/// What a group of command lines makes.
struct ShellCommands {
  std::string title;  ///< for people
  std::string lines;  ///< separated by line ends
};

/// The commands that generate an attack, or a refusal, again:
/// - `forge inject`, with a picture and an animation, if `now_in_recording` is set. A scene that
///   is not stored as a bag is converted first.
/// - `forge generate` of this one request.
///
/// `alternative` counts the attacks of the scenario from 1 on. `now_in_recording` is the time of
/// the request in seconds from the first frame. An empty `logs.path` appears as SOURCE. `defaults`
/// is the crash definition of the configuration.
std::vector<ShellCommands> commandsOfAttack(const Scenario& scenario, int alternative,
                                            std::optional<double> now_in_recording,
                                            const LogSource& logs, const CrashDefinition& defaults);

/// `forge test` of one planner on one line, counted from 1 on, of the scenario file at `path`.
ShellCommands commandsOfTest(const std::string& path, std::size_t line, const std::string& planner,
                             PolicyKind policy, Background background, const LogSource& logs);

/// What the page shows of them, as JSON.
std::string commandsRecord(const std::vector<ShellCommands>& commands);

}  // namespace forge
