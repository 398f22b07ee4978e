#include "collision_forge/attack/verify/drive_limits.h"

#include <algorithm>

#include "collision_forge/base/config/section.h"
#include "collision_forge/base/geometry/enum_words.h"

namespace forge {
namespace {

constexpr EnumWord<VehicleClass> kClassWords[] = {
    {VehicleClass::kCar, "car"},
    {VehicleClass::kVan, "van"},
    {VehicleClass::kEmergency, "emergency"},
    {VehicleClass::kTruck, "truck"},
    {VehicleClass::kBus, "bus"},
    {VehicleClass::kArticulated, "articulated"},
    {VehicleClass::kConstruction, "construction"},
    {VehicleClass::kMotorcycle, "motorcycle"},
    {VehicleClass::kBicycle, "bicycle"},
    {VehicleClass::kPedestrian, "pedestrian"},
    {VehicleClass::kChild, "child"},
    {VehicleClass::kRunner, "runner"},
    {VehicleClass::kScooter, "scooter"},
};

void readRow(Section& section, DriveLimits& row) {
  row.wheelbase = section.share("wheelbase_share");
  row.max_steering_angle = section.angle("max_steering_angle");
  row.max_steering_rate = section.positive("max_steering_rate");
  row.max_lateral_acceleration = section.positive("max_lateral_acceleration");
  row.max_forward_acceleration = section.positive("max_forward_acceleration");
  row.switching_speed = section.positive("switching_speed");
  row.max_braking = section.positive("max_braking");
  row.max_jerk = section.positive("max_jerk");
  row.max_speed = section.positive("max_speed");
}

}  // namespace

const char* toString(VehicleClass vehicle_class) { return wordOf(kClassWords, vehicle_class); }

VehicleClass vehicleClassOf(AgentClass agent_class, const BoxSize& size,
                            const DriveLimitOptions& options) {
  switch (agent_class) {
    case AgentClass::kTruck:
      if (size.length < options.van_length) return VehicleClass::kVan;
      return size.length > options.truck_length ? VehicleClass::kArticulated : VehicleClass::kTruck;
    case AgentClass::kBus:
      return VehicleClass::kBus;
    case AgentClass::kTrailer:
      return VehicleClass::kArticulated;
    case AgentClass::kConstructionVehicle:
      return VehicleClass::kConstruction;
    case AgentClass::kEmergencyVehicle:
      return VehicleClass::kEmergency;
    case AgentClass::kMotorcycle:
      return VehicleClass::kMotorcycle;
    case AgentClass::kBicycle:
      return VehicleClass::kBicycle;
    case AgentClass::kPedestrian:
      return VehicleClass::kPedestrian;
    case AgentClass::kChild:
      return VehicleClass::kChild;
    case AgentClass::kRunner:
      return VehicleClass::kRunner;
    case AgentClass::kScooter:
      return VehicleClass::kScooter;
    default:
      return size.length > options.car_length ? VehicleClass::kVan : VehicleClass::kCar;
  }
}

DriveLimits driveLimitsOf(AgentClass agent_class, const BoxSize& size,
                          const DriveLimitOptions& options) {
  const VehicleClass row = vehicleClassOf(agent_class, size, options);
  DriveLimits limits = options.rows[static_cast<std::size_t>(row)];
  limits.wheelbase *= size.length;
  limits.axle_to_middle = 0.5 * limits.wheelbase;
  return limits;
}

DriveState driveStateOf(const Motion& motion, const DriveLimits& limits) {
  DriveState state;
  state.axle = compose(motion.pose, {-limits.axle_to_middle, 0.0, 0.0});
  if (motion.speed < kStandstillSpeed) return state;
  state.speed = std::min(motion.speed, limits.max_speed);
  const double lateral = std::clamp(state.speed * motion.yaw_rate, -limits.max_lateral_acceleration,
                                    limits.max_lateral_acceleration);
  // The acceleration yields to the friction circle, because its estimate is the less certain one.
  const double grip =
      std::sqrt(std::max(0.0, limits.max_braking * limits.max_braking - lateral * lateral));
  state.acceleration =
      std::clamp(motion.acceleration, -grip, std::min(grip, limits.forwardAt(state.speed)));
  state.steering = std::clamp(std::atan(limits.wheelbase * lateral / (state.speed * state.speed)),
                              -limits.max_steering_angle, limits.max_steering_angle);
  return state;
}

void readOptions(Section& section, DriveLimitOptions& options) {
  Section drivable = section.section("drivable");
  for (const VehicleClass vehicle_class : kVehicleClasses) {
    DriveLimits& limits = options.rows[static_cast<std::size_t>(vehicle_class)];
    if (vehicle_class == VehicleClass::kEmergency) {  // ambulances are vans
      limits = options.rows[static_cast<std::size_t>(VehicleClass::kVan)];
      continue;
    }
    Section row = drivable.section(toString(vehicle_class));
    readRow(row, limits);
    row.finish();
  }
  drivable.finish();
  Section lengths = section.section("lengths");
  options.car_length = lengths.positive("car");
  options.van_length = lengths.positive("van");
  options.truck_length = lengths.positive("truck");
  lengths.finish();
  options.max_reverse_speed = section.positive("max_reverse_speed");
}

}  // namespace forge
