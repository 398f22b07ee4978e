#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "collision_forge/planner_test/report/write_report.h"
#include "collision_forge/planner_test/settings/config.h"

/// The HTML report, for forge report and for commands with the option --report.
namespace forge {

/// Calls writeReportPage() and prints the number of rows on stdout.
void writeReport(const ReportInputs& inputs, const std::string& folder, const Config& config);

/// Adds --report, the folder of the HTML report; `folder` stays empty if it is not given.
CLI::Option* addReportOption(CLI::App& app, std::string& folder);

}  // namespace forge
