#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// Somebody in the way of a vehicle that drives along a path.
struct Lead {
  std::string id;
  double gap = 0.0;    ///< m along the path, bumper to bumper; not negative
  double speed = 0.0;  ///< m/s along the path
};

/// A vehicle on its path.
struct Follower {
  const Polyline& path;
  double arc_length = 0.0;  ///< m, of the box's middle
  BoxSize size;
};

/// How far to look for a lead.
struct LeadSearch {
  double radius = 0.0;  ///< m ahead of the follower's front
  double margin = 0.0;  ///< m on either side of the follower's body that belong to its corridor
};

/// The nearest of the others whose box reaches into the corridor that the follower's body sweeps
/// along its path, ahead of its middle; told from points at most half a metre apart on the
/// outlines. Looked at are the newest states. Who has the follower's id, or no state, is left out.
std::optional<Lead> findLead(const Follower& follower, const std::string& follower_id,
                             const std::vector<Track>& others, const LeadSearch& search);

}  // namespace forge
