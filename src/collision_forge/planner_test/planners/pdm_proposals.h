#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/idm_law.h"
#include "collision_forge/planner_test/planners/kinematic_bicycle.h"
#include "collision_forge/planner_test/planners/pdm_forecast.h"
#include "collision_forge/planner_test/planners/pdm_path.h"

namespace forge {

/// The lead of a proposal, on its path. The gap to the lead is `progress` - `rear` minus the
/// progress of the ego's rear axle.
struct PathLead {
  double progress = 0.0;  ///< m along the path: of an agent, the ego's rear axle at the search plus
                          ///< the distance of the boxes; without one, the path's end
  double speed = 0.0;     ///< m/s along the path
  double rear = 0.0;  ///< m subtracted from `progress`: 0 for an agent, half the ego's length for
                      ///< the path's end
};

/// A path with a speed profile along it, before vehicle dynamics. Positions refer to the rear axle.
struct PdmProposal {
  std::size_t lateral = 0;     ///< index into PdmOptions::lateral_offsets
  double desired_speed = 0.0;  ///< m/s
  /// One per step, the first at t0; `progress` of the rear axle along the path at this offset, not
  /// clamped to the path's end.
  std::vector<IdmState> states;
  PathLead lead;  ///< found by the latest search, used until the next one
};

/// Creates proposals along a path and paths parallel to it with the intelligent driver model
/// (eulerStep()). The lead is the nearest agent whose forecast box touches the corridor of the
/// ego's width; it is searched for every `lead_interval` steps. As published, the first step has a
/// lead at the path's start and therefore brakes.
class PdmProposer {
 public:
  /// `centerline`: path of the route; `rear_axle` (global map frame) and `speed` (m/s): the ego's
  /// state at t0. `forecast` and `options` must outlive the proposer; it must cover all steps of
  /// the proposals.
  PdmProposer(const PdmPath& centerline, const Pose2& rear_axle, double speed,
              const PdmForecast& forecast, const EgoVehicle& ego, const PdmOptions& options);

  /// Returns one proposal of `options.proposal_steps` steps, so one state more, for every offset
  /// (outer loop) and share of `speed_limit` (m/s; inner loop).
  std::vector<PdmProposal> propose(double speed_limit);
  /// Continues a proposal of propose() until it has `steps` steps; a longer one is not changed.
  void extend(PdmProposal& proposal, int steps);
  /// Returns the poses of the rear axle in the global map frame, one per element of `states`;
  /// beyond the path's end, its end.
  std::vector<Pose2> poses(const PdmProposal& proposal) const;

 private:
  /// An agent that touches a corridor.
  struct OnPath {
    std::size_t agent = 0;  ///< index in PdmForecast::agents()
    double progress = 0.0;  ///< m along the path, of its middle
  };
  /// A path parallel to the centreline.
  struct LateralPath {
    PdmPath path;        ///< at the lateral offset
    PdmPath corridor;    ///< part of `path` ahead of the ego, middle of the corridor
    double start = 0.0;  ///< m along `path`, of the ego's rear axle at t0
    std::vector<std::vector<OnPath>> found;  ///< by number of the search, found so far
  };

  /// Returns the agents that touch the corridor at the search for step `step`.
  const std::vector<OnPath>& agentsOnPath(LateralPath& lateral, std::size_t step);
  /// Continues proposals at one lateral offset until they have `steps` steps. A proposal without an
  /// agent ahead has the path's end as its lead, at the speed of the lead of the previous proposal
  /// (0 for the first), as the published implementation does.
  void advance(std::vector<PdmProposal>& alongside, int steps);
  /// Returns the lead at a step; `free_speed`: m/s, speed of the path's end if no agent is ahead.
  PathLead leadOf(const PdmProposal& proposal, std::size_t step, double free_speed);

  const PdmForecast& forecast_;
  EgoVehicle ego_;
  const PdmOptions& options_;
  double speed_;
  std::vector<LateralPath> paths_;  // by lateral offset
};

}  // namespace forge
