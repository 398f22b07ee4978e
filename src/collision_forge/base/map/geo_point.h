#pragma once

namespace forge {

/// A point on the earth (WGS 84). Degrees, north and east positive.
struct GeoPoint {
  double latitude = 0.0;
  double longitude = 0.0;
};

}  // namespace forge
