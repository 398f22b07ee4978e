#pragma once

#include <array>

#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

class Section;

/// What one vehicle can do, as a kinematic single track: the rear axle rolls without slip (Althoff,
/// Koschi, Manzinger 2017, "CommonRoad: Composable benchmarks", vehicle model KS).
struct DriveLimits {
  double wheelbase = 0.0;                 ///< m
  double axle_to_middle = 0.0;            ///< m from the rear axle ahead to the box's middle
  double max_steering_angle = 0.0;        ///< rad, of the front wheel
  double max_steering_rate = 0.0;         ///< rad/s
  double max_lateral_acceleration = 0.0;  ///< m/s2, speed times yaw rate
  double max_forward_acceleration = 0.0;  ///< m/s2, up to switching_speed
  double switching_speed = 0.0;           ///< m/s, above it the engine's power is the limit
  double max_braking = 0.0;               ///< m/s2, and the greatest total acceleration
  double max_jerk = 0.0;                  ///< m/s3 along the heading
  double max_speed = 0.0;                 ///< m/s

  /// The greatest forward acceleration at a speed, m/s2.
  double forwardAt(double speed) const {
    return speed <= switching_speed ? max_forward_acceleration
                                    : max_forward_acceleration * switching_speed / speed;
  }
};

/// The rows of config/vehicle_limits.yaml.
enum class VehicleClass {
  kCar,
  kVan,
  kEmergency,
  kTruck,
  kBus,
  kArticulated,
  kConstruction,
  kMotorcycle,
};
inline constexpr std::array<VehicleClass, 8> kVehicleClasses = {
    VehicleClass::kCar,          VehicleClass::kVan,       VehicleClass::kEmergency,
    VehicleClass::kTruck,        VehicleClass::kBus,       VehicleClass::kArticulated,
    VehicleClass::kConstruction, VehicleClass::kMotorcycle};

/// "car", "van", ..., as in config/vehicle_limits.yaml.
const char* toString(VehicleClass vehicle_class);

/// config/vehicle_limits.yaml, drivable and lengths; units and sources stand there.
struct DriveLimitOptions {
  /// One row a class, in the order of kVehicleClasses; wheelbase as a share of the length.
  std::array<DriveLimits, kVehicleClasses.size()> rows;
  double car_length = 0.0;    ///< m; a longer car is a van
  double van_length = 0.0;    ///< m; a shorter truck is a van, as pick-ups are
  double truck_length = 0.0;  ///< m; a longer truck pulls a trailer within its box
};

/// The class whose limits a vehicle keeps.
VehicleClass vehicleClassOf(AgentClass agent_class, const BoxSize& size,
                            const DriveLimitOptions& options);

/// The limits of a vehicle; the overhangs ahead of the front axle and behind the rear axle are
/// taken to be equal.
DriveLimits driveLimitsOf(AgentClass agent_class, const BoxSize& size,
                          const DriveLimitOptions& options);

/// A state of the single track.
struct DriveState {
  Pose2 axle;                 ///< of the rear axle's middle, global map frame
  double speed = 0.0;         ///< m/s along the heading, of the rear axle
  double acceleration = 0.0;  ///< m/s2 along the heading
  double steering = 0.0;      ///< rad, of the front wheel, positive to the left
};

/// The state that a recorded motion is in: speed and acceleration along the heading and the
/// steering angle that its yaw rate needs, each held to the limits. Below kStandstillSpeed
/// it stands, with the wheels straight.
DriveState driveStateOf(const Motion& motion, const DriveLimits& limits);

void readOptions(Section& section, DriveLimitOptions& options);

}  // namespace forge
