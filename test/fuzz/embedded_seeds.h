#pragma once

#include <map>
#include <string>

/// Seeds from small parts of data/embedded: two frames of a scene with few agents, and a few lanes.
namespace forge {

/// Returns the tables by name.
std::map<std::string, std::string> embeddedTables();

/// Returns a file of the map expansion.
std::string embeddedMap();

std::string embeddedBag();

}  // namespace forge
