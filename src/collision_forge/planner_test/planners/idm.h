#pragma once

#include <optional>
#include <string>

#include "collision_forge/planner_test/planners/dormand_prince.h"
#include "collision_forge/planner_test/planners/idm_law.h"
#include "collision_forge/planner_test/planners/idm_path.h"
#include "collision_forge/planner_test/planners/lead_search.h"
#include "collision_forge/planner_test/planners/planner.h"
#include "collision_forge/planner_test/planners/route_centerline.h"

namespace forge {

/// config/planners.yaml, section idm.standard, where each number's unit and source stand.
struct IdmOptions {
  IdmParameters law;
  LeadSearch lead;  ///< its margin is that of the background traffic alone
  double horizon = 0.0;
  double step = 0.5;  ///< s between points of a plan; nuPlan
};

/// config/planners.yaml, section idm.published.
struct PublishedIdmOptions {
  IdmParameters law;
  double step = 0.1;  ///< s over which the law is integrated at a time; published
  IntegrationTolerance tolerance{1.0e-3, 1.0e-6};  ///< relative; m and m/s: SciPy's defaults
};

/// nuPlan's IDMPlanner. The path are the centrelines of the lanes along the route (laneRoute(); the
/// route itself off the lanes). It is found at the first call of plan(), and so is the speed aimed
/// at: the limit of the first lane, or the ego's speed if that is higher. The lead is whoever,
/// within the radius, touches the corridor ahead or the ego's box and is nearest to that box; it
/// stands still throughout a plan, though its speed enters the law. On a free road the path's end
/// leads, standing.
class IdmPlanner : public Planner {
 public:
  IdmPlanner(const IdmOptions& options, const RouteCenterlineOptions& route)
      : options_(options), route_(route) {}
  void initialize(const DrivingTask& task) override;
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

  /// m/s; 0 before the first plan.
  double targetSpeed() const { return law_.desired_speed; }

 private:
  void setOut(const TrajectoryPoint& ego);

  IdmOptions options_;
  RouteCenterlineOptions route_;
  DrivingTask task_;
  IdmParameters law_;
  std::optional<IdmPath> path_;
};

/// m/s, of an ego that drives at `speed` behind a lead at `lead_speed` and `distance` m, one step
/// later: the law is integrated over the step with a lead that stands still meanwhile. An
/// integration that fails keeps its last value; not below zero.
double publishedIdmSpeed(const PublishedIdmOptions& options, double speed, double lead_speed,
                         double distance);

/// The intelligent driver model as the planner test of arXiv 2510.12206 has it: the lead is always
/// the attacker, at the distance of the boxes' middles, even when it is not ahead; the ego follows
/// its route at the speed of the step's end. Plans one step. Without the attacker in sight the road
/// is free.
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
