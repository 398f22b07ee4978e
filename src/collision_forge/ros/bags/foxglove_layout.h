#pragma once

#include <string>

namespace forge {

/// A layout for Foxglove and Lichtblick, as the text of its file: what CrashTopics show in 3D, and
/// the speeds of ego and attacker over time.
std::string foxgloveLayout();

}  // namespace forge
