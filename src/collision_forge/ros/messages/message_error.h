#pragma once

#include <stdexcept>

namespace forge {

/// Thrown for an invalid message; the text has field and value.
struct MessageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace forge
