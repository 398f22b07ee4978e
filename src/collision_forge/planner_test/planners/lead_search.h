#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// An agent in the corridor ahead of a vehicle that drives along a path.
struct Lead {
  std::string id;
  double gap = 0.0;    ///< m along the path, bumper to bumper; not negative
  double speed = 0.0;  ///< m/s along the path
};

/// A vehicle that follows a path.
struct Follower {
  const Polyline& path;
  double arc_length = 0.0;  ///< m, of the box's middle
  BoxSize size;
};

/// Extent of the search for a lead.
struct LeadSearch {
  double radius = 0.0;  ///< m ahead of the follower's front
  double margin = 0.0;  ///< m added to either side of the corridor of the follower's width
};

/// Returns the nearest agent whose box reaches into the corridor that the follower's body sweeps
/// along its path, ahead of its middle. Tests points at most 0.5 m apart on the boxes' outlines, at
/// each agent's newest state. Ignores agents without states and the agent with the id
/// `follower_id`.
std::optional<Lead> findLead(const Follower& follower, const std::string& follower_id,
                             const std::vector<Track>& agents, const LeadSearch& search);

}  // namespace forge
