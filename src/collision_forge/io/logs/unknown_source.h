#pragma once

#include <string>

namespace forge {

/// Returns the error text for a path that is no log source: what the path is, the kinds that were
/// looked for, and the remedy.
std::string unknownSourceText(const std::string& path);

}  // namespace forge
