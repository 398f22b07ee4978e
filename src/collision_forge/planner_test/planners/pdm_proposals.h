#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/idm_law.h"
#include "collision_forge/planner_test/planners/kinematic_bicycle.h"
#include "collision_forge/planner_test/planners/pdm_forecast.h"
#include "collision_forge/planner_test/planners/pdm_path.h"

namespace forge {

/// The lead of a proposal, on its path.
struct PathLead {
  double progress = 0.0;  ///< m along the path, of the lead's middle
  double speed = 0.0;     ///< m/s
  double rear = 0.0;      ///< m from its middle to its rear end
};

/// A path with a speed profile along it, before vehicle dynamics: one state per step, the first at
/// t0. Positions refer to the rear axle.
struct PdmProposal {
  std::size_t lateral = 0;     ///< index into options.lateral_offsets
  double desired_speed = 0.0;  ///< m/s
  std::vector<IdmState> states;
  PathLead lead;  ///< lead at the last search
};

/// Creates proposals along a path and paths parallel to it with the intelligent driver model
/// (eulerStep()). The lead is the nearest agent whose forecast box touches the corridor of the
/// ego's width; it is searched for every `lead_interval` steps. As published, the first step has a
/// lead at the path's start and therefore brakes.
class PdmProposer {
 public:
  /// `rear_axle` and `speed` (m/s): the ego's state at t0. `forecast` and `options` must outlive
  /// the proposer.
  PdmProposer(const PdmPath& centerline, const Pose2& rear_axle, double speed,
              const PdmForecast& forecast, const EgoVehicle& ego, const PdmOptions& options);

  /// Returns one proposal of `options.proposal_steps` steps for every offset (outer loop) and share
  /// of `speed_limit` (m/s; inner loop).
  std::vector<PdmProposal> propose(double speed_limit);
  /// Continues a proposal until it has `steps` steps.
  void extend(PdmProposal& proposal, int steps);
  /// Returns the poses of the rear axle, one per step.
  std::vector<Pose2> poses(const PdmProposal& proposal) const;

 private:
  struct OnPath {
    std::size_t agent = 0;
    double progress = 0.0;  // of its middle
  };
  struct LateralPath {
    PdmPath path;
    PdmPath corridor;
    double start = 0.0;                      // m, of the ego
    std::vector<std::vector<OnPath>> found;  // by search for a lead
  };

  const std::vector<OnPath>& agentsOnPath(LateralPath& lateral, std::size_t step);
  /// Continues proposals at one lateral offset until they have `steps` steps. A proposal without an
  /// agent ahead has the path's end as its lead, at the speed of the lead of the previous proposal
  /// (0 for the first), as the published implementation does.
  void advance(std::vector<PdmProposal>& alongside, int steps);
  PathLead leadOf(const PdmProposal& proposal, std::size_t step, double free_speed);

  const PdmForecast& forecast_;
  EgoVehicle ego_;
  const PdmOptions& options_;
  double speed_;
  std::vector<LateralPath> paths_;  // by lateral offset
};

}  // namespace forge
