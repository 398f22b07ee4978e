#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "collision_forge/app/command_line.h"
#include "collision_forge/planner_test/report/write_report.h"
#include "collision_forge/planner_test/settings/config.h"

/// The page of forge report, for the command and for those that end with one.
namespace forge {

/// writeReportPage(), and a line on stdout. `formats`: files of rows that are read beside the
/// product's own.
void writeReport(const ReportInputs& inputs, const std::string& folder, const Config& config,
                 const std::vector<RowFormat>& formats = {});

/// A command `name` that writes the page of the files that its arguments name; `files` says which
/// ones it takes.
void addReportCommand(CommandLine& line, const std::string& heading, const std::string& name,
                      const std::string& files, const std::vector<RowFormat>& formats);

/// --report, a folder; empty: no page.
CLI::Option* addReportOption(CLI::App& app, std::string& folder);

}  // namespace forge
