#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/idm_law.h"
#include "collision_forge/planner_test/planners/kinematic_bicycle.h"
#include "collision_forge/planner_test/planners/pdm_forecast.h"
#include "collision_forge/planner_test/planners/pdm_path.h"

namespace forge {

/// What PDM-Closed's IDM drives behind.
struct PathLead {
  double progress = 0.0;  ///< m
  double speed = 0.0;     ///< m/s
  double rear = 0.0;      ///< m from its progress to its rear end
};

/// A way and speeds along it that the ego might drive, before its dynamics; one state a step, the
/// first now. Places are the rear axle's.
struct PdmProposal {
  std::size_t lateral = 0;     ///< index into options.lateral_offsets
  double desired_speed = 0.0;  ///< m/s
  std::vector<IdmState> states;
  PathLead lead;  ///< the last
};

/// Drives along a path and paths beside it by the intelligent driver model (eulerStep()), behind
/// the nearest agent whose forecast box touches the corridor of the ego's width, looked for every
/// few steps. The first step sees a lead at the path's begin: it brakes.
class PdmProposer {
 public:
  /// `forecast` and `options` must outlive the proposer.
  PdmProposer(const PdmPath& centerline, const Pose2& rear_axle, double speed,
              const PdmForecast& forecast, const EgoVehicle& ego, const PdmOptions& options);

  /// options.proposal_steps steps for every offset (outer) and share of the speed limit (inner).
  std::vector<PdmProposal> propose(double speed_limit);
  /// Until it has `steps` steps.
  void extend(PdmProposal& proposal, int steps);
  std::vector<Pose2> poses(const PdmProposal& proposal) const;

 private:
  struct OnPath {
    std::size_t agent = 0;
    double progress = 0.0;  // of its middle
  };
  struct Way {
    PdmPath path;
    PdmPath corridor;
    double start = 0.0;                     // m, of the ego
    std::vector<std::vector<OnPath>> seen;  // by search for a lead
  };

  const std::vector<OnPath>& seenAt(Way& way, std::size_t step);
  /// Drives proposals at one lateral offset on until they have `steps` steps. One that has nobody
  /// ahead takes the end of the path for its lead, at the speed of the lead of the proposal before
  /// it (0 for the first), as the published implementation does.
  void advance(std::vector<PdmProposal>& beside, int steps);
  PathLead leadOf(const PdmProposal& proposal, std::size_t step, double free_speed);

  const PdmForecast& forecast_;
  EgoVehicle ego_;
  const PdmOptions& options_;
  double speed_;
  std::vector<Way> ways_;  // by lateral offset
};

}  // namespace forge
