#pragma once

#include <string>

namespace forge {

/// Returns the text of a layout file for Foxglove and Lichtblick: the scenes of CrashTopics in 3D,
/// and the speeds of ego and attacker over time.
std::string foxgloveLayout();

}  // namespace forge
