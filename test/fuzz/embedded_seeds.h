#pragma once

#include <map>
#include <string>

/// What is small enough to begin with of data/embedded: two frames of a scene, with few agents, and
/// a few lanes. Beside these, seeds are made that have what data/embedded has not.
namespace forge {

/// By their names.
std::map<std::string, std::string> embeddedTables();

/// A file of the map expansion.
std::string embeddedMap();

std::string embeddedBag();

/// A file of ScenarioNet.
std::string embeddedDescription();

}  // namespace forge
