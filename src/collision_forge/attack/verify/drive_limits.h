#pragma once

#include <array>

#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

class Section;

/// Limits of one vehicle as a kinematic single track whose rear axle rolls without slip (Althoff,
/// Koschi, Manzinger 2017, "CommonRoad: Composable benchmarks", vehicle model KS).
struct DriveLimits {
  double wheelbase = 0.0;                 ///< m
  double axle_to_middle = 0.0;            ///< m from the rear axle forward to the box centre
  double max_steering_angle = 0.0;        ///< rad, largest |angle| of the front wheel
  double max_steering_rate = 0.0;         ///< rad/s, largest |rate|
  double max_lateral_acceleration = 0.0;  ///< m/s2, largest |speed times yaw rate|
  double max_forward_acceleration = 0.0;  ///< m/s2, up to switching_speed
  double switching_speed = 0.0;           ///< m/s; above it engine power limits (1/speed)
  double max_braking = 0.0;  ///< m/s2, deceleration; also limits the total acceleration
  double max_jerk = 0.0;     ///< m/s3, largest |jerk| along the heading
  double max_speed = 0.0;    ///< m/s

  /// Returns the maximum forward acceleration at `speed` (m/s), m/s2.
  double forwardAt(double speed) const {
    return speed <= switching_speed ? max_forward_acceleration
                                    : max_forward_acceleration * switching_speed / speed;
  }
};

/// The vehicle classes of config/vehicle_limits.yaml; see vehicleClassOf().
enum class VehicleClass {
  kCar,           ///< car up to DriveLimitOptions::car_length; animal, static object
  kVan,           ///< longer car, or truck below DriveLimitOptions::van_length
  kEmergency,     ///< ambulance, police or fire vehicle of any length
  kTruck,         ///< truck from van_length up to DriveLimitOptions::truck_length
  kBus,           ///< bus of any length
  kArticulated,   ///< longer truck, taken as tractor with semi-trailer; trailer
  kConstruction,  ///< construction vehicle
  kMotorcycle,    ///< motorcycle with rider
  kBicycle,       ///< bicycle with rider
  kPedestrian,    ///< adult on foot, as a box that turns like a very short vehicle
  kChild,         ///< child on foot, as a box like kPedestrian
  kRunner,        ///< adult on foot who runs, as a box like kPedestrian
  kScooter,       ///< e-scooter or other personal mobility device, with its rider
};
inline constexpr std::array<VehicleClass, 13> kVehicleClasses = {
    VehicleClass::kCar,          VehicleClass::kVan,        VehicleClass::kEmergency,
    VehicleClass::kTruck,        VehicleClass::kBus,        VehicleClass::kArticulated,
    VehicleClass::kConstruction, VehicleClass::kMotorcycle, VehicleClass::kBicycle,
    VehicleClass::kPedestrian,   VehicleClass::kChild,      VehicleClass::kRunner,
    VehicleClass::kScooter};

/// Returns the class's key in config/vehicle_limits.yaml: "car", "van", "emergency", "truck",
/// "bus", "articulated", "construction", "motorcycle", "bicycle", "pedestrian", "child", "runner"
/// or "scooter".
const char* toString(VehicleClass vehicle_class);

/// Keys `drivable` and `lengths` of config/vehicle_limits.yaml, which has the sources.
struct DriveLimitOptions {
  /// In the order of kVehicleClasses; here wheelbase is a share 0..1 of the box length and
  /// axle_to_middle is unused.
  std::array<DriveLimits, kVehicleClasses.size()> rows;
  double car_length = 0.0;         ///< m; a longer car counts as a van
  double van_length = 0.0;         ///< m; a shorter truck counts as a van (pick-ups)
  double truck_length = 0.0;       ///< m; a longer truck counts as articulated
  double max_reverse_speed = 0.0;  ///< m/s, of all classes
};

/// Returns the class whose limits apply to an agent of this class and box size. Only cars and
/// trucks depend on the length; a length equal to a bound counts as the class named without it
/// (car, truck). A trailer is kArticulated; an animal or a static object counts as a car of its
/// length.
VehicleClass vehicleClassOf(AgentClass agent_class, const BoxSize& size,
                            const DriveLimitOptions& options);

/// Returns the limits of a vehicle: the row of its class with the wheelbase in m. Assumes equal
/// overhangs in front of the front axle and behind the rear axle.
DriveLimits driveLimitsOf(AgentClass agent_class, const BoxSize& size,
                          const DriveLimitOptions& options);

/// State of the kinematic single track.
struct DriveState {
  Pose2 axle;                 ///< centre of the rear axle, global map frame
  double speed = 0.0;         ///< m/s of the rear axle along the heading
  double acceleration = 0.0;  ///< m/s2 along the heading
  double steering = 0.0;      ///< rad, front wheel, positive to the left
};

/// Converts a recorded motion to a single-track state: speed, acceleration and, from the yaw rate,
/// steering angle, each clamped to the limits, also both accelerations together. A vehicle below
/// kStandstillSpeed, or one that reverses, stands with straight wheels.
DriveState driveStateOf(const Motion& motion, const DriveLimits& limits);

/// Reads the keys `drivable`, `lengths` and `max_reverse_speed`; kEmergency has no key and gets the
/// limits of kVan. Throws ConfigError for a missing key or a value out of range.
void readOptions(Section& section, DriveLimitOptions& options);

}  // namespace forge
