#include "collision_forge/attack/search/route_driver.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include <boost/math/tools/toms748_solve.hpp>

#include "collision_forge/attack/search/quintic.h"

namespace forge {
namespace {

constexpr double kSettling = 1.0;         // s in which the driver reaches a chosen speed
constexpr double kReturnDistance = 80.0;  // m in which the offset from the lane's middle fades to
                                          // 74 %, critically damped
constexpr double kSpacing = ReferencePath::kBendSpacing;
constexpr double kSpeedPrecision = 0.01;    // m/s, of the chosen speed
constexpr std::uintmax_t kMostTrials = 20;  // to find it
constexpr double kLookahead = 0.4;          // s of anticipation of bends
constexpr double kWandering = 2.0;          // m/s; slower vehicles vary less
constexpr double kStandstill = 0.05;        // m/s; below, no lateral motion

}  // namespace

/// Parameters of a drive along the route.
struct RouteDriver::Cruise {
  std::size_t style;
  double speed;  // m/s, chosen speed
  double arrival;
  double late_from;  // s
  double late_acceleration;
  double step;
  double wait;  // s
};

RouteDriver::RouteDriver(ReferencePath path, const DriveState& now, const DriveLimits& limits,
                         const SpeedVariation& variation)
    : path_(std::move(path)), limits_(limits), now_(now), variation_(variation) {
  start_ = path_.frenetOf(compose(now.axle, {limits.axle_to_middle, 0.0, 0.0}));
  const std::vector<double> bends = path_.curvatures();
  for (const DrivingStyle& style : kDrivingStyles) {
    std::vector<float> caps(bends.size());
    const double lateral = std::min(style.lateral, kLimitShare * limits.max_lateral_acceleration);
    const double braking = std::min(style.braking, kLimitShare * limits.max_braking);
    double next = limits.max_speed * limits.max_speed;
    for (std::size_t i = bends.size(); i-- > 0;) {
      next = std::min(next + 2.0 * braking * kSpacing, lateral / bends[i]);
      caps[i] = static_cast<float>(std::sqrt(next));
    }
    caps_.push_back(std::move(caps));
  }
}

double RouteDriver::keptOffset(double along) const {
  // Critically damped, from where and how the driver leans now.
  const double driven = std::max(0.0, along - start_.along);
  const double fade = kReturnDistance;
  const double slope = std::tan(std::clamp(start_.lean, -kMaxLean, kMaxLean));
  return (start_.across + (slope + start_.across / fade) * driven) * std::exp(-driven / fade);
}

double RouteDriver::cap(std::size_t style, double along) const {
  const std::vector<float>& caps = caps_[style];
  const double place = std::clamp(along / kSpacing, 0.0, static_cast<double>(caps.size() - 1));
  return caps[static_cast<std::size_t>(place)];
}

/// Returns m along the path at the arrival; appends the position at every step to `alongs`, if not
/// null.
double RouteDriver::drive(const Cruise& cruise, std::vector<double>* alongs) const {
  const DrivingStyle& style = kDrivingStyles[cruise.style];
  const DrivingStyle& wildest = kDrivingStyles.back();
  const double share = kLimitShare;
  const double wave_jerk = variation_.amplitude * variation_.frequency();
  double along = start_.along;
  double speed = now_.speed;
  double acceleration = now_.acceleration;
  // The variation's wave, rotated step by step.
  const double turn = variation_.frequency() * cruise.step;
  const Vector2 turned{std::cos(turn), std::sin(turn)};
  Vector2 wave =
      variation_.amplitude * Vector2{std::cos(variation_.phase), std::sin(variation_.phase)};
  for (double time = 0.0; time < cruise.arrival - 1e-9; time += cruise.step) {
    if (alongs) alongs->push_back(along);
    const double duration = std::min(cruise.step, cruise.arrival - time);
    const double wander = wave.y() * std::clamp(speed / kWandering, 0.0, 1.0);
    wave = {wave.x() * turned.x() - wave.y() * turned.y(),
            wave.x() * turned.y() + wave.y() * turned.x()};
    if (time < cruise.wait && speed == 0.0) continue;
    const double target = std::min(cruise.speed, cap(cruise.style, along + kLookahead * speed));
    double wanted =
        std::clamp((target - speed) / kSettling, -style.braking, style.forward) + wander;
    double jerk = style.jerk + wave_jerk;
    if (time >= cruise.late_from) {
      wanted = cruise.late_acceleration;
      jerk = wildest.jerk;
    } else if (target < cruise.speed) {
      jerk = std::max(jerk, 2.0 * style.jerk);
    }
    wanted = std::clamp(wanted, -share * limits_.max_braking, share * limits_.forwardAt(speed));
    const double change = std::min(jerk, share * limits_.max_jerk) * duration;
    acceleration = std::clamp(wanted, acceleration - change, acceleration + change);
    const double next = std::clamp(speed + acceleration * duration, 0.0, share * limits_.max_speed);
    along += 0.5 * (speed + next) * duration;
    if (next == 0.0) acceleration = 0.0;
    speed = next;
  }
  return along;
}

RouteDriver::Cruise RouteDriver::cruiseOf(const RoutePlan& wanted, const RouteSpeed& speed,
                                          double step) const {
  const double late_from = wanted.late > 0.0 ? wanted.arrival - wanted.late : wanted.arrival + step;
  return {speed.style, speed.speed, wanted.arrival, late_from, wanted.late_acceleration,
          step,        wanted.wait};
}

std::optional<RouteSpeed> RouteDriver::speedFor(const RoutePlan& wanted, double step,
                                                RouteReach& reach) const {
  RouteSpeed found;
  reach.styles.resize(kDrivingStyles.size());
  const auto beyond = [&](double speed) {
    const auto [known, is_new] = reach.styles[found.style].try_emplace(speed, 0.0);
    if (is_new) known->second = drive(cruiseOf(wanted, {found.style, speed}, step), nullptr);
    return known->second - wanted.at.along;
  };
  const double high = kLimitShare * limits_.max_speed;
  const auto isNear = [](double a, double b) { return std::abs(a - b) < kSpeedPrecision; };
  for (; found.style < kDrivingStyles.size(); ++found.style) {
    const double slowest = beyond(0.0);
    if (slowest > kArrivalPrecision) continue;
    const double fastest = beyond(high);
    if (fastest < -kArrivalPrecision) continue;
    if (slowest >= 0.0) return RouteSpeed{found.style, 0.0};
    if (fastest <= 0.0) return RouteSpeed{found.style, high};
    // The faster, the farther: the known speeds on both sides of the wanted place are the bracket.
    const std::map<double, double>& known = reach.styles[found.style];
    const auto above = std::find_if(known.begin(), known.end(), [&](const auto& speed) {
      return speed.second >= wanted.at.along;
    });
    const auto below = std::prev(above);
    const double low_speed = below->first, high_speed = above->first;
    if (isNear(low_speed, high_speed))
      return RouteSpeed{found.style, 0.5 * (low_speed + high_speed)};
    std::uintmax_t most = kMostTrials;
    const auto [slower, faster] = boost::math::tools::toms748_solve(
        beyond, low_speed, high_speed, below->second - wanted.at.along,
        above->second - wanted.at.along, isNear, most);
    return RouteSpeed{found.style, 0.5 * (slower + faster)};
  }
  return std::nullopt;
}

RouteCourse RouteDriver::courseAt(const RoutePlan& wanted, const RouteSpeed& speed,
                                  double step) const {
  RouteCourse course;
  course.end = drive(cruiseOf(wanted, speed, step), &course.alongs);
  course.places.reserve(course.alongs.size());
  for (const double along : course.alongs) course.places.push_back(path_.at(along));
  return course;
}

void RouteDriver::plan(const RoutePlan& wanted, const RouteCourse& course, double step,
                       std::size_t steps, std::vector<PlannedStep>& planned) const {
  const std::vector<double>& alongs = course.alongs;
  const double end = course.end;
  const double before = wanted.arrival - static_cast<double>(alongs.size() - 1) * step;
  const double last_speed = std::max(0.0, (end - alongs.back()) / std::max(1e-6, before));
  // Across the path: the kept offset, then a quintic to the arrival.
  const double waits = now_.speed > 0.0 ? 0.0 : std::min(wanted.wait, wanted.arrival - step);
  // At least one step, and not before t0, even if the arrival is less than a step away.
  const double departure = std::min(std::max(wanted.departure, step), wanted.arrival - waits);
  const double from = wanted.arrival - departure;
  const double moving = std::max(step, departure - wanted.lead);
  const auto from_step = std::min(static_cast<std::size_t>(from / step), alongs.size() - 1);
  const double kept = keptOffset(alongs[from_step]);
  const double drift = last_speed * std::tan(wanted.at.lean);
  // A departure at once continues the present heading.
  const double leaning = from < step ? now_.speed * std::sin(start_.lean) : 0.0;
  const Quintic across({kept, leaning, 0.0}, {wanted.at.across - wanted.lead * drift, drift, 0.0},
                       moving);
  planned.resize(steps);
  PlannedStep arrived;
  for (std::size_t i = 0; i < steps; ++i) {
    const double time = static_cast<double>(i) * step;
    PlannedStep& at = planned[i];
    if (i >= alongs.size()) {
      if (i == alongs.size()) {
        const Pose2 place = path_.at(end).pose;
        arrived = {compose(place, {0.0, wanted.at.across, wanted.at.lean}), last_speed};
      }
      at = arrived;
      at.middle += (time - wanted.arrival) * last_speed * arrived.heading;
      continue;
    }
    const double next = i + 1 < alongs.size() ? alongs[i + 1] : end;
    const double duration = i + 1 < alongs.size() ? step : std::max(1e-6, before);
    const double before_along = i > 0 ? alongs[i - 1] : alongs[i];
    const double speed = i > 0 ? (next - before_along) / (step + duration) : now_.speed;
    const ReferencePath::PathPoint& place = course.places[i];
    double offset = kept;
    double rate = 0.0;
    if (time < from) {
      offset = keptOffset(alongs[i]);
    } else {
      const AxisState state = across.at(std::min(moving, time - from));
      offset = state.position + std::max(0.0, time - from - moving) * drift;
      rate = state.velocity;
    }
    const double stretch = std::max(0.1, 1.0 - place.curvature * offset);
    const Vector2& along = place.heading;
    const Vector2 across_path{-along.y(), along.x()};
    const Vector2 velocity = speed * stretch * along + rate * across_path;
    at.middle = place.pose.position() + offset * across_path;
    at.speed = velocity.norm();
    at.heading = speed > kStandstill ? Vector2(velocity / at.speed) : along;
  }
}

}  // namespace forge
