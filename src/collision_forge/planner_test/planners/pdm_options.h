#pragma once

#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/planner_test/planners/idm_law.h"
#include "collision_forge/planner_test/planners/route_centerline.h"

namespace forge {

// Options of PDM-Closed (Dauner et al. 2023, arXiv 2306.07962). Numbers without a key in
// planners.yaml are those in its published implementation, unless another source is named.

/// Approximation of nuPlan's roads, outlines and intersections from nuScenes maps, which do not
/// contain them. The drivable area is a raster of 0.5 m.
struct PdmMapOptions {
  /// m around the route's centreline; lanes farther away are left out of the map.
  double radius = 50.0;
  /// m, of lanes without an outline; also of the route where it leaves the lanes.
  double lane_width = kLaneWidth;
  double road_half_width = 7.0;  ///< m from the route's centreline, at most, of a lane of its road
  /// rad (45 degrees); a lane within `road_half_width` of the route and this angle of its direction
  /// belongs to the route's road.
  double road_heading = 0.785;
  double drivable_margin = 0.25;  ///< m that a corner of the box may be off the drivable area
};

/// Limits on the agents that are forecast; of each kind the nearest are kept.
struct PdmAgentOptions {
  /// m between the middles of the ego and an agent; farther agents are not seen.
  double radius = 50.0;
  int vehicles = 50;     ///< greatest number of agents, like the next three; includes motorcycles
  int pedestrians = 25;  ///< includes animals
  int bicycles = 10;     ///< without motorcycles
  int static_objects = 50;       ///< includes red lights
  double standing_speed = 0.05;  ///< m/s; at or below it an agent stands; nuPlan's metrics
};

/// Limits of nuPlan's comfort metrics. Limits are positive and hold for the absolute value, except
/// for acceleration along the heading and braking.
struct PdmComfortOptions {
  int jerk_window = 8;     ///< states over which acceleration is smoothed before its rate is taken
  int yaw_window = 5;      ///< states from which yaw rate and yaw acceleration are derived
  double max_jerk = 8.37;  ///< m/s3, rate of the magnitude of the acceleration
  double max_lateral_acceleration = 4.89;       ///< m/s2, to either side
  double max_longitudinal_acceleration = 2.40;  ///< m/s2, forwards along the heading
  double max_braking = 4.05;                    ///< m/s2, along the heading
  double max_yaw_acceleration = 1.93;           ///< rad/s2
  double max_longitudinal_jerk = 4.13;  ///< m/s3, rate of the acceleration along the heading
  double max_yaw_rate = 0.95;           ///< rad/s
};

/// Weights and thresholds of PdmScorer.
struct PdmScoringOptions {
  // Weights of the terms in PdmScore::total: config/planners.yaml, section pdm.scoring.
  double progress_weight = 0.0;  ///< of PdmScore::progress
  double ttc_weight = 0.0;       ///< of PdmScore::time_to_collision
  double comfort_weight = 0.0;   ///< of PdmScore::comfort
  /// PdmScore::collision after an at-fault collision with a static object.
  double static_collision_score = 0.5;
  /// m; if no proposal gets farther, all that are not excluded score 1 for progress.
  double min_progress = 0.1;
  /// s ahead of each state at which boxes are tested for contact, rounded to whole steps; not
  /// empty.
  std::vector<double> ttc_times = {0.0, 0.3, 0.6, 0.9};
  /// rad (30 degrees) off the ego's heading, seen from its rear axle; an agent within it is ahead;
  /// nuPlan's metrics.
  double ahead_angle = 0.5236;
  /// rad (150 degrees), likewise; an agent beyond it is behind; nuPlan's metrics, also of fault.
  double behind_angle = 2.61799388;
  /// m/s; at or below it the ego stands and no collision is its fault; nuPlan.
  double standing_speed = 0.05;
  double ttc_standing_speed = 0.005;  ///< m/s; below it the ego stands and its TTC is not tested
  /// m driven without a break off the route's lanes; below it PdmScore::driving_direction is 1.
  double wrong_way_distance = 2.0;
  /// m, likewise; between both distances the score is `wrong_way_score`, from here on 0.
  double max_wrong_way_distance = 6.0;
  double wrong_way_score = 0.5;  ///< PdmScore::driving_direction between both distances
  PdmComfortOptions comfort;     ///< limits of PdmScore::comfort
};

/// Options of the emergency brake (pdm_brake.h).
struct PdmBrakeOptions {
  double max_time = 2.0;   ///< s; brakes if the best proposal has an at-fault collision within it
  double max_speed = 5.0;  ///< m/s of the ego; brakes only at or below it
  /// m/s of the ego. Above it the braking poses have the speed overshoot (v + max(-gain v,
  /// -braking)); at or below it -standing_gain v - a, clamped to [-braking, max_acceleration] and
  /// taken as m/s. v: speed of the ego (m/s); a: acceleration of its box's middle (m/s2).
  double standing_speed = 0.2;
  double gain = 10.0;          ///< 1/s
  double overshoot = 1.1;      ///< factor
  double standing_gain = 4.0;  ///< 1/s
  /// m/s2 in the published controller; here a bound of a speed in m/s, as over 1 s.
  double braking = 4.05;
  double max_acceleration = 2.40;  ///< m/s2, likewise
};

/// Options of PdmPlanner: config/planners.yaml, section pdm, where the source of each of its keys
/// stands.
struct PdmOptions {
  PdmMapOptions map;                 ///< of roadAlong()
  double tracker_wheelbase = 3.089;  ///< m; nuPlan's car, also used for other cars
  double speed_limit = 0.0;          ///< m/s, used where the map has none
  /// m to the left of the centreline (negative: right), one per path of proposals, in any order.
  std::vector<double> lateral_offsets;
  std::vector<double> speed_shares;  ///< desired speeds of the proposals of each path, as shares of
                                     ///< the speed limit, in any order
  double step = 0.1;                 ///< s between two steps; must equal LqrOptions::step
  int proposal_steps = 0;            ///< number of steps that are simulated and scored
  int output_steps = 0;              ///< number of steps of a plan, at least `proposal_steps`
  int lead_interval = 2;             ///< number of steps between two searches for a lead
  IdmParameters idm;                 ///< each proposal sets desired_speed
  PdmAgentOptions agents;            ///< of the forecast
  PdmScoringOptions scoring;         ///< of the proposals
  PdmBrakeOptions emergency_brake;   ///< of a plan whose best proposal collides
};

}  // namespace forge
