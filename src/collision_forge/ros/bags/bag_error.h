#pragma once

#include <stdexcept>

namespace forge {

/// A bag that cannot be read or written; names the path, and the topic and time if it has them.
struct BagError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace forge
