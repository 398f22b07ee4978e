#pragma once

#include <string>

namespace forge {

/// Returns the JSON text, always the same, of a layout file for Foxglove and Lichtblick: a 3D view
/// of the scenes of CrashTopics and plots of the speeds of ego and attacker.
std::string foxgloveLayout();

}  // namespace forge
