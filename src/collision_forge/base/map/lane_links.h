#pragma once

#include <vector>

#include "collision_forge/base/map/lane_map.h"

namespace forge {

/// Makes the links Lane::incoming and Lane::outgoing mutual: a link in either lane is in both
/// afterwards, once. In Lane::outgoing, links that were there before come first, in their order.
/// Drops links to lanes that are not in `lanes`.
void linkMutually(std::vector<Lane>& lanes);

}  // namespace forge
