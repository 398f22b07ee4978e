#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "collision_forge/report/write_report.h"
#include "collision_forge/settings/config.h"

/// The page of forge report, for the command and for those that end with one.
namespace forge {

/// writeReportPage(), and a line on stdout.
void writeReport(const ReportInputs& inputs, const std::string& folder, const Config& config);

/// --report, a folder; empty: no page.
CLI::Option* addReportOption(CLI::App& app, std::string& folder);

}  // namespace forge
