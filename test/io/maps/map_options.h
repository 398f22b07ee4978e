#pragma once

#include "base/scene/shipped_limits.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Options with the shipped limits, a pose each metre of a centreline, and no locations.
inline DataOptions mapOptions() {
  DataOptions options;
  options.conversion.centerline_resolution = 1.0;
  options.input_limits = shippedLimits();
  options.ego_vehicle = {{4.0, 2.0}, 1.5};
  return options;
}

}  // namespace forge
