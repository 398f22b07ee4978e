#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// An agent in the corridor ahead of a vehicle that drives along a path.
struct Lead {
  std::string id;    ///< Track::id of the agent
  double gap = 0.0;  ///< m along the path from the follower's front to the lead's nearest point,
                     ///< 0 for a lead beside the follower
  /// m/s, component of the lead's velocity along the path, negative if oncoming.
  double speed = 0.0;
};

/// A vehicle that follows a path. `path` must outlive the object.
struct Follower {
  /// Line of the vehicle's middle, global map frame; straight on beyond its end
  const Polyline& path;
  double arc_length = 0.0;  ///< m along `path`, of the box's middle
  BoxSize size;             ///< of the vehicle
};

/// Extent of the search for a lead.
struct LeadSearch {
  double radius = 0.0;  ///< m ahead of the follower's front
  double margin = 0.0;  ///< m added to either side of the corridor of the follower's width
};

/// Returns the lead, the agent with the smallest gap (the first of equals) whose box reaches into
/// the corridor that the follower's body sweeps along its path, from its middle to `search.radius`
/// ahead of its front; nullopt if there is none. Tests points at most 0.5 m apart on the boxes'
/// outlines, at each agent's newest state. Ignores agents without states and the agent with the id
/// `follower_id`.
std::optional<Lead> findLead(const Follower& follower, const std::string& follower_id,
                             const std::vector<Track>& agents, const LeadSearch& search);

}  // namespace forge
