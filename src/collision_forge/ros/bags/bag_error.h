#pragma once

#include <stdexcept>

namespace forge {

/// Thrown if a bag cannot be read or written; names the path, and topic and time if known.
struct BagError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace forge
