#pragma once

#ifndef COLLISION_FORGE_WITHOUT_ROS
#include <ros/package.h>
#endif

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

/// What the command line tools share.
namespace forge {

/// Exit codes of every tool.
enum ExitCode { kExitOk = 0, kExitError = 1, kExitUsage = 2, kExitNoAttack = 3 };

/// The folder of the package; empty where ROS does not know it (its environment is not sourced), or
/// in a build without ROS.
inline std::string packageFolder() {
#ifdef COLLISION_FORGE_WITHOUT_ROS
  return "";
#else
  return ros::package::getPath("collision_forge");
#endif
}

/// Adds --config, by default the package's own configuration; required where packageFolder() is
/// empty.
inline void addConfigOption(CLI::App& app, std::string& directory) {
  const std::string package = packageFolder();
  CLI::Option* option = app.add_option("--config", directory, "folder with the configuration files")
                            ->check(CLI::ExistingDirectory);
  if (package.empty()) {
    option->required();
  } else {
    directory = package + "/config";
    option->capture_default_str();
  }
}

inline void printWarnings(const std::string& subject, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    std::fprintf(stderr, "warning: %s: %s\n", subject.c_str(), warning.c_str());
  }
}

/// Parses the command line, runs the tool, and turns exceptions into a message and an exit code.
template <typename Tool>
int runTool(CLI::App& app, int argc, char** argv, Tool tool) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  }
  try {
    return tool();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), error.what());
    return kExitError;
  }
}

}  // namespace forge
