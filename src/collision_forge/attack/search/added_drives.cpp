#include "collision_forge/attack/search/added_drives.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "collision_forge/attack/search/placement.h"
#include "collision_forge/attack/search/request_constraints.h"
#include "collision_forge/attack/search/route_driver.h"

namespace forge {
namespace {

// m/s2; accelerations from t0 on of a vehicle that drove like the ego until t0.
constexpr double kClosings[] = {0.6, 0.0, -0.6, 1.2, -1.2, -2.0};
constexpr double kStarts[] = {1.2, 0.8, 1.8};  // m/s2; accelerations of a vehicle that stands at t0
constexpr double kParked[] = {3.0, 5.0};       // m before the contact at which a vehicle is parked
constexpr double kLeastGap = 1.5;              // m to the ego until t0, in the ego's lane
constexpr double kRidingGap = 0.5;  // m from the ego's side to a motorcycle in its lane until t0
// m; left offset from the middle of its lane of a vehicle that crosses the centre line, tried if no
// vehicle in the middle of its lane can.
constexpr double kAside = 0.7;
// m/s of cyclists, who do not ride at the speed of the traffic: recorded median and 90 %.
constexpr double kCyclingSpeeds[] = {4.2, 5.5, 3.3};
constexpr double kLeastCrossingSpeed = 4.5;  // m/s; slower vehicles do not get across in time
constexpr double kStep = AddedDrive::kStep;
constexpr double kGettingGoing = 0.4;  // s in which a starting vehicle builds up its acceleration
constexpr double kOwnLane = 1.5;       // m; an ego closer to the path's middle is on the path
constexpr double kHeadway = 1.2;       // s between two vehicles on the same path

std::vector<ApproachManner> followsOf(const AddedMeeting& meeting) {
  std::vector<ApproachManner> follows;
  for (std::size_t i = 0; i < meeting.way->flows.size(); ++i) {
    follows.push_back({ApproachManner::kFollow, static_cast<double>(i)});
  }
  return follows;
}

std::vector<ApproachManner> joined(std::initializer_list<std::vector<ApproachManner>> lists) {
  std::vector<ApproachManner> all;
  for (const std::vector<ApproachManner>& list : lists)
    all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// Continues after t0 with constant acceleration; returns false if that would reverse.
bool extrapolate(const AddedMeeting& meeting, double along, double speed, double acceleration,
                 AddedDrive& drive) {
  if (speed + acceleration * meeting.contact < 0.0) return false;
  for (std::size_t i = 0; i < drive.on.size(); ++i) {
    const double time = drive.step() * static_cast<double>(i + 1);
    drive.on[i] = along + speed * time + 0.5 * acceleration * time * time;
  }
  return true;
}

/// Returns the offset from the path's middle that is `gap` m farther from the ego than at the
/// meeting.
double besideEgo(const AddedMeeting& meeting, const PathPose& place, double gap) {
  const double outward = place.across - meeting.way->path.frenetOf(meeting.ego.center).across;
  return place.across + std::copysign(gap, outward);
}

}  // namespace

bool AddedMeeting::isEgosPath() const {
  const Pose2 place = way->path.at(way->path.project(ego.center.position())).pose;
  return std::abs(relativeTo(place, ego.center).y) < kOwnLane;
}

Pose2 AddedMeeting::offsetOf(const BoxSize& attacker) const {
  return attackerOffset(ego.size, attacker, side, heading, contact_position, 0.0);
}

PathPose AddedMeeting::frenetOf(const BoxSize& attacker) const {
  return way->path.frenetOf(compose(ego.center, offsetOf(attacker)));
}

double AddedDrive::at(int steps) const {
  if (steps <= 0) return back[std::min(static_cast<std::size_t>(-steps), back.size() - 1)];
  const double last = static_cast<double>(on.size() - 1);
  const double place = std::clamp(steps * kStep / step() - 1.0, 0.0, last);
  const auto before = static_cast<std::size_t>(place);
  const auto after = std::min(before + 1, on.size() - 1);
  return on[before] + (place - static_cast<double>(before)) * (on[after] - on[before]);
}

Pose2 AddedDrive::poseAt(const ReferencePath& path, int steps) const {
  return compose(path.at(at(steps)).pose, {0.0, aside, 0.0});
}

AddedDrives::AddedDrives(const AddedVehicleInput& input, const AttackOptions& options)
    : input_(input), added_(options.added), past_(input.known()), steps_back_(stepsBack(past_)) {}

std::vector<ApproachManner> AddedDrives::mannersFor(const AddedMeeting& meeting) const {
  if (input_.request.departure_time) return mannersFromStandstill(meeting);
  switch (input_.request.type) {
    case CollisionType::kRearEnd:
      return mannersInLane(meeting);
    case CollisionType::kLaneChange:
    case CollisionType::kSideswipeSameDirection:
      return mannersBeside(meeting);
    case CollisionType::kOppositeDirection:
      return mannersOncoming(meeting);
    case CollisionType::kAngleSameDirection:
      return joined({mannersCrossing(meeting), trainsOf(meeting)});
    case CollisionType::kAngleOppositeDirection:
      return joined({mannersCrossing(meeting), mannersOncoming(meeting)});
    case CollisionType::kJunctionCrossing:
    case CollisionType::kLtap:
    case CollisionType::kAny:
      break;
  }
  return mannersCrossing(meeting);
}

/// Returns the manners of a vehicle that stands at t0 and departs at the requested time.
std::vector<ApproachManner> AddedDrives::mannersFromStandstill(const AddedMeeting& meeting) const {
  const CollisionType type = input_.request.type;
  const bool is_beside =
      type == CollisionType::kLaneChange || type == CollisionType::kSideswipeSameDirection;
  const std::optional<Manoeuvre>& asked = input_.request.manoeuvre;
  const bool pulls_out = asked == Manoeuvre::kPullOut;
  std::vector<ApproachManner> manners;
  for (const double departure : valuesTriedIn(*input_.request.departure_time)) {
    const double moving = meeting.contact - departure - kGettingGoing;
    if (moving <= 0.0) continue;
    for (const double start : kStarts) {
      if (is_beside && (pulls_out || !asked)) {
        manners.push_back({ApproachManner::kPark, 0.5 * start * moving * moving});
      }
      if (pulls_out) continue;
      for (const bool waits : {false, true}) {
        manners.push_back({ApproachManner::kStart, start, waits, 0.0, false, departure});
      }
    }
  }
  return manners;
}

std::vector<ApproachManner> AddedDrives::mannersInLane(const AddedMeeting& meeting) const {
  std::vector<ApproachManner> trains = trainsOf(meeting);
  std::vector<ApproachManner> cruises;
  std::vector<double> speeds = speedsOf(meeting);
  if (!input_.isFutureKnown()) {
    // The greater the closing speed, the less the uncertainty of the ego's position matters.
    const double own = past_.ego.states.back().velocity.norm();
    std::sort(speeds.begin(), speeds.end(),
              [&](double a, double b) { return std::abs(a - own) > std::abs(b - own); });
  }
  for (const double speed : speeds) cruises.push_back({ApproachManner::kCruise, speed});
  std::vector<ApproachManner> stands;
  if (meeting.side == Side::kFront) stands.push_back({ApproachManner::kStand});
  const bool stands_first =
      !input_.isFutureKnown() || input_.request.manoeuvre == Manoeuvre::kLeadStopped;
  return stands_first ? joined({stands, cruises, trains}) : joined({trains, cruises, stands});
}

std::vector<ApproachManner> AddedDrives::mannersBeside(const AddedMeeting& meeting) const {
  std::vector<ApproachManner> parks;
  for (const double before : kParked) parks.push_back({ApproachManner::kPark, before});
  std::vector<ApproachManner> cruises;
  for (const double speed : speedsOf(meeting)) cruises.push_back({ApproachManner::kCruise, speed});
  const std::optional<Manoeuvre>& asked = input_.request.manoeuvre;
  if (asked == Manoeuvre::kPullOut) return parks;
  if (asked) parks.clear();
  std::vector<ApproachManner> drives = joined({trainsOf(meeting), cruises});
  if (!meeting.isEgosPath()) return joined({drives, parks});
  const AddedPath& way = *meeting.way;
  const bool is_ego_there = !way.ego.empty() && std::abs(way.ego_across) < kOwnLane;
  // Another lane leads into the ego's.
  if (!is_ego_there) return joined({parks, drives});
  // Only a motorcycle fits beside the ego in its lane.
  for (ApproachManner& manner : drives) manner.is_motorcycle_beside = true;
  return joined({parks, drives});
}

std::vector<ApproachManner> AddedDrives::mannersOncoming(const AddedMeeting& meeting) const {
  std::vector<ApproachManner> manners;
  // A slow vehicle cannot cross the centre line in time.
  for (const double speed : speedsOf(meeting)) {
    if (speed >= kLeastCrossingSpeed || isCycling())
      manners.push_back({ApproachManner::kCruise, speed});
  }
  manners = joined({manners, followsOf(meeting)});
  for (const double start : kStarts) manners.push_back({ApproachManner::kStart, start, false});
  std::vector<ApproachManner> nearer = manners;
  for (ApproachManner& manner : nearer) manner.aside = std::copysign(kAside, meeting.across);
  return joined({manners, nearer});
}

std::vector<ApproachManner> AddedDrives::mannersCrossing(const AddedMeeting& meeting) const {
  const std::vector<double> speeds = speedsOf(meeting);
  std::vector<ApproachManner> manners;
  for (std::size_t i = 0; i < std::max(speeds.size(), std::size(kStarts)); ++i) {
    if (i < speeds.size()) manners.push_back({ApproachManner::kCruise, speeds[i]});
    if (i >= std::size(kStarts)) continue;
    manners.push_back({ApproachManner::kStart, kStarts[i], false});
    manners.push_back({ApproachManner::kStart, kStarts[i], true});
  }
  const std::vector<ApproachManner> follows = followsOf(meeting);
  manners.insert(manners.begin() + std::min<std::ptrdiff_t>(2, manners.size()), follows.begin(),
                 follows.end());
  return manners;
}

/// Returns true if the request asks for a bicycle or a scooter.
bool AddedDrives::isCycling() const {
  const std::optional<AgentClass>& asked = input_.request.attacker_class;
  return asked && isCycle(*asked);
}

/// Returns speeds in the requested range and the speeds of recorded vehicles on the path, of the
/// ego and of the configuration.
std::vector<double> AddedDrives::speedsOf(const AddedMeeting& meeting) const {
  std::vector<double> speeds;
  if (const std::optional<Range>& asked = input_.request.attacker_speed) {
    for (const double speed : valuesTriedIn(*asked)) addSpeed(speed, speeds);
  }
  if (isCycling()) {
    for (const double speed : kCyclingSpeeds) addSpeed(speed, speeds);
    return speeds;
  }
  speeds.insert(speeds.end(), meeting.way->speeds.begin(), meeting.way->speeds.end());
  const double own = past_.ego.states.back().velocity.norm();
  if (own > AddedPath::kMoving) addSpeed(own, speeds);
  for (const double speed : added_.speeds) addSpeed(speed, speeds);
  return speeds;
}

std::vector<ApproachManner> AddedDrives::trainsOf(const AddedMeeting& meeting) const {
  std::vector<ApproachManner> trains;
  for (const double closing : closingsFor(meeting)) {
    trains.push_back({ApproachManner::kTrain, closing});
  }
  return joined({trains, followsOf(meeting)});
}

/// Returns accelerations after t0 of a vehicle that drove as the ego did so far: kClosings, after
/// those that start at the requested gap or headway.
std::vector<double> AddedDrives::closingsFor(const AddedMeeting& meeting) const {
  std::vector<double> closings;
  const AddedPath& way = *meeting.way;
  constexpr std::size_t kSpan = 5;
  const std::optional<Range>& asked =
      input_.request.gap ? input_.request.gap : input_.request.headway;
  if (asked && way.ego.size() > kSpan) {
    const double speed = std::max(0.0, (way.ego[0] - way.ego[kSpan]) / (kSpan * kStep));
    const AddedKind& car = added_.kinds.front();
    const double lengths = 0.5 * (past_.ego.size.length + car.length);
    const double along = meeting.frenetOf({car.length, car.width}).along;
    const double ahead = along > way.path.project(meeting.ego.center.position()) ? 1.0 : -1.0;
    for (double gap : valuesTriedIn(*asked)) {
      if (!input_.request.gap) gap *= speed;
      const double start = way.ego[0] + ahead * (gap + lengths);
      closings.push_back(2.0 * (along - start - speed * meeting.contact) /
                         (meeting.contact * meeting.contact));
    }
  }
  closings.insert(closings.end(), std::begin(kClosings), std::end(kClosings));
  return closings;
}

bool AddedDrives::plan(const AddedMeeting& meeting, const ApproachManner& manner,
                       const BoxSize& size, AddedDrive& drive,
                       const SpeedVariation& variation) const {
  const PathPose place = meeting.frenetOf(size);
  const double along = place.along;
  drive.aside = manner.aside;
  if (manner.is_motorcycle_beside) drive.aside = besideEgo(meeting, place, kRidingGap);
  drive.back.clear();
  drive.contact = meeting.contact;
  drive.on.assign(static_cast<std::size_t>(std::ceil(meeting.contact / kStep)), 0.0);
  switch (manner.kind) {
    case ApproachManner::kCruise:
      if (!cruise(meeting, along, manner.value, drive)) return false;
      vary(variation, drive);
      return true;
    case ApproachManner::kTrain:
      return train(meeting, along, size, manner.value, drive);
    case ApproachManner::kFollow:
      return followFlow(meeting, along, meeting.way->flows[static_cast<std::size_t>(manner.value)],
                        drive);
    case ApproachManner::kStart:
      return start(meeting, along, manner, drive);
    case ApproachManner::kStand:
      drive.back.assign(steps_back_ + 1, along);
      return extrapolate(meeting, along, 0.0, 0.0, drive);
    case ApproachManner::kPark:
      return park(meeting, place, manner.value, drive);
  }
  return false;
}

/// Extends the motion backwards at `speed` or what bends allow, until the first frame or the start
/// of the path.
void AddedDrives::cruiseBack(const AddedPath& way, double speed, double now,
                             std::vector<double>& back) const {
  const double change = AddedPath::kBraking * kStep;
  while (back.size() <= steps_back_ && back.back() >= 0.0) {
    const double wanted = std::min(speed, way.cap(back.back()));
    const double before = std::clamp(wanted, now - change, now + change);
    back.push_back(back.back() - 0.5 * (now + before) * kStep);
    now = before;
  }
}

bool AddedDrives::cruise(const AddedMeeting& meeting, double along, double speed,
                         AddedDrive& drive) const {
  double now = 0.0;
  for (std::size_t i = drive.on.size(); i-- > 0;) {
    drive.on[i] = along;
    now = std::min(speed, meeting.way->cap(along));
    along -= now * drive.step();
  }
  drive.back = {along};
  cruiseBack(*meeting.way, speed, now, drive.back);
  return true;
}

/// Adds the speed variation without moving the contact and without reversing.
void AddedDrives::vary(const SpeedVariation& variation, AddedDrive& drive) {
  const double end = variation.distanceGained(drive.contact);
  double next = drive.on.back();
  const auto shift = [&](double& along, double time) {
    next = along = std::min(next, along + variation.distanceGained(time) - end);
  };
  for (std::size_t i = drive.on.size(); i-- > 0;) {
    shift(drive.on[i], drive.step() * static_cast<double>(i + 1));
  }
  for (std::size_t i = 0; i < drive.back.size(); ++i) {
    shift(drive.back[i], -kStep * static_cast<double>(i));
  }
}

/// Repeats the ego's motion so far, at a distance from which acceleration `closing` leads to the
/// contact.
bool AddedDrives::train(const AddedMeeting& meeting, double along, const BoxSize& size,
                        double closing, AddedDrive& drive) const {
  const AddedPath& way = *meeting.way;
  const std::size_t count = way.ego.size();
  constexpr std::size_t kSpan = 5;
  if (count <= kSpan) return false;
  const double speed = std::max(0.0, (way.ego[0] - way.ego[kSpan]) / (kSpan * kStep));
  const double contact = meeting.contact;
  const double start = along - speed * contact - 0.5 * closing * contact * contact;
  const double gap = start - way.ego[0];
  const double least = 0.5 * (past_.ego.size.length + size.length) + kLeastGap;
  const double passing = 0.5 * (past_.ego.size.width + size.width);
  if (std::abs(way.ego_across - drive.aside) < passing && std::abs(gap) < least) return false;
  if (!extrapolate(meeting, start, speed, closing, drive)) return false;
  for (const double ego : way.ego) {
    drive.back.push_back(ego + gap);
    if (drive.back.back() < 0.0) return true;
  }
  const double first =
      std::max(0.0, (way.ego[count - 1 - kSpan] - way.ego[count - 1]) / (kSpan * kStep));
  cruiseBack(way, std::max(first, AddedPath::kMoving), first, drive.back);
  return true;
}

/// Repeats a recorded vehicle's motion, shifted in time so that it reaches the meeting.
bool AddedDrives::followFlow(const AddedMeeting& meeting, double along, const AddedFlow& flow,
                             AddedDrive& drive) const {
  const auto passing = flow.passing(along);
  if (!passing) return false;
  const double later = meeting.contact - *passing;
  if (std::abs(later) < kHeadway || !flow.covers(-later)) return false;
  for (std::size_t i = 0; i < drive.on.size(); ++i) {
    drive.on[i] = flow.at(drive.step() * static_cast<double>(i + 1) - later);
  }
  double ago = 0.0;
  for (; drive.back.size() <= steps_back_ && flow.covers(-ago - later); ago += kStep) {
    drive.back.push_back(flow.at(-ago - later));
  }
  const double first = flow.times.front();
  const double speed = (flow.at(first + 1.0) - flow.at(first)) / 1.0;
  cruiseBack(*meeting.way, std::max(speed, AddedPath::kMoving), speed, drive.back);
  return true;
}

bool AddedDrives::start(const AddedMeeting& meeting, double along, const ApproachManner& manner,
                        AddedDrive& drive) const {
  const double since = meeting.contact - manner.departure;
  const double moving = std::max(0.0, since - kGettingGoing);
  const double place = along - 0.5 * manner.value * moving * moving;
  const double mean = 2.0 * (along - place) / (since * since);
  for (std::size_t i = 0; i < drive.on.size(); ++i) {
    const double time = std::max(0.0, drive.step() * static_cast<double>(i + 1) - manner.departure);
    drive.on[i] = place + 0.5 * mean * time * time;
  }
  const auto waited = static_cast<std::size_t>(std::ceil(AddedDrive::kWait / kStep));
  drive.back.assign(std::min(steps_back_, manner.waits ? waited : steps_back_) + 1, place);
  cruiseBack(*meeting.way, added_.speeds.front(), 0.0, drive.back);
  return true;
}

/// Parks beside the path, a little before the meeting and farther out.
bool AddedDrives::park(const AddedMeeting& meeting, const PathPose& place, double before,
                       AddedDrive& drive) const {
  constexpr double kOutward = 0.15;  // a metre along
  drive.aside = besideEgo(meeting, place, kOutward * before);
  if (std::abs(drive.aside) > kParkingDistance) return false;
  drive.back.assign(steps_back_ + 1, place.along - before);
  return extrapolate(meeting, place.along - before, 0.0, 0.0, drive);
}

}  // namespace forge
