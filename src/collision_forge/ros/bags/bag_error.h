#pragma once

#include <stdexcept>

namespace forge {

/// Thrown if a bag or a message in it cannot be read or written; the text has the path, and topic
/// and time if known. Functions that get no path (MessageDefinition, ...) omit it; their callers
/// add it.
struct BagError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace forge
