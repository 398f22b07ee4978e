#include "collision_forge/attack/search/added_past.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/search/route_driver.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/attack/verify/drive_check.h"

namespace forge {
namespace {

constexpr double kClearance = 0.3;    // m to all recorded agents until t0
constexpr double kMinOnLane = 0.97;   // share of the past on a lane, at least
constexpr double kMaxOffRoad = 0.01;  // mean share of the box off the road in the past, at most
constexpr double kStep = AddedDrive::kStep;
constexpr int kSteps = 2;           // steps of a drive per instant of the traffic
constexpr int kSmoothing = 3;       // steps to either side over which a speed is averaged
constexpr double kUntouched = 0.3;  // s before the contact up to which no other agent is touched

}  // namespace

AddedPast::AddedPast(const AddedVehicleInput& input, const AttackOptions& options)
    : input_(input),
      options_(options),
      added_(options.added),
      past_(input.known()),
      steps_back_(stepsBack(past_)),
      traffic_(past_, input.future, input.request.tta, kStep * kSteps) {}

const char* AddedPast::drive(const AddedDrive& drive, const ReferencePath& path, Track& track) {
  if (drive.back.front() < 0.0) return "would start outside the map";
  if (touchesAhead(drive, path, track.size)) return "would touch another agent first";
  const std::size_t clear = clearSteps(drive, path, track.size);
  const auto first = firstFrame(drive, path, clear);
  if (!first) {
    return clear < static_cast<std::size_t>(added_.least_past / kStep) && clear < steps_back_
               ? clear + 1 < drive.back.size() ? "would have touched an agent before t0"
                                               : "would start outside the map"
               : "would appear in the ego's view";
  }
  return driveFrom(*first, drive, path, track);
}

bool AddedPast::touchesAhead(const AddedDrive& drive, const ReferencePath& path,
                             const BoxSize& size) const {
  const int last = static_cast<int>((drive.contact - kUntouched) / traffic_.interval());
  for (int instant = 1; instant <= last; ++instant) {
    const Pose2 pose = drive.poseAt(path, instant * kSteps);
    if (traffic_.touches(pose, size, instant, 0.0)) return true;
  }
  return false;
}

/// Returns the number of steps back from t0 during which the vehicle is on its path and touches no
/// agent, rounded down to an instant of the traffic.
std::size_t AddedPast::clearSteps(const AddedDrive& drive, const ReferencePath& path,
                                  const BoxSize& size) const {
  for (std::size_t i = 0; i < drive.back.size(); ++i) {
    const bool is_instant = i % kSteps == 0;
    if (drive.back[i] < 0.0 ||
        (is_instant && traffic_.touches(drive.poseAt(path, -static_cast<int>(i)), size,
                                        -static_cast<int>(i / kSteps), kClearance))) {
      // Steps between this and the previous instant are not tested.
      const std::size_t past_instant = is_instant ? kSteps : i % kSteps;
      return i - std::min(i, past_instant);
    }
  }
  return drive.back.size() - 1;
}

/// Returns the first frame from which on the vehicle may exist.
std::optional<std::size_t> AddedPast::firstFrame(const AddedDrive& drive, const ReferencePath& path,
                                                 std::size_t clear) const {
  const std::vector<AgentState>& frames = past_.ego.states;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double ago = past_.now - frames[i].time;
    if (ago / kStep > static_cast<double>(clear) + 1e-6) continue;
    if (!input_.past) return isUnseen(drive, path, 0.0) ? std::make_optional(i) : std::nullopt;
    if (i == 0 || (ago >= added_.least_past - 1e-6 && isUnseen(drive, path, ago))) return i;
  }
  return std::nullopt;
}

bool AddedPast::isUnseen(const AddedDrive& drive, const ReferencePath& path, double ago) const {
  const Vector2 place = drive.poseAt(path, -static_cast<int>(std::lround(ago / kStep))).position();
  const int instant = -static_cast<int>(std::lround(ago / traffic_.interval()));
  const auto distance = traffic_.distanceToEgo(place, instant);
  return !distance || *distance > added_.sensing_range || traffic_.hides(place, instant);
}

/// Drives from frame `frame` to t0 and appends the states at the frames to `track`; returns the
/// reason if that is impossible.
const char* AddedPast::driveFrom(std::size_t frame, const AddedDrive& drive,
                                 const ReferencePath& path, Track& track) {
  const std::vector<AgentState>& frames = past_.ego.states;
  const double ago = past_.now - frames[frame].time;
  const int steps = static_cast<int>(std::ceil(ago / kStep - 1e-6));
  const double begin = past_.now - kStep * steps;
  const TrackDriver driver(
      driveLimitsOf(track.agent_class, track.size, options_.verification.drivable), kLimitShare,
      kPreview, kStep);
  const DriveLimits& limits = driver.limits();
  planned_.clear();
  for (int i = -steps; i <= static_cast<int>(std::ceil(kPreview / kStep)); ++i) {
    const int from = std::max(i - kSmoothing, -steps);
    const int to = i + kSmoothing;
    const double speed = (drive.at(to) - drive.at(from)) / (kStep * (to - from));
    planned_.push_back({drive.poseAt(path, i), std::max(0.0, speed)});
  }
  const ReferencePath::PathPoint place = path.at(drive.at(-steps));
  DriveState start;
  start.axle = compose(planned_.front().pose(), {-limits.axle_to_middle, 0.0, 0.0});
  start.speed = std::min(planned_.front().speed, limits.max_speed);
  start.steering = std::clamp(std::atan(limits.wheelbase * place.curvature),
                              -limits.max_steering_angle, limits.max_steering_angle);
  driver.drive(start, begin, planned_, points_);
  points_.resize(static_cast<std::size_t>(steps) + 1);
  if (findBrokenDrive(points_, start, past_.now, limits))
    return "would violate their vehicle limits";
  for (int i = steps % kSteps; i <= steps; i += kSteps) {
    if (traffic_.touches(points_[static_cast<std::size_t>(i)].pose, track.size,
                         (i - steps) / kSteps, kClearance)) {
      return "would have touched an agent before t0";
    }
  }
  const RoadUse road =
      roadUse(points_, track.size, past_.now, input_.driven(), options_.verification.believability);
  const bool is_parked = points_.back().speed == 0.0 && points_.front().speed == 0.0;
  if (is_parked && isInJunction(points_.back().pose)) return "would be parked in a junction";
  if (is_parked && facesTraffic(points_.back().pose)) return "would be parked against traffic";
  if ((!is_parked && road.on_lane < kMinOnLane) || road.on_walkway > 0.0 || road.on_island > 0.0 ||
      road.off_road > kMaxOffRoad) {
    return "would leave their lane or the road";
  }
  for (std::size_t i = frame; i < frames.size(); ++i) {
    const double offset = (frames[i].time - begin) / kStep;
    const auto before = std::min(static_cast<std::size_t>(std::max(0.0, offset)),
                                 points_.size() - (points_.size() > 1 ? 2 : 1));
    const auto after = std::min(before + 1, points_.size() - 1);
    track.states.push_back({frames[i].time, interpolate(points_[before].pose, points_[after].pose,
                                                        offset - static_cast<double>(before))});
  }
  deriveVelocities(track);
  return nullptr;
}

bool AddedPast::facesTraffic(const Pose2& pose) const {
  const Pose2 turned{pose.x, pose.y, wrapAngle(pose.yaw + M_PI)};
  return !input_.driven().lanesNear(turned, kParkingDistance, kOnLaneHeading).empty();
}

bool AddedPast::isInJunction(const Pose2& pose) const {
  const auto near = input_.driven().lanesNear(pose, kParkingDistance, kOnLaneHeading);
  return std::any_of(near.begin(), near.end(), [&](const LaneMatch& match) {
    const Lane& lane = input_.driven().map().lanes[match.lane];
    return lane.is_connector || lane.is_intersection;
  });
}

}  // namespace forge
