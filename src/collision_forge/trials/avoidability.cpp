#include "collision_forge/trials/avoidability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "collision_forge/map/reference_path.h"
#include "collision_forge/verify/verification.h"

namespace forge {
namespace {

constexpr double kTimeEpsilon = 1e-6;  // s, the resolution of the clock

constexpr std::array<std::pair<EvasiveManoeuvre, const char*>, 5> kManoeuvreNames = {{
    {EvasiveManoeuvre::kKeeping, "keeping"},
    {EvasiveManoeuvre::kBraking, "braking"},
    {EvasiveManoeuvre::kAccelerating, "accelerating"},
    {EvasiveManoeuvre::kSteering, "steering"},
    {EvasiveManoeuvre::kBoth, "both"},
}};

/// What the ego is asked to do for a while: an acceleration, and a way beside its own.
struct Demand {
  double acceleration = 0.0;  ///< m/s2
  double offset = 0.0;        ///< m to the left of its way
};

/// The first demand for `duration` seconds, then the second.
struct Plan {
  Demand first;
  double duration = 0.0;
  Demand second;
};

EvasiveManoeuvre kindOf(const Plan& plan) {
  const bool steers = plan.first.offset != 0.0 || plan.second.offset != 0.0;
  const double change =
      plan.first.acceleration != 0.0 ? plan.first.acceleration : plan.second.acceleration;
  if (steers) return change == 0.0 ? EvasiveManoeuvre::kSteering : EvasiveManoeuvre::kBoth;
  if (change == 0.0) return EvasiveManoeuvre::kKeeping;
  return change < 0.0 ? EvasiveManoeuvre::kBraking : EvasiveManoeuvre::kAccelerating;
}

/// From 0 to 1, the same with every library.
double share(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11) * 0x1.0p-53;
}

double between(std::mt19937_64& generator, double low, double high) {
  return low + share(generator) * (high - low);
}

/// Every plan that is tried, the gentler ones first: the grid of the options, then draws.
std::vector<Plan> listPlans(const AvoidabilityOptions& options, const VehicleLimits& limits) {
  constexpr double kNarrowest = 1e-3;  // m, where nothing is steered to
  std::vector<Plan> plans;
  for (const double acceleration : options.accelerations) {
    for (const double offset : options.offsets) {
      for (const double duration : options.durations) {
        plans.push_back({{acceleration, offset}, duration, {0.0, offset}});
        if (acceleration == 0.0) break;  // the same for every duration
      }
    }
  }
  double widest = kNarrowest;
  for (const double offset : options.offsets) widest = std::max(widest, std::abs(offset));
  const double longest = *std::max_element(options.durations.begin(), options.durations.end());
  std::mt19937_64 generator(options.seed);
  const auto draw = [&] {
    const double acceleration =
        between(generator, -limits.max_braking, limits.max_forward_acceleration);
    return Demand{acceleration, between(generator, -widest, widest)};
  };
  for (int i = 0; i < options.draws; ++i) {
    const Demand first = draw();
    const double duration = between(generator, 0.0, longest);
    plans.push_back({first, duration, draw()});
  }
  const auto strength = [&](const Plan& plan) {
    const double effort = std::abs(plan.first.acceleration) + std::abs(plan.second.acceleration);
    return effort / limits.max_total_acceleration + std::abs(plan.first.offset) / widest;
  };
  std::stable_sort(plans.begin(), plans.end(),
                   [&](const Plan& a, const Plan& b) { return strength(a) < strength(b); });
  return plans;
}

/// A car that is driven along a path, middle of the box.
struct Car {
  Pose2 pose;
  double speed = 0.0;       ///< m/s
  double arc_length = 0.0;  ///< m along the path
  double offset = 0.0;      ///< m to the left of it
  double heading = 0.0;     ///< rad from the path's
};

/// Drives plans from one start.
class PlanDriver {
 public:
  PlanDriver(const ReferencePath& path, const AvoidabilityOptions& options,
             const AttackOptions& attack)
      : path_(path),
        options_(options),
        limits_(attack.verification.limits),
        total_(attack.search.limit_margin * limits_.max_total_acceleration) {}

  Car carAt(const Pose2& pose, double speed) const {
    const double arc_length = path_.project(pose.position());
    const Pose2 local = relativeTo(path_.at(arc_length).pose, pose);
    return {pose, speed, arc_length, local.y, local.yaw};
  }

  /// From `start` to `end`, a point every step and one at the end. The offsets asked for are from
  /// where the car is now: it need not be in the middle of its way.
  void drive(Car car, const Plan& plan, double start, double end,
             std::vector<TrajectoryPoint>& points) const {
    points.clear();
    const double own_offset = car.offset;
    for (double time = start;;) {
      const Demand& demand = time - start < plan.duration ? plan.first : plan.second;
      const double step = std::min(options_.step, end - time);
      const ReferencePath::Place place = path_.at(car.arc_length);
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
  double accelerationOf(const Demand& demand, const Car& car, double step) const {
    if (step <= kTimeEpsilon) return 0.0;
    const double wanted =
        std::clamp(demand.acceleration, -total_, limits_.max_forward_acceleration);
    return std::clamp(wanted, -car.speed / step, (limits_.max_speed - car.speed) / step);
  }

  /// Towards the offset without overshooting, as far as grip and steering allow.
  double curvatureOf(const Car& car, const ReferencePath::Place& place, double offset,
                     double acceleration, double step) const {
    const double distance =
        std::max(options_.min_return_distance, car.speed * options_.return_time);
    const double wanted = place.curvature - (car.offset - offset) / (distance * distance) -
                          2.0 * car.heading / distance;
    const double across = std::sqrt(std::max(total_ * total_ - acceleration * acceleration, 0.0));
    const double speed = std::max(car.speed, car.speed + acceleration * step);
    const double bound =
        std::min(limits_.max_curvature, across / std::max(speed * speed, kTimeEpsilon));
    return std::clamp(wanted, -bound, bound);
  }

  static void advance(Car& car, const ReferencePath::Place& place, double acceleration,
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

/// Where the others are at the instants of a motion from one start.
class Obstacles {
 public:
  Obstacles(const Future& others, double start, double end, double step) {
    add(others.ego, start, end, step);
    for (const Track& other : others.agents) add(other, start, end, step);
  }

  /// At the instants of the points, which are those of the constructor.
  bool areClearOf(const std::vector<TrajectoryPoint>& points, const BoxSize& size) const {
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

 private:
  struct Course {
    BoxSize size;
    double reach = 0.0;
    std::vector<std::optional<Pose2>> poses;
  };

  void add(const Track& other, double start, double end, double step) {
    Course course{other.size, circumradius(other.size), {}};
    for (double time = start;; time = std::min(time + step, end)) {
      const auto state = stateAt(other, time);
      course.poses.push_back(state ? std::optional<Pose2>(state->pose) : std::nullopt);
      if (time >= end - kTimeEpsilon) break;
    }
    courses_.push_back(std::move(course));
  }

  std::vector<Course> courses_;
};

/// The search in one scenario.
class Search {
 public:
  Search(const CrashScenario& scenario, const AvoidabilityOptions& options,
         const RouteOptions& route, const AttackOptions& attack)
      : scenario_(scenario),
        options_(options),
        attack_(attack),
        size_(scenario.ego.size),
        path_(Polyline(routeOf(scenario.recorded.ego, *scenario.lanes, route))),
        driver_(path_, options, attack),
        plans_(listPlans(options, attack.verification.limits)) {
    const OrientedBox now{scenario.recorded.ego.states.front().pose, size_};
    others_.ego = attackerTrack(scenario);
    for (const Track& agent : scenario.recorded.agents) {
      if (agent.id == scenario.attacker.attacker_id) continue;
      const auto state = stateAt(agent, scenario.snapshot.now);
      if (!state || !overlaps(now, boxAt(agent, state->pose))) others_.agents.push_back(agent);
    }
  }

  Avoidability run() {
    Avoidability found;
    const double now = scenario_.recorded.ego.states.front().time;
    if (auto kept = keep()) {
      found.from_now.push_back(*kept);
      found.last = std::move(kept);
      return found;
    }
    for (const EvasiveManoeuvre kind : {EvasiveManoeuvre::kBraking, EvasiveManoeuvre::kAccelerating,
                                        EvasiveManoeuvre::kSteering, EvasiveManoeuvre::kBoth}) {
      if (auto avoidance = searchFrom(now, kind)) found.from_now.push_back(std::move(*avoidance));
    }
    found.last = searchLatest(now);
    if (!found.last && !found.from_now.empty()) found.last = found.from_now.front();
    return found;
  }

 private:
  /// The recorded motion, if it touches nobody to the end, straight on from where it ends.
  std::optional<Avoidance> keep() {
    const Track& ego = scenario_.recorded.ego;
    Avoidance kept{EvasiveManoeuvre::kKeeping, ego.states.front().time, {}, 0.0};
    for (const AgentState& state : ego.states) {
      if (state.time > scenario_.end() + kTimeEpsilon) break;
      kept.motion.push_back({state.time, state.pose, speedOf(state), 0.0, 0.0});
    }
    const AgentState& last = ego.states.back();
    if (last.time < scenario_.end() - kTimeEpsilon) {
      const double rest = scenario_.end() - last.time;
      kept.motion.push_back({scenario_.end(), compose(last.pose, {speedOf(last) * rest, 0.0, 0.0}),
                             speedOf(last), 0.0, 0.0});
    }
    const CollisionReport report = verifyEgo(kept.motion);
    contact_time_ = report.contact ? report.contact_time : scenario_.end();
    if (!report.first_other_id.empty()) {
      contact_time_ = std::min(contact_time_, report.first_other_time);
    }
    if (report.contact || !report.first_other_id.empty()) return std::nullopt;
    kept.off_road_share = shareOff(kept.motion, report);
    return kept;
  }

  std::optional<Avoidance> searchLatest(double now) const {
    const int starts = static_cast<int>(std::floor((contact_time_ - now) / options_.interval));
    for (int i = starts; i >= 0; --i) {
      const double start = now + i * options_.interval;
      if (start >= contact_time_ - kTimeEpsilon) continue;
      if (auto avoidance = searchFrom(start, std::nullopt)) return avoidance;
    }
    return std::nullopt;
  }

  /// The gentlest witness, of one kind or any, that stays on the road; one off it otherwise.
  std::optional<Avoidance> searchFrom(double start, std::optional<EvasiveManoeuvre> kind) const {
    const auto state = stateAt(scenario_.recorded.ego, start);
    if (!state) return std::nullopt;
    const Car car = driver_.carAt(state->pose, speedOf(*state));
    const Obstacles obstacles(others_, start, scenario_.end(), options_.step);
    const bool starts_on_road = isOnRoad(state->pose);
    const BoxSize wide{size_.length + 2.0 * options_.margin, size_.width + 2.0 * options_.margin};
    std::optional<Avoidance> off_road;
    std::vector<TrajectoryPoint> points;
    for (const Plan& plan : plans_) {
      const EvasiveManoeuvre plan_kind = kindOf(plan);
      if (plan_kind == EvasiveManoeuvre::kKeeping || (kind && plan_kind != *kind)) continue;
      driver_.drive(car, plan, start, scenario_.end(), points);
      const bool leaves_road =
          starts_on_road && std::any_of(points.begin(), points.end(),
                                        [&](const auto& point) { return !isOnRoad(point.pose); });
      if (leaves_road && off_road) continue;
      if (!obstacles.areClearOf(points, wide)) continue;
      const CollisionReport report = verifyEgo(points);
      if (report.contact || !report.first_other_id.empty() || !report.limits_kept) continue;
      Avoidance avoidance{plan_kind, start, points, shareOff(points, report)};
      if (!leaves_road) return avoidance;
      off_road = std::move(avoidance);
    }
    return off_road;
  }

  static double speedOf(const AgentState& state) {
    return std::max(state.velocity.dot(state.pose.heading()), 0.0);
  }

  bool isOnRoad(const Pose2& pose) const {
    const AreaRaster& drivable = scenario_.lanes->drivable();
    if (drivable.empty()) return true;
    for (const Vector2& corner : corners({pose, size_})) {
      if (!drivable.contains(corner)) return false;
    }
    return true;
  }

  /// verifyDrive() with the ego in the attacker's place, by the strict limits: `contact` is that
  /// with the attacker.
  CollisionReport verifyEgo(const std::vector<TrajectoryPoint>& points) const {
    const AttackerTrajectory ego{kEgoId, AgentClass::kCar, size_, points};
    Snapshot snapshot;
    snapshot.now = points.front().time;
    CollisionRequest request;
    request.crash.limits = LimitSet::kStrict;  // those that the plans are driven by
    return verifyDrive(ego, {snapshot, others_, request, *scenario_.lanes}, attack_.verification);
  }

  double shareOff(const std::vector<TrajectoryPoint>& points, const CollisionReport& report) const {
    return offRoadShare({kEgoId, AgentClass::kCar, size_, points}, report, *scenario_.lanes,
                        attack_.verification);
  }

  const CrashScenario& scenario_;
  const AvoidabilityOptions& options_;
  const AttackOptions& attack_;
  BoxSize size_;
  ReferencePath path_;
  PlanDriver driver_;
  std::vector<Plan> plans_;
  Future others_;              // the attacker in the ego's place, for verifyEgo()
  double contact_time_ = 0.0;  // s, of the recorded ego with anybody; the end without
};

}  // namespace

const char* toString(EvasiveManoeuvre manoeuvre) {
  for (const auto& [value, name] : kManoeuvreNames) {
    if (value == manoeuvre) return name;
  }
  return "unknown";
}

std::optional<EvasiveManoeuvre> evasiveManoeuvreFromString(const std::string& name) {
  for (const auto& [value, text] : kManoeuvreNames) {
    if (name == text) return value;
  }
  return std::nullopt;
}

const Avoidance* Avoidability::find(EvasiveManoeuvre manoeuvre) const {
  const auto found = std::find_if(from_now.begin(), from_now.end(), [=](const Avoidance& entry) {
    return entry.manoeuvre == manoeuvre;
  });
  return found == from_now.end() ? nullptr : &*found;
}

Avoidability findAvoidability(const CrashScenario& scenario, const AvoidabilityOptions& options,
                              const RouteOptions& route, const AttackOptions& attack) {
  checkScenario(scenario);
  return Search(scenario, options, route, attack).run();
}

}  // namespace forge
