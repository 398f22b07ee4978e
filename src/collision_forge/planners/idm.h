#pragma once

#include <string>

#include "collision_forge/planners/idm_law.h"
#include "collision_forge/planners/lead_search.h"
#include "collision_forge/planners/planner.h"

namespace forge {

/// config/planners.yaml, section idm.standard, where each number's unit and source stand.
struct IdmOptions {
  IdmParameters law;
  LeadSearch lead;
  double horizon = 0.0;
  double step = 0.0;
};

/// config/planners.yaml, section idm.published.
struct PublishedIdmOptions {
  IdmParameters law;
  double step = 0.0;
};

/// Follows the route by the intelligent driver model, as nuPlan's IDM planner: the lead is the
/// nearest in the corridor of the route (findLead()), at its bumper-to-bumper gap, and goes on at
/// its speed along the route.
class IdmPlanner : public Planner {
 public:
  explicit IdmPlanner(const IdmOptions& options) : options_(options) {}
  void initialize(const DrivingTask& task) override;
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

 private:
  IdmOptions options_;
  BoxSize size_;
  std::optional<Polyline> route_;
};

/// The intelligent driver model as the planner test of arXiv 2510.12206 has it: the lead is always
/// the attacker, at the distance of the boxes' middles, even when it is not ahead; the ego follows
/// its route. Plans one step. Without the attacker in sight the road is free.
class PublishedIdmPlanner : public Planner {
 public:
  PublishedIdmPlanner(const PublishedIdmOptions& options, std::string attacker_id)
      : options_(options), attacker_id_(std::move(attacker_id)) {}
  void initialize(const DrivingTask& task) override;
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

 private:
  PublishedIdmOptions options_;
  std::string attacker_id_;
  std::optional<Polyline> route_;
};

}  // namespace forge
