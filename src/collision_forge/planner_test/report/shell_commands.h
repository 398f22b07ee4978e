#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/trials/planner_result.h"

/// Shell commands that reproduce a row of the page, for the folder where the results were made.
/// They use the default configuration and method.
namespace forge {

/// A group of command lines.
struct ShellCommands {
  std::string title;  ///< shown to the user
  std::string lines;  ///< one or more shell commands, one per line, separated by line ends
};

/// Returns the commands that reproduce an attack or a rejected request:
/// - `forge inject`, with a figure and an animation, if `now_in_recording` is set. A scene that is
/// not stored as a bag is converted first.
/// - `forge generate` of this one request, also for an alternative. `alternative`: number of the
/// attack among the scenario's attacks, 1 for Scenario::answer, 2 for the first of its
/// alternatives. `now_in_recording`: s from the recording's first frame to t0; nullopt if it is not
/// known. `logs`: source of the recordings; an empty `logs.path` appears as SOURCE. `defaults`:
/// crash definition of the configuration; conditions of the request that equal it need no option.
std::vector<ShellCommands> commandsOfAttack(const Scenario& scenario, int alternative,
                                            std::optional<double> now_in_recording,
                                            const LogSource& logs, const CrashDefinition& defaults);

/// Returns the `forge test` command of one planner, attacker policy and background (`row`) for one
/// line (from 1 on) of the scenario file at `path`. The file of a traffic model appears as FILE.pt.
/// `logs` as in commandsOfAttack().
ShellCommands commandsOfTest(const std::string& path, std::size_t line, const RowKey& row,
                             const LogSource& logs);

/// Returns the page's record of the commands as one line of JSON without a line end: the list
/// "commands" of objects with "title" and "lines", in their order; empty without commands.
std::string commandsRecord(const std::vector<ShellCommands>& commands);

}  // namespace forge
