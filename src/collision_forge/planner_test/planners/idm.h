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

/// Options of IdmPlanner and of reactive traffic (Background::kIdm): config/planners.yaml, section
/// idm.standard, where each number's source stands.
struct IdmOptions {
  IdmParameters law;  ///< `desired_speed` is used where the lane has no speed limit
  /// `radius`: of IdmPlanner, m between the middles of ego and agent; agents from there on are
  /// ignored; `margin` is used by the background traffic only.
  LeadSearch lead;
  double horizon = 0.0;  ///< s, length of a plan, rounded to a whole number of `step`; planner only
  double step = 0.5;     ///< s between points of a plan; nuPlan; planner only
};

/// Options of PublishedIdmPlanner: config/planners.yaml, section idm.published.
struct PublishedIdmOptions {
  IdmParameters law;  ///< parameters of the model
  double step = 0.1;  ///< s, duration of one integration and of one plan; published
  IntegrationTolerance tolerance{1.0e-3, 1.0e-6};  ///< relative; m and m/s: SciPy's defaults
};

/// nuPlan's IDMPlanner. It follows the centrelines of the lanes along the route (laneRoute(); the
/// route itself if no lane is near, and where these lanes end before it). The first plan() chooses
/// the path and the desired speed: the limit of the first lane (`law.desired_speed` if it has
/// none), or the ego's speed if that is higher. The lead is the nearest agent or red light
/// (withRedLights()) within `lead.radius` that touches the corridor of the ego's width ahead, or
/// the ego's box. Its position is fixed throughout a plan, but its speed (component along the ego's
/// heading) enters the law. Without a lead the ego treats the path's end as a standing lead; poses
/// do not go beyond it.
class IdmPlanner : public Planner {
 public:
  /// `route`: how lanes along the route are found.
  IdmPlanner(const IdmOptions& options, const RouteCenterlineOptions& route)
      : options_(options), route_(route) {}
  /// As Planner::initialize(). Throws std::invalid_argument for a route without two distinct
  /// points.
  void initialize(const DrivingTask& task) override;
  /// As Planner::plan(): a point now and every `step` seconds up to `horizon`. All poses are on the
  /// path, also the first, which otherwise is the observed ego. The task must have lanes.
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

  /// Returns the desired speed that the first plan() chose, m/s; 0 before it.
  double targetSpeed() const { return law_.desired_speed; }

 private:
  /// Chooses lanes, path and desired speed for an ego at its first observation.
  void setOut(const TrajectoryPoint& ego);

  IdmOptions options_;
  RouteCenterlineOptions route_;
  DrivingTask task_;
  IdmParameters law_;               ///< with the chosen desired speed
  std::vector<std::size_t> lanes_;  ///< of the path, indices in LaneMap::lanes
  std::optional<IdmPath> path_;     ///< set by the first plan()
};

/// Returns the ego's speed (m/s, >= 0) after `options.step` seconds behind a lead, by integrating
/// plainIdmAcceleration() with integrateDormandPrince(). `speed`: the ego's speed at the start,
/// m/s; `lead_speed`: m/s, enters the law; `distance`: initial gap to the lead, m, infinite for a
/// free road (0: the integration fails); the lead's position stays fixed. If the integration fails,
/// uses its last accepted state.
double publishedIdmSpeed(const PublishedIdmOptions& options, double speed, double lead_speed,
                         double distance);

/// The intelligent driver model as the planner test of arXiv 2510.12206 uses it. The lead is always
/// the attacker, even if it is not ahead; the gap is the distance between the boxes' middles, the
/// lead's speed the norm of its velocity. The ego drives from the nearest place of its route along
/// it (straight on beyond its end) at the speed at the end of the step (publishedIdmSpeed()). Each
/// plan has two points, now and one step later. If the attacker is not in sight, the ego drives as
/// on a free road. Red lights are ignored.
class PublishedIdmPlanner : public Planner {
 public:
  /// `attacker_id`: id of the lead in Observation::agents.
  PublishedIdmPlanner(const PublishedIdmOptions& options, std::string attacker_id)
      : options_(options), attacker_id_(std::move(attacker_id)) {}
  /// As Planner::initialize(). Throws std::invalid_argument for a route without two distinct
  /// points.
  void initialize(const DrivingTask& task) override;
  /// As Planner::plan(): the observed ego and one point `options.step` seconds later.
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

 private:
  PublishedIdmOptions options_;
  std::string attacker_id_;
  std::optional<Polyline> route_;
};

}  // namespace forge
