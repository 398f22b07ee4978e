#pragma once

#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/verify/options.h"
#include "collision_forge/base/scene/crash_definition.h"

namespace forge {

class ConfigFolder;
class Section;

/// config/search.yaml, section bicycle_family
struct BicycleOptions {
  int iterations = 0;
  double convergence = 0.0;
  double max_miss = 0.0;
  double turn_heading = 0.0;
  double position_scale = 0.0;
  double heading_scale = 0.0;
  double speed_scale = 0.0;
  double acceleration_scale = 0.0;
  double curvature_scale = 0.0;
};

/// config/search.yaml, section steering
struct SteeringOptions {
  double step = 0.0;
  int first_population = 0;
  int population = 0;
  int elites = 0;
  int rounds = 0;
  int considered = 0;
  int patience = 0;
  double hopeless = 0.0;
  double acceleration_deviation = 0.0;
  double curvature_deviation = 0.0;
  double least_acceleration_deviation = 0.0;
  double least_curvature_deviation = 0.0;
  double heading_weight = 0.0;
  double clearance = 0.0;
  double near = 0.0;
};

/// How hard somebody drives until its manoeuvre.
struct DrivingStyle {
  double forward = 0.0;  ///< m/s2
  double braking = 0.0;  ///< m/s2
  double lateral = 0.0;  ///< m/s2, in bends
  double jerk = 0.0;     ///< m/s3
  double cost = 0.0;     ///< as a share of the futures
};

/// config/search.yaml, section any_motion
struct AnyMotionOptions {
  int bicycle_targets = 0;
  int bicycle_rounds = 0;
};

/// config/search.yaml, section routes
struct RouteDriverOptions {
  std::vector<DrivingStyle> styles;  ///< the tamest first
  double variation = 0.0;
  std::vector<double> variation_periods;
  double limit_share = 0.0;
  double settling = 0.0;
  double return_distance = 0.0;
  double precision = 0.0;
  double preview = 0.0;
  int branches = 0;
  int ways = 0;
  double reach = 0.0;
  double max_departure = 0.0;
  double max_lean = 0.0;
  double heading_margin = 0.0;
  int drafted = 0;
  std::vector<double> contacts;
  std::vector<double> departures;
  std::vector<double> leads;
  std::vector<double> late_braking;
  double parking_distance = 0.0;
  std::vector<double> starts;
  int rounds = 0;
  int perturbations = 0;
  double departure_weight = 0.0;
  double off_lane_weight = 0.0;
  double off_road_weight = 0.0;
  double wrong_way_weight = 0.0;
};

/// A kind of vehicle that may be added.
struct AddedKind {
  AgentClass agent_class = AgentClass::kCar;
  double share = 0.0;
  double length = 0.0;  ///< m
  double length_deviation = 0.0;
  double width = 0.0;  ///< m
};

/// config/search.yaml, section added
struct AddedVehicleOptions {
  std::vector<AddedKind> kinds;
  int candidates = 0;
  int predicted_candidates = 0;
  double preference = 0.0;
  double sensing_range = 0.0;
  double least_past = 0.0;
  double clearance = 0.0;
  double min_on_lane = 0.0;
  double max_off_road = 0.0;
  int branches = 0;
  double way_ahead = 0.0;
  double lateral = 0.0;
  double braking = 0.0;
  std::vector<double> contacts;
  std::vector<double> speeds;
  std::vector<double> closings;
  double least_gap = 0.0;
  double train_distance = 0.0;
  std::vector<double> starts;
  std::vector<double> parked;
  double riding_gap = 0.0;
  double riding_cost = 0.0;
  double aside = 0.0;
  double wait = 0.0;
  double least_crossing_speed = 0.0;
};

/// config/search.yaml, section search
struct SearchOptions {
  double step = 0.0;
  double tail = 0.0;
  double depth = 0.0;
  double limit_margin = 0.0;
  double heading_margin = 0.0;
  double time_margin = 0.0;
  double overlap_margin = 0.0;
  int max_attackers = 0;
  int ego_poses = 0;
  int draws = 0;
  int homed = 0;
  int corrections = 0;
  double max_lead = 0.0;
  int kept = 0;
  int rounds = 0;
  int perturbations = 0;
  int bicycle_targets = 0;
  int bicycle_rounds = 0;
  int bicycle_perturbations = 0;
  double good_share = 0.0;
  double good_off_road = 0.0;
  double good_steering = 0.0;
  double off_road_weight = 0.0;
  double effort_weight = 0.0;
  double steering_weight = 0.0;
  double quick_steering = 0.0;
  double closeness_weight = 0.0;
  double pattern_weight = 0.0;
  double near_pattern = 0.0;
  double exact_distance = 0.0;
  double exact_heading = 0.0;
  std::vector<double> confidence_curve;  ///< at shares evenly spread over [0, 1]
};

/// Where the attackers of COLLIDE end, as seen from the ego: recovered from the files of the set.
struct NominalOptions {
  double end_distance = 4.0;   ///< m between the middles, in front (opposite direction) or behind
  double side_distance = 3.0;  ///< m to the left or right (junction crossing, ltap)
  double lane_change_ahead = 2.0;       ///< m ahead, plus the sine of the heading
  double lane_change_side = 1.0;        ///< m to the left or right, plus the cosine of the heading
  double lane_change_heading = 0.3491;  ///< rad (20 degrees) to the ego; the files have 10 to 30
};

/// Everything that the road from a snapshot to an attacker trajectory is tuned by.
struct AttackOptions {
  PredictionOptions prediction;
  SearchOptions search;
  RouteDriverOptions route;
  AnyMotionOptions any_motion;
  AddedVehicleOptions added;
  BicycleOptions bicycle;
  SteeringOptions steering;
  VerificationOptions verification;
  EgoFutureOptions ego_futures;
  NominalOptions nominal;
};

/// For whom a list of requests asks: for any attacker, or for each possible one by its id.
enum class Attackers { kAny, kEach };

/// What a list of requests is made of; stride, ttas and min_ego_speed by default those of
/// config/requests.yaml, where their units stand.
struct RequestListOptions {
  double stride = 0.0;
  std::vector<double> ttas;
  double min_ego_speed = 0.0;
  std::vector<CollisionType> types{std::begin(kCollisionTypes), std::end(kCollisionTypes)};
  Attackers attackers = Attackers::kAny;
  std::uint64_t seed = 0;  ///< of every request
};

void readOptions(Section& section, RequestListOptions& options);

/// Reads prediction.yaml, search.yaml, believability.yaml, vehicle_limits.yaml and
/// ego_futures.yaml.
void readAttackOptions(const ConfigFolder& directory, AttackOptions& options);

}  // namespace forge
