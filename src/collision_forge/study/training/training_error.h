#pragma once

#include <stdexcept>

namespace forge {

/// Thrown if a training cannot start or continue, e.g. for a missing device or the state of another
/// run.
struct TrainingError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace forge
