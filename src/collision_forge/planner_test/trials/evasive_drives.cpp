#include "collision_forge/planner_test/trials/evasive_drives.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/geometry/enum_words.h"
#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

constexpr double kStanding = 1e-3;  // m/s; below it grip does not limit the car
constexpr EnumWord<EvasiveManoeuvre> kManoeuvreNames[] = {
    {EvasiveManoeuvre::kKeeping, "keeping"},
    {EvasiveManoeuvre::kBraking, "braking"},
    {EvasiveManoeuvre::kAccelerating, "accelerating"},
    {EvasiveManoeuvre::kSteering, "steering"},
    {EvasiveManoeuvre::kBoth, "both"},
};

std::vector<EvasivePlan> listPlans(const AvoidabilityOptions& options,
                                   const VehicleLimits& limits) {
  constexpr double kNarrowest = 1e-3;  // m; below it there is no lateral offset
  std::vector<EvasivePlan> plans;
  for (const double acceleration : options.accelerations) {
    for (const double offset : options.offsets) {
      for (const double duration : options.durations) {
        plans.push_back({{acceleration, offset}, duration, {0.0, offset}});
        if (acceleration == 0.0) break;  // the duration has no effect
      }
    }
  }
  double widest = kNarrowest;
  for (const double offset : options.offsets) widest = std::max(widest, std::abs(offset));
  const double longest = *std::max_element(options.durations.begin(), options.durations.end());
  Random random(options.seed);
  const auto draw = [&] {
    const double acceleration =
        random.uniform(-limits.max_braking, limits.max_forward_acceleration);
    return EvasiveDemand{acceleration, random.uniform(-widest, widest)};
  };
  for (int i = 0; i < options.draws; ++i) {
    const EvasiveDemand first = draw();
    const double duration = random.uniform(0.0, longest);
    plans.push_back({first, duration, draw()});
  }
  const auto strength = [&](const EvasivePlan& plan) {
    const double effort = std::abs(plan.first.acceleration) + std::abs(plan.second.acceleration);
    return effort / limits.max_total_acceleration + std::abs(plan.first.offset) / widest;
  };
  std::stable_sort(plans.begin(), plans.end(), [&](const EvasivePlan& a, const EvasivePlan& b) {
    return strength(a) < strength(b);
  });
  return plans;
}

/// State of a car along a path, middle of the box.
struct Car {
  Pose2 pose;
  double speed = 0.0;       ///< m/s
  double arc_length = 0.0;  ///< m along the path
  double offset = 0.0;      ///< m to the left of it
  double heading = 0.0;     ///< rad from the path's
};

/// Simulates plans from one start.
class PlanDriver {
 public:
  PlanDriver(const ReferencePath& path, const AvoidabilityOptions& options,
             const AttackOptions& attack)
      : path_(path),
        options_(options),
        limits_(attack.verification.limits),
        total_(kLimitMargin * limits_.max_total_acceleration) {}

  Car carAt(const Pose2& pose, double speed) const {
    const double arc_length = path_.project(pose.position());
    const Pose2 local = relativeTo(path_.at(arc_length).pose, pose);
    return {pose, speed, arc_length, local.y, local.yaw};
  }

  /// Simulates from `start` to `end`: a point every step and one at the end. Offsets are relative
  /// to the car's current lateral position, which need not be the path.
  void drive(Car car, const EvasivePlan& plan, double start, double end,
             std::vector<TrajectoryPoint>& points) const {
    points.clear();
    const double own_offset = car.offset;
    for (double time = start;;) {
      const EvasiveDemand& demand = time - start < plan.duration ? plan.first : plan.second;
      const double step = std::min(options_.step, end - time);
      const ReferencePath::PathPoint place = path_.at(car.arc_length);
      const double acceleration = accelerationOf(demand, car, step);
      const double curvature =
          curvatureOf(car, place, own_offset + demand.offset, acceleration, step);
      points.push_back({time, car.pose, car.speed, acceleration, curvature});
      if (step <= kTimeEpsilon) break;
      advance(car, place, acceleration, curvature, step);
      time = std::min(time + step, end);
    }
  }

 private:
  double accelerationOf(const EvasiveDemand& demand, const Car& car, double step) const {
    if (step <= kTimeEpsilon) return 0.0;
    const double wanted =
        std::clamp(demand.acceleration, -total_, limits_.max_forward_acceleration);
    return std::clamp(wanted, -car.speed / step, (limits_.max_speed - car.speed) / step);
  }

  /// Steers towards the offset without overshoot, as far as grip and steering permit.
  double curvatureOf(const Car& car, const ReferencePath::PathPoint& place, double offset,
                     double acceleration, double step) const {
    const double distance =
        std::max(options_.min_return_distance, car.speed * options_.return_time);
    const double wanted = place.curvature - (car.offset - offset) / (distance * distance) -
                          2.0 * car.heading / distance;
    const double across = std::sqrt(std::max(total_ * total_ - acceleration * acceleration, 0.0));
    const double speed = std::max(car.speed, car.speed + acceleration * step);
    const double bound =
        std::min(limits_.max_curvature, across / std::max(speed * speed, kStanding * kStanding));
    return std::clamp(wanted, -bound, bound);
  }

  static void advance(Car& car, const ReferencePath::PathPoint& place, double acceleration,
                      double curvature, double step) {
    const double driven = (car.speed + 0.5 * acceleration * step) * step;
    const double turned = curvature * driven;
    const double yaw = car.pose.yaw + 0.5 * turned;
    car.pose.x += driven * std::cos(yaw);
    car.pose.y += driven * std::sin(yaw);
    car.pose.yaw = wrapAngle(car.pose.yaw + turned);
    const double heading = car.heading + 0.5 * turned;
    const double widening = std::max(1.0 - place.curvature * car.offset, 0.1);
    const double along = driven * std::cos(heading) / widening;
    car.arc_length += along / place.stretch;
    car.offset += driven * std::sin(heading);
    car.heading = wrapAngle(car.heading + turned - place.curvature * along);
    car.speed = std::max(car.speed + acceleration * step, 0.0);
  }

  const ReferencePath& path_;
  const AvoidabilityOptions& options_;
  const VehicleLimits& limits_;
  double total_;  // m/s2
};

}  // namespace

const char* toString(EvasiveManoeuvre manoeuvre) { return wordOf(kManoeuvreNames, manoeuvre); }

std::optional<EvasiveManoeuvre> evasiveManoeuvreFromString(const std::string& name) {
  return valueOf(kManoeuvreNames, name);
}

double speedOf(const AgentState& state) {
  return std::max(state.velocity.dot(state.pose.heading()), 0.0);
}

EvasiveManoeuvre kindOf(const EvasivePlan& plan) {
  const bool steers = plan.first.offset != 0.0 || plan.second.offset != 0.0;
  const double change =
      plan.first.acceleration != 0.0 ? plan.first.acceleration : plan.second.acceleration;
  if (steers) return change == 0.0 ? EvasiveManoeuvre::kSteering : EvasiveManoeuvre::kBoth;
  if (change == 0.0) return EvasiveManoeuvre::kKeeping;
  return change < 0.0 ? EvasiveManoeuvre::kBraking : EvasiveManoeuvre::kAccelerating;
}

Obstacles::Obstacles(const Future& others, double start, double end, double step) {
  add(others.ego, start, end, step);
  for (const Track& other : others.agents) add(other, start, end, step);
}

void Obstacles::add(const Track& other, double start, double end, double step) {
  Course course{other.size, circumradius(other.size), {}};
  for (double time = start;; time = std::min(time + step, end)) {
    const auto state = stateAt(other, time);
    course.poses.push_back(state ? std::optional<Pose2>(state->pose) : std::nullopt);
    if (time >= end - kTimeEpsilon) break;
  }
  courses_.push_back(std::move(course));
}

bool Obstacles::areClearOf(const std::vector<TrajectoryPoint>& points, const BoxSize& size) const {
  const double own_reach = circumradius(size);
  for (const Course& course : courses_) {
    const double reach = own_reach + course.reach;
    const std::size_t count = std::min(points.size(), course.poses.size());
    for (std::size_t i = 0; i < count; ++i) {
      const auto& pose = course.poses[i];
      if (!pose) continue;
      const Vector2 apart = pose->position() - points[i].pose.position();
      if (apart.squaredNorm() > reach * reach) continue;
      if (overlaps({points[i].pose, size}, {*pose, course.size})) return false;
    }
  }
  return true;
}

EvasiveDrives::EvasiveDrives(const CrashScenario& scenario, const AvoidabilityOptions& options,
                             const RouteOptions& route, const AttackOptions& attack)
    : scenario_(scenario),
      options_(options),
      attack_(attack),
      path_(Polyline(routeOf(scenario.recorded.ego, *scenario.lanes, route))),
      plans_(listPlans(options, attack.verification.limits)) {
  double& max_speed = attack_.verification.limits.max_speed;
  for (const AgentState& state : scenario.recorded.ego.states) {
    max_speed = std::max(max_speed, speedOf(state));
  }
}

void EvasiveDrives::drive(const AgentState& from, const EvasivePlan& plan,
                          std::vector<TrajectoryPoint>& points) const {
  const PlanDriver driver(path_, options_, attack_);
  driver.drive(driver.carAt(from.pose, speedOf(from)), plan, from.time, scenario_.end(), points);
}

BoxSize EvasiveDrives::wideBox() const {
  const BoxSize& size = scenario_.ego.size;
  return {size.length + 2.0 * options_.margin, size.width + 2.0 * options_.margin};
}

bool EvasiveDrives::isOnRoad(const Pose2& pose) const {
  const AreaRaster& drivable = scenario_.lanes->drivable();
  if (drivable.empty()) return true;
  for (const Vector2& corner : corners({pose, scenario_.ego.size})) {
    if (!drivable.contains(corner)) return false;
  }
  return true;
}

bool EvasiveDrives::leavesRoad(const std::vector<TrajectoryPoint>& points) const {
  return isOnRoad(points.front().pose) &&
         std::any_of(points.begin(), points.end(),
                     [this](const TrajectoryPoint& point) { return !isOnRoad(point.pose); });
}

CollisionReport EvasiveDrives::verify(const std::vector<TrajectoryPoint>& points,
                                      const Future& others) const {
  const AttackerTrajectory ego{kEgoId, AgentClass::kCar, scenario_.ego.size, points};
  Snapshot snapshot;
  snapshot.now = points.front().time;
  CollisionRequest request;
  request.crash.limits = LimitSet::kStrict;  // the limits of the simulated plans
  return verifyDrive(ego, {snapshot, others, request, *scenario_.lanes}, attack_.verification);
}

bool EvasiveDrives::isEvasion(const CollisionReport& report) {
  return !report.contact && report.first_other_id.empty() && report.limits_kept;
}

double EvasiveDrives::shareOff(const std::vector<TrajectoryPoint>& points,
                               const CollisionReport& report) const {
  return offRoadShare({kEgoId, AgentClass::kCar, scenario_.ego.size, points}, report,
                      *scenario_.lanes, attack_.verification);
}

}  // namespace forge
