#pragma once

#include <stdexcept>

namespace forge {

/// Thrown for a map file that cannot be used. The message names the file and, if known, the
/// element, the attribute and the value.
struct MapError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace forge
