#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "collision_forge/base/config/config_folder.h"

/// Options of commands that read clips of COLLIDE.
namespace forge {

/// --source, whose older name is --dataroot, required: a nuScenes root for its maps alone.
void addDataroot(CLI::App& app, std::string& dataroot);

/// --collide.
CLI::Option* addCollide(CLI::App& app, std::string& collide);
/// --split, which needs `collide`.
CLI::Option* addSplit(CLI::App& app, std::string& split, CLI::Option* collide);
/// --limit, which needs `collide`.
void addLimit(CLI::App& app, std::size_t& limit, CLI::Option* collide);

/// Throws CLI::ValidationError for a name that clipMethods() does not know.
void checkClipMethods(const std::vector<std::string>& methods, const ConfigFolder& config);

}  // namespace forge
