#pragma once

#include <stdexcept>

namespace forge {

/// Thrown for an invalid configuration. The message names file, key and value.
struct ConfigError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace forge
