#pragma once

namespace forge {

/// Degrees, north and east positive.
struct GeoPoint {
  double latitude = 0.0;
  double longitude = 0.0;
};

}  // namespace forge
