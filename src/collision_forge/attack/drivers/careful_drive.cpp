#include "collision_forge/attack/drivers/careful_drive.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/geometry/polyline.h"

namespace forge {
namespace {

constexpr double kTolerance = 1e-3;      // m, of contacts
constexpr double kStep = 0.05;           // s, as esmini's tests of these models
constexpr double kPredictionStep = 0.1;  // s
constexpr double kLeastSpacing = 0.2;    // m of the path's points: noise of a standing ego
constexpr double kExtension = 1.0;       // m that the path is continued
constexpr double kSpeedInterval = 0.1;   // s, for speeds along the path

/// The ego's path and its motion along it without reaction.
class EgoCourse {
 public:
  EgoCourse(const std::vector<AgentState>& states, double start) : path_(pathOf(states)) {
    double along = 0.0;
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (i > 0) along += (states[i].pose.position() - states[i - 1].pose.position()).norm();
      places_.push_back({states[i].time, along, states[i].pose});
    }
    const double before = alongAt(start);
    for (Place& place : places_) place.along -= before;
    path_start_ = path_.project(poseAt(0.0).position()).arc_length;
  }

  /// Returns the distance (m) travelled from the start until `time`; at the last speed after the
  /// last state.
  double alongAt(double time) const {
    const auto after =
        std::lower_bound(places_.begin(), places_.end(), time,
                         [](const Place& place, double value) { return place.time < value; });
    if (after == places_.begin()) return after->along;
    if (after == places_.end() && places_.size() == 1) return places_.front().along;
    const Place& to = after == places_.end() ? places_.back() : *after;
    const Place& from = *std::prev(after == places_.end() ? std::prev(after) : after);
    return from.along + (time - from.time) / (to.time - from.time) * (to.along - from.along);
  }

  double speedAt(double time) const {
    return std::max(alongAt(time + kSpeedInterval) - alongAt(time), 0.0) / kSpeedInterval;
  }

  double brakingAt(double time) const {
    return (speedAt(time) - speedAt(time + kSpeedInterval)) / kSpeedInterval;
  }

  Pose2 poseAt(double along) const {
    const auto after =
        std::upper_bound(places_.begin(), places_.end(), along,
                         [](double value, const Place& place) { return value < place.along; });
    if (after == places_.begin()) return after->pose;
    const Place& from = *std::prev(after);
    const double beyond = along - from.along;
    if (after == places_.end()) return compose(from.pose, {beyond, 0.0, 0.0});
    return interpolate(from.pose, after->pose, beyond / (after->along - from.along));
  }

  /// Returns the projection on the path; its arc length counts from the start.
  PolylineProjection project(const Vector2& point) const {
    PolylineProjection found = path_.project(point);
    if (found.arc_length >= path_.length()) {  // beyond the end the path is straight
      found.arc_length += (point - found.pose.position()).dot(found.pose.heading());
    }
    found.arc_length -= path_start_;
    return found;
  }

 private:
  struct Place {
    double time = 0.0;
    double along = 0.0;
    Pose2 pose;
  };

  static Polyline pathOf(const std::vector<AgentState>& states) {
    std::vector<Vector2> points = {states.front().pose.position()};
    for (const AgentState& state : states) {
      const Vector2 point = state.pose.position();
      if ((point - points.back()).norm() >= kLeastSpacing) points.push_back(point);
    }
    points.push_back(points.back() + kExtension * states.back().pose.heading());
    return Polyline(points);
  }

  std::vector<Place> places_;
  Polyline path_;
  double path_start_ = 0.0;
};

/// Half the extents of a box along and across a direction.
Vector2 halfExtent(const BoxSize& size, double angle) {
  const double cosine = std::abs(std::cos(angle));
  const double sine = std::abs(std::sin(angle));
  return 0.5 * Vector2(cosine * size.length + sine * size.width,
                       sine * size.length + cosine * size.width);
}

/// Observes the attacker as the ego drives.
class AttackerView {
 public:
  AttackerView(const EgoCourse& course, const BoxSize& ego, const AttackerTrajectory& attacker,
               const DriverOptions& options)
      : course_(course),
        ego_(ego),
        track_{attacker.attacker_id, attacker.agent_class, attacker.size,
               toStates(attacker.points)},
        options_(options) {}

  const Track& track() const { return track_; }

  std::optional<Approach> at(double time, double along, double speed) {
    const auto state = stateAt(track_, time);
    if (!state) return std::nullopt;
    const PolylineProjection place = course_.project(state->pose.position());
    const double angle = angleBetween(place.pose.yaw, state->pose.yaw);
    const Vector2 half = halfExtent(track_.size, angle);
    const Vector2 ahead = place.pose.heading();
    const double side = place.lateral < 0.0 ? -1.0 : 1.0;
    Approach approach;
    approach.gap = std::abs(place.arc_length - along) - 0.5 * ego_.length - half.x();
    approach.lengths = ego_.length + 2.0 * half.x();
    approach.is_ahead = place.arc_length > along;
    approach.lateral_gap = std::abs(place.lateral) - 0.5 * ego_.width - half.y();
    approach.lateral_speed =
        -side * (ahead.x() * state->velocity.y() - ahead.y() * state->velocity.x());
    farthest_ = std::max(farthest_, std::abs(place.lateral));
    approach.deviation = farthest_ - std::abs(place.lateral);
    approach.speed = state->velocity.dot(ahead);
    if (last_speed_) approach.braking = (*last_speed_ - approach.speed) / kStep;
    last_speed_ = approach.speed;
    approach.is_same_direction =
        !isOnFoot(track_.agent_class) && std::abs(angle) <= options_.same_direction;
    approach.is_conflict = !approach.is_same_direction && meets(*state, along, speed);
    return approach;
  }

 private:
  /// Returns whether ego and attacker touch within the horizon if both keep their velocities.
  bool meets(const AgentState& state, double along, double speed) const {
    for (double ahead = 0.0; ahead <= options_.conflict_horizon; ahead += kPredictionStep) {
      const Vector2 moved = state.pose.position() + ahead * state.velocity;
      const OrientedBox other{{moved.x(), moved.y(), state.pose.yaw}, track_.size};
      if (overlaps({course_.poseAt(along + ahead * speed), ego_}, other)) return true;
    }
    return false;
  }

  const EgoCourse& course_;
  BoxSize ego_;
  Track track_;
  const DriverOptions& options_;
  double farthest_ = 0.0;             // m from the path, so far
  std::optional<double> last_speed_;  // m/s along the path
};

/// Returns whether a vehicle touches the ego with no fault of the ego: at its rear.
bool touchesRear(const Track& ego, const Track& other, double time) {
  const auto ego_state = stateAt(ego, time);
  const auto state = stateAt(other, time);
  return ego_state && state &&
         touchedSide(boxAt(ego, ego_state->pose), boxAt(other, state->pose)) == Side::kRear;
}

bool hasContact(const AttackerTrajectory& drive, const AttackerView& view, const Future& future) {
  const double start = drive.points.front().time;
  const double end = drive.points.back().time;
  if (firstContactTime(drive, view.track(), end, kTolerance)) return true;
  const Track ego{kEgoId, AgentClass::kCar, drive.size, toStates(drive.points)};
  return std::any_of(future.agents.begin(), future.agents.end(), [&](const Track& agent) {
    if (agent.id == view.track().id) return false;
    const auto contact = firstContactTime(drive, agent, end, kTolerance);
    return contact && *contact > start && !touchesRear(ego, agent, *contact);
  });
}

CarefulDrive driveAs(DriverModel model, const EgoCourse& course, const Future& future,
                     const AttackerTrajectory& attacker, const DriverOptions& options) {
  CarefulDriver driver(model, options);
  AttackerView view(course, future.ego.size, attacker, options);
  CarefulDrive result;
  result.driver = toString(model);
  AttackerTrajectory drive{kEgoId, AgentClass::kCar, future.ego.size, {}};
  const double start = attacker.points.front().time;
  const double end = attacker.points.back().time;
  double along = 0.0;
  double speed = course.speedAt(start);
  bool has_reacted = false;
  for (int i = 0;; ++i) {
    const double time = std::min(start + i * kStep, end);
    drive.points.push_back({time, course.poseAt(along), speed, 0.0, 0.0});
    if (time >= end) break;
    const double step = std::min(kStep, end - time);
    const auto deceleration = driver.decelerate(view.at(time, along, speed), speed, kStep);
    if (driver.isBraking() && !result.brakes_at) result.brakes_at = time;
    has_reacted = has_reacted || deceleration;
    if (has_reacted) {
      const double braking = std::max(*deceleration, course.brakingAt(time));
      const double next = std::max(speed - braking * step, 0.0);
      along += 0.5 * (speed + next) * step;
      speed = next;
    } else {
      along = course.alongAt(time + step);
      speed = course.speedAt(time + step);
    }
  }
  result.avoids = !hasContact(drive, view, future);
  return result;
}

}  // namespace

std::vector<CarefulDrive> driveCarefully(const Future& future, const AttackerTrajectory& attacker,
                                         const DriverOptions& options) {
  const EgoCourse course(future.ego.states, attacker.points.front().time);
  std::vector<CarefulDrive> drives;
  for (const DriverModel model : kDriverModels) {
    drives.push_back(driveAs(model, course, future, attacker, options));
  }
  return drives;
}

bool isAvoidedBy(const std::vector<CarefulDrive>& drives, DriverModel model) {
  return std::any_of(drives.begin(), drives.end(), [&](const CarefulDrive& drive) {
    return drive.avoids && drive.driver == toString(model);
  });
}

std::string avoiders(const std::vector<CarefulDrive>& drives, const char* separator) {
  std::string names;
  for (const CarefulDrive& drive : drives) {
    if (drive.avoids) names += (names.empty() ? "" : separator) + drive.driver;
  }
  return names;
}

}  // namespace forge
