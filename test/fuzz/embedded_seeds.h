#pragma once

#include <map>
#include <string>

/// Small parts of data/embedded: two frames of a scene with few agents, and a few lanes. Other
/// seeds have what is not in data/embedded.
namespace forge {

/// By their names.
std::map<std::string, std::string> embeddedTables();

/// A file of the map expansion.
std::string embeddedMap();

std::string embeddedBag();

}  // namespace forge
