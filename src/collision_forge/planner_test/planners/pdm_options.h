#pragma once

#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/planner_test/planners/idm_law.h"
#include "collision_forge/planner_test/planners/route_centerline.h"

namespace forge {

// PDM-Closed (Dauner et al. 2023, arXiv 2306.07962). What planners.yaml has no key for is as in its
// published implementation, unless another source is named.

/// What nuScenes' maps know; nuPlan's have roads, outlines and intersections. The drivable area is
/// known to half a metre.
struct PdmMapOptions {
  double radius = 50.0;            ///< m around the route in which lanes are known; published
  double lane_width = kLaneWidth;  ///< m; also of the route where it leaves the lanes
  double road_half_width = 7.0;    ///< m; a lane this near beside the route ...
  double road_heading = 0.785;     ///< rad (45 degrees) ... along which it goes is of its road
  double drivable_margin = 0.25;   ///< m of the box that may be off the drivable area
};

/// The nearest agents of each kind that are looked at.
struct PdmAgentOptions {
  double radius = 50.0;  ///< m around the ego's middle; farther agents are not seen
  int vehicles = 50;
  int pedestrians = 25;  ///< with animals
  int bicycles = 10;
  int static_objects = 50;
  double standing_speed = 0.05;  ///< m/s; at or below it an agent stands; nuPlan's metrics
};

/// Limits of comfort of nuPlan's metrics.
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

struct PdmScoringOptions {
  double progress_weight = 0.0;  ///< config/planners.yaml, section pdm.scoring, like the next two
  double ttc_weight = 0.0;
  double comfort_weight = 0.0;
  double static_collision_score = 0.5;  ///< of a collision with a static object
  double min_progress = 0.1;  ///< m; if no proposal gets farther, all make the same progress
  std::vector<double> ttc_times = {0.0, 0.3, 0.6, 0.9};  ///< s ahead of each state
  double ahead_angle = 0.5236;       ///< rad (30 degrees) off the ego's heading; nuPlan's metrics
  double behind_angle = 2.61799388;  ///< rad (150 degrees); nuPlan's metrics, also of fault
  double standing_speed = 0.05;  ///< m/s; at or below it the ego stands in a collision; the same
  double ttc_standing_speed = 0.005;    ///< m/s; below it the ego stands in terms of ttc
  double wrong_way_distance = 2.0;      ///< m off the route's lanes that are let pass
  double max_wrong_way_distance = 6.0;  ///< m, up to which ...
  double wrong_way_score = 0.5;         ///< ... this is the score
  PdmComfortOptions comfort;
};

/// The emergency brake, instead of the best proposal.
struct PdmBrakeOptions {
  double max_time = 2.0;   ///< s to an at-fault collision of the best proposal, at most
  double max_speed = 5.0;  ///< m/s, at most
  /// m/s; above it the poses are laid out at overshoot (v + max(-gain v, -braking)), at or below it
  /// at -standing_gain v - a, from -braking to max_acceleration.
  double standing_speed = 0.2;
  double gain = 10.0;  ///< 1/s
  double overshoot = 1.1;
  double standing_gain = 4.0;      ///< 1/s
  double braking = 4.05;           ///< m/s2
  double max_acceleration = 2.40;  ///< m/s2
};

/// config/planners.yaml, section pdm, where the unit and source of each of its keys stand.
struct PdmOptions {
  PdmMapOptions map;
  double tracker_wheelbase = 3.089;  ///< m; nuPlan's car, also for others
  double speed_limit = 0.0;
  std::vector<double> lateral_offsets;
  std::vector<double> speed_shares;
  double step = 0.1;  ///< s; that of LqrOptions
  int proposal_steps = 0;
  int output_steps = 0;
  int lead_interval = 2;  ///< steps from one search for a lead to the next
  IdmParameters idm;      ///< desired_speed is set for each proposal
  PdmAgentOptions agents;
  PdmScoringOptions scoring;
  PdmBrakeOptions emergency_brake;
};

}  // namespace forge
