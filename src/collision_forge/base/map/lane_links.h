#pragma once

#include <vector>

#include "collision_forge/base/map/lane_map.h"

namespace forge {

/// Makes links mutual: a link in either lane is in both afterwards, once. Drops links to lanes that
/// are not in `lanes`.
void linkMutually(std::vector<Lane>& lanes);

}  // namespace forge
