#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/idm_law.h"
#include "collision_forge/planner_test/planners/route_centerline.h"

namespace forge {

// config/planners.yaml, section pdm, where each number's unit and source stand.

struct PdmMapOptions {
  double radius = 0.0;
  double lane_width = 0.0;
  double road_half_width = 0.0;
  double road_heading = 0.0;
  double drivable_margin = 0.0;
};

struct PdmAgentOptions {
  double radius = 0.0;
  int vehicles = 0;
  int pedestrians = 0;
  int bicycles = 0;
  int static_objects = 0;
  double standing_speed = 0.0;
};

struct PdmComfortOptions {
  int jerk_window = 0;
  int yaw_window = 0;
  double max_jerk = 0.0;
  double max_lateral_acceleration = 0.0;
  double max_longitudinal_acceleration = 0.0;
  double max_braking = 0.0;
  double max_yaw_acceleration = 0.0;
  double max_longitudinal_jerk = 0.0;
  double max_yaw_rate = 0.0;
};

struct PdmScoringOptions {
  double progress_weight = 0.0;
  double ttc_weight = 0.0;
  double comfort_weight = 0.0;
  double static_collision_score = 0.0;
  double min_progress = 0.0;
  std::vector<double> ttc_times;
  double ahead_angle = 0.0;
  double behind_angle = 0.0;
  double standing_speed = 0.0;
  double ttc_standing_speed = 0.0;
  double wrong_way_distance = 0.0;
  double max_wrong_way_distance = 0.0;
  double wrong_way_score = 0.0;
  PdmComfortOptions comfort;
};

struct PdmBrakeOptions {
  double max_time = 0.0;
  double max_speed = 0.0;
  double standing_speed = 0.0;
  double gain = 0.0;
  double overshoot = 0.0;
  double standing_gain = 0.0;
  double braking = 0.0;
  double max_acceleration = 0.0;
};

struct PdmOptions {
  PdmMapOptions map;
  double tracker_wheelbase = 0.0;
  double speed_limit = 0.0;
  std::vector<double> lateral_offsets;
  std::vector<double> speed_shares;
  double step = 0.0;  ///< that of section lqr
  int proposal_steps = 0;
  int output_steps = 0;
  int lead_interval = 0;
  IdmParameters idm;  ///< desired_speed is set for each proposal
  PdmAgentOptions agents;
  PdmScoringOptions scoring;
  PdmBrakeOptions emergency_brake;
};

}  // namespace forge
