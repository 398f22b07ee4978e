#pragma once

#include <string>

namespace forge {

/// Returns the error text for a path that is no log source: its kind, the kinds looked for, and the
/// remedy.
std::string unknownSourceText(const std::string& path);

}  // namespace forge
