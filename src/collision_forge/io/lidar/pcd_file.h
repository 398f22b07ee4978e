#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/io/lidar/point_cloud.h"

namespace forge {

/// Reads the bytes of a file of the Point Cloud Library (.pcd, version 0.7, `DATA binary`), as the
/// radar files of nuScenes. Fields keep their names, types and places; signed integers, unsigned
/// integers and floats of 1 to 8 bytes become the datatypes of CloudField; without COUNT, each
/// field has one element. Throws CloudError, naming the line of the header and its value, for a
/// malformed header, a header of more than 64 KiB or with a line that version 0.7 does not have,
/// for `DATA ascii` and `DATA binary_compressed`, for a field of COUNT 0 or without a datatype of
/// CloudField, and for fewer bytes than POINTS says.
PointCloud readPcd(const std::vector<std::uint8_t>& bytes);

}  // namespace forge
