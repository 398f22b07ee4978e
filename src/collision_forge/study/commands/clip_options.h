#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// Options shared by the commands that read COLLIDE clips. Each function adds the options named in
/// its comment to `app` and stores the value in its second argument, which must outlive the
/// parsing. addCollide() and addSplit() return the added option.
namespace forge {

/// --source (older name: --dataroot), required: a nuScenes root, used only for its maps.
void addDataroot(CLI::App& app, std::string& dataroot);

/// --collide, the folder of the clips, which contains trajectory/SPLIT; not required.
CLI::Option* addCollide(CLI::App& app, std::string& collide);
/// --split, one of train, val and test, by default the value of `split`; requires the option
/// `collide`.
CLI::Option* addSplit(CLI::App& app, std::string& split, CLI::Option* collide);
/// --limit, the number of clips to use from the first on, 0: all, by default the value of `limit`;
/// requires the option `collide`.
void addLimit(CLI::App& app, std::size_t& limit, CLI::Option* collide);

}  // namespace forge
