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

/// Budget of the search along routes (searchManoeuvres()). Adaptive attackers use less, as they
/// search every update step.
struct RouteDriverOptions {
  int ways = 6;            ///< most routes near the ego that an attacker may take
  int rounds = 3;          ///< rounds of perturbation of the best candidates
  int perturbations = 40;  ///< perturbed candidates per round
};

/// A kind of vehicle that may be added.
struct AddedKind {
  AgentClass agent_class = AgentClass::kCar;
  /// relative frequency 0..1 among the added vehicles (they need not sum to 1); 0: only if a
  /// request names the class
  double share = 0.0;
  double length = 0.0;            ///< m, median
  double length_deviation = 0.0;  ///< m, standard deviation of the length
  double width = 0.0;             ///< m
};

/// config/search.yaml, section added: vehicles that are inserted
struct AddedVehicleOptions {
  std::vector<AddedKind> kinds;  ///< one per kind of the file, in the order car, van, truck (both
                                 ///< AgentClass::kTruck), bus, construction and emergency vehicle,
                                 ///< motorcycle, bicycle, pedestrian, child, runner, scooter; the
                                 ///< first is the car
  int candidates = 0;            ///< most vehicles searched if the ego's future is known
  int predicted_candidates = 0;  ///< most vehicles searched if the ego's future is predicted
  /// difference of scoreOf() by which an added attacker must exceed a recorded one
  double preference = 0.0;
  double sensing_range = 0.0;  ///< m from the ego's box centre, beyond which a vehicle may appear
  /// s; least time before t0 at which an added vehicle appears in the recording; one that exists
  /// since the first frame needs none
  double least_past = 0.0;
  std::vector<double> speeds;  ///< m/s of an added vehicle, tried in this order
};

/// config/search.yaml, section search; fields with a default are not in the file. The study and
/// tests change them for searches with another objective or a smaller budget. An arrival is
/// the state of the attacker that a motion ends in, at the contact or a little before it (Arrival,
/// `max_lead`); a candidate is a motion to an arrival.
struct SearchOptions {
  double step = 0.0;         ///< s between trajectory points
  double tail = 0.0;         ///< s of trajectory after the impact
  double time_margin = 0.0;  ///< s kept to either end of the time tolerance
  int max_attackers = 0;     ///< most candidates (vehicles) that are searched
  /// share 0..1 of the futures; a candidate that hits at least this share ends the search
  double good_share = 0.0;
  /// Confidence, 0..1, of an attack that hits a share of the ego's sampled futures, rising; entry i
  /// of n stands for the share i / (n - 1), linear between entries.
  std::vector<double> confidence_curve;

  /// m; attacker and ego overlap by at least twice this, other agents are passed with it to spare.
  double overlap_margin = 0.04;
  // Costs, as shares of the sampled futures:
  double off_road_weight = 0.4;  ///< cost of an attack that is wholly off the road
  double steering_weight = 0.3;  ///< largest cost of steering faster than any driver (0.3 1/(m s)
                                 ///< of curvature); half of it at twice that
  // A candidate that is better than good_share ends the search unless ...
  double good_off_road = 0.05;  ///< ... a greater share of its box is off the drivable area
  double good_steering = 0.6;   ///< ... or its curvature changes faster, 1/(m s)
  /// s; in half of the draws the attacker drives straight on for a random time up to this before
  /// the contact.
  double max_lead = 0.6;
  // Budget:
  int ego_poses = 3;  ///< most futures of the ego that are aimed at, spread along its path
  int draws = 16;     ///< arrivals drawn per pattern, the pattern's own first
  int corrected_candidates =
      3;                ///< best candidates whose arrival is shifted by the error of their contact
  int corrections = 3;  ///< shifts of the arrival per such candidate
  int kept = 10;   ///< best candidates per family (quintic, bicycle) that are kept and perturbed
  int rounds = 4;  ///< rounds of perturbation
  int perturbations = 60;    ///< perturbed candidates per round
  int bicycle_targets = 40;  ///< arrivals tried with the bicycle, if no quintic is good enough
  int bicycle_rounds = 6;    ///< rounds of perturbation of bicycle motions
  int bicycle_perturbations = 100;  ///< perturbed bicycle motions per round
  int steering_rounds = 9;          ///< rounds of SteeringSearch
};

/// End poses of the attackers in COLLIDE relative to the ego, recovered from the files of the data
/// set.
struct NominalOptions {
  /// m between the box centres; attacker in front (opposite direction) or behind (rear end)
  double end_distance = 4.0;
  /// m between the box centres, to the left or right (junction crossing, ltap, angle types)
  double side_distance = 3.0;
  /// lane change and sideswipe: m ahead of the ego's box centre, to which the sine of
  /// lane_change_heading is added
  double lane_change_ahead = 2.0;
  /// m to the left or right, to which the cosine of lane_change_heading is added
  double lane_change_side = 1.0;
  /// rad (20 degrees) towards the ego; the files have 10 to 30
  double lane_change_heading = 0.3491;
};

/// All options of the computation from a snapshot to an attacker trajectory.
struct AttackOptions {
  PredictionOptions prediction;
  SearchOptions search;
  RouteDriverOptions route;  ///< not in a file
  AddedVehicleOptions added;
  VerificationOptions verification;
  EgoFutureOptions ego_futures;
  NominalOptions nominal;  ///< not in a file
};

/// Attackers that a list of requests names: kAny: none, so any vehicle may attack; kEach: each
/// motor vehicle of the snapshot by its id, and each agent of the class that the request names.
enum class Attackers { kAny, kEach };

/// Contents of a list of requests. The defaults of stride, ttas and min_ego_speed are in
/// config/requests.yaml.
struct RequestListOptions {
  double stride = 0.0;         ///< s between the times of requests
  std::vector<double> ttas;    ///< s from t0 to the contact
  double min_ego_speed = 0.0;  ///< m/s; times at which the ego is slower are left out
  std::vector<CollisionType> types{std::begin(kCollisionTypes), std::end(kCollisionTypes)};
  Attackers attackers = Attackers::kAny;
  std::uint64_t seed = 0;  ///< of every request
};

/// Reads stride, ttas and min_ego_speed from config/requests.yaml. Throws ConfigError for a missing
/// key or a value out of range.
void readOptions(Section& section, RequestListOptions& options);

/// Reads prediction.yaml, search.yaml, believability.yaml, severity.yaml, vehicle_limits.yaml and
/// ego_futures.yaml of `directory`, and sets PredictionOptions::tail. Throws ConfigError for a
/// missing file or key, or a value out of range.
void readAttackOptions(const ConfigFolder& directory, AttackOptions& options);

}  // namespace forge
