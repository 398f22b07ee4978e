#pragma once

#include <stdexcept>

namespace forge {

/// Training that cannot go on: a device that is absent, a state of another run. Says why.
struct TrainingError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace forge
