#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "collision_forge/app/command_line.h"
#include "collision_forge/planner_test/report/write_report.h"
#include "collision_forge/planner_test/settings/config.h"

/// The HTML report, for forge report and for commands with the option --report.
namespace forge {

/// Calls writeReportPage() and prints the number of rows on stdout. `formats`: further formats of
/// result files besides scenario files and results.jsonl.
void writeReport(const ReportInputs& inputs, const std::string& folder, const Config& config,
                 const std::vector<RowFormat>& formats = {});

/// Adds the command `name` under `heading`, which writes the HTML report of the result files given
/// as arguments. `files` is the help text of these arguments, `formats` as in writeReport().
void addReportCommand(CommandLine& line, const std::string& heading, const std::string& name,
                      const std::string& files, const std::vector<RowFormat>& formats);

/// Adds --report, the folder of the HTML report; `folder` stays empty if it is not given.
CLI::Option* addReportOption(CLI::App& app, std::string& folder);

}  // namespace forge
