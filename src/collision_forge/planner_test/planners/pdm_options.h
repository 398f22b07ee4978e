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
  double radius = 50.0;            ///< m around the ego's middle; farther agents are ignored
  double lane_width = kLaneWidth;  ///< m; also of the route where it leaves the lanes
  double road_half_width = 7.0;    ///< m from the route; a lane within this distance ...
  double road_heading = 0.785;  ///< rad (45 degrees) ... and this angle is part of the route's road
  double drivable_margin = 0.25;  ///< m that a corner of the box may be off the drivable area
};

/// Limits on the agents that are forecast; of each kind the nearest are kept.
struct PdmAgentOptions {
  double radius = 50.0;          ///< m around the ego's middle; farther agents are not seen
  int vehicles = 50;             ///< number of agents, like the next three
  int pedestrians = 25;          ///< includes animals
  int bicycles = 10;             ///< includes no motorcycles, which are vehicles
  int static_objects = 50;       ///< includes red lights
  double standing_speed = 0.05;  ///< m/s; at or below it an agent stands; nuPlan's metrics
};

/// Limits of nuPlan's comfort metrics.
struct PdmComfortOptions {
  int jerk_window = 8;     ///< states over which acceleration is smoothed before its rate is taken
  int yaw_window = 5;      ///< states that rates of the yaw are derived from
  double max_jerk = 8.37;  ///< m/s3
  double max_lateral_acceleration = 4.89;       ///< m/s2
  double max_longitudinal_acceleration = 2.40;  ///< m/s2
  double max_braking = 4.05;                    ///< m/s2
  double max_yaw_acceleration = 1.93;           ///< rad/s2
  double max_longitudinal_jerk = 4.13;          ///< m/s3
  double max_yaw_rate = 0.95;                   ///< rad/s
};

/// Weights and thresholds of PdmScorer.
struct PdmScoringOptions {
  // Weights of the terms in PdmScore::total: config/planners.yaml, section pdm.scoring.
  double progress_weight = 0.0;
  double ttc_weight = 0.0;
  double comfort_weight = 0.0;
  double static_collision_score = 0.5;  ///< score of a collision with a static object
  double min_progress = 0.1;  ///< m; if no proposal gets farther, all score 1 for progress
  std::vector<double> ttc_times = {0.0, 0.3, 0.6, 0.9};  ///< s ahead of each state
  double ahead_angle = 0.5236;        ///< rad (30 degrees) off the ego's heading; nuPlan's metrics
  double behind_angle = 2.61799388;   ///< rad (150 degrees); nuPlan's metrics, also of fault
  double standing_speed = 0.05;       ///< m/s; at or below it the ego stands in a collision; nuPlan
  double ttc_standing_speed = 0.005;  ///< m/s; below it the ego stands and its TTC is not tested
  double wrong_way_distance = 2.0;    ///< m off the route's lanes without penalty
  double max_wrong_way_distance = 6.0;  ///< m off the route's lanes up to which ...
  double wrong_way_score = 0.5;         ///< ... the score is this; beyond it the score is 0
  PdmComfortOptions comfort;
};

/// Options of the emergency brake (pdm_brake.h).
struct PdmBrakeOptions {
  double max_time = 2.0;   ///< s; brakes if the best proposal has an at-fault collision within it
  double max_speed = 5.0;  ///< m/s; brakes only at or below it
  /// m/s. Above it the braking poses have the speed overshoot (v + max(-gain v, -braking)); at or
  /// below it -standing_gain v - a, clamped to [-braking, max_acceleration].
  double standing_speed = 0.2;
  double gain = 10.0;              ///< 1/s
  double overshoot = 1.1;          ///< factor
  double standing_gain = 4.0;      ///< 1/s
  double braking = 4.05;           ///< m/s2
  double max_acceleration = 2.40;  ///< m/s2
};

/// Options of PdmPlanner: config/planners.yaml, section pdm, where the source of each of its keys
/// stands.
struct PdmOptions {
  PdmMapOptions map;
  double tracker_wheelbase = 3.089;     ///< m; nuPlan's car, also used for other cars
  double speed_limit = 0.0;             ///< m/s, where the map has none
  std::vector<double> lateral_offsets;  ///< m to the left of the centreline
  std::vector<double> speed_shares;     ///< share 0..1 of the speed limit
  double step = 0.1;                    ///< s; must equal LqrOptions::step
  int proposal_steps = 0;               ///< steps that are simulated and scored
  int output_steps = 0;                 ///< steps of a plan
  int lead_interval = 2;                ///< steps between two searches for a lead
  IdmParameters idm;                    ///< each proposal sets desired_speed
  PdmAgentOptions agents;
  PdmScoringOptions scoring;
  PdmBrakeOptions emergency_brake;
};

}  // namespace forge
