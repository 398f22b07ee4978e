#include "collision_forge/attack/search/added_vehicle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/added_drives.h"
#include "collision_forge/attack/search/added_past.h"
#include "collision_forge/attack/search/arrival_sampler.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/placement.h"
#include "collision_forge/attack/search/route_driver.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/attack/verify/measured_conditions.h"
#include "collision_forge/base/scene/find_track.h"

namespace forge {
namespace {

constexpr double kContacts[] = {0.0, -0.3, 0.3, -0.45, 0.45};  // s, added to the requested time
constexpr double kMinContact = 0.3;                            // s after t0

/// Returns true for types in which the attacker comes from a lane beside the ego.
bool isFromBeside(CollisionType type) {
  return type == CollisionType::kLaneChange || type == CollisionType::kSideswipeSameDirection;
}

bool isCar(const AddedVehicle& vehicle) { return isCarLike(vehicle.track.agent_class); }

/// Finds vehicles that can be added.
class VehicleInsertion {
 public:
  VehicleInsertion(const AddedVehicleInput& input, const AttackOptions& options)
      : input_(input),
        options_(options),
        added_(options.added),
        past_(input.known()),
        ways_(input, options.added),
        drives_(input, options),
        added_past_(input, options),
        random_(input.request.seed) {
    for (std::size_t i = 0; i < input.future.ego_samples.size(); i += 2) {
      egos_.push_back(&input.future.ego_samples[i]);
    }
    if (egos_.empty()) egos_.push_back(&input.future.ego);
  }

  AddedVehicles run() {
    AddedVehicles vehicles;
    const double now = past_.now;
    const std::vector<std::size_t> spread = spreadFutures(
        egos_, past_.ego.states.back().pose, now + input_.request.tta, options_.search.ego_poses);
    for (const double early : kContacts) {
      std::vector<AddedMeeting> meetings;
      for (const std::size_t ego : spread) {
        addMeetings(*egos_[ego], std::max(kMinContact, input_.request.tta + early), meetings);
      }
      std::stable_sort(
          meetings.begin(), meetings.end(),
          [&](const AddedMeeting& a, const AddedMeeting& b) { return rankOf(a) < rankOf(b); });
      tryMeetings(meetings, vehicles.found);
      if (isEnough(vehicles.found)) break;
    }
    if (vehicles.found.empty()) vehicles.status = refusal();
    // Motorcycles beside the ego in its lane are rarer than cars that change lanes.
    std::stable_partition(vehicles.found.begin(), vehicles.found.end(), isCar);
    return vehicles;
  }

 private:
  /// Ranks paths nearer to the meeting first; for a lane change, the ego's own lane last.
  long rankOf(const AddedMeeting& meeting) const {
    constexpr long kLast = 100;
    const long rank = std::lround(std::abs(meeting.across));
    return isFromBeside(input_.request.type) && meeting.isEgosPath() ? rank + kLast : rank;
  }

  bool isEnough(const std::vector<AddedVehicle>& found) const {
    return static_cast<int>(found.size()) >=
           (input_.isFutureKnown() ? added_.candidates : added_.predicted_candidates);
  }

  Status refusal() const {
    const bool allows = std::any_of(egos_.begin(), egos_.end(), [&](const Track* ego) {
      return roadAllows(*ego, past_.now, input_.request, input_.lanes,
                        options_.verification.believability);
    });
    const std::string type = toString(input_.request.type);
    if (!allows) {
      return {StatusCode::kRoadDoesNotAllow, roadRefusal(input_.request)};
    }
    if (!has_way_) {
      return {
          StatusCode::kRoadDoesNotAllow,
          "no lane leads to the ego's place at the contact from the direction of type = " + type};
    }
    std::string message = "no vehicle can be added";
    const char* sign = ": ";
    for (const auto& [reason, count] : reasons_) {
      message += sign + std::to_string(count) + " " + reason;
      sign = ", ";
    }
    return {StatusCode::kNoCandidate, message};
  }

  // Meetings.

  static Pose2 poseOf(const Track& ego, double time) {
    return stateAt(ego, time).value_or(ego.states.back()).pose;
  }

  void addMeetings(const Track& future, double contact, std::vector<AddedMeeting>& meetings) {
    const OrientedBox ego = {poseOf(future, past_.now + contact), past_.ego.size};
    const std::vector<FittingLane> fitting =
        fittingLanes(ego, input_.request, input_.driven(), options_.verification.believability);
    for (const FittingLane& lane : fitting) {
      // Paths to a following lane include the paths to this one.
      const std::vector<std::size_t>& next = input_.driven().successors(lane.lane);
      if (std::any_of(fitting.begin(), fitting.end(), [&](const FittingLane& other) {
            return std::find(next.begin(), next.end(), other.lane) != next.end();
          })) {
        continue;
      }
      for (const auto& way : ways_.to(lane)) {
        AddedMeeting meeting;
        meeting.way = way.get();
        meeting.ego = ego;
        meeting.contact = contact;
        addMeetingsOn(lane.pose, meeting, meetings);
      }
    }
  }

  /// Adds the placement nearest to the path; for rear ends, both ends.
  void addMeetingsOn(const Pose2& place, AddedMeeting meeting,
                     std::vector<AddedMeeting>& meetings) const {
    const CollisionType type = input_.request.type;
    const ReferencePath& path = meeting.way->path;
    const double direction =
        angleBetween(meeting.ego.center.yaw, path.at(path.project(place.position())).pose.yaw);
    const BoxSize size{added_.kinds.front().length, added_.kinds.front().width};
    std::vector<AddedMeeting> possible;
    for (const HeadedPlacement& placement :
         placementsAlong(direction, input_.request, input_.lanes.map().driving_side,
                         kArrivalHeadingMargin, kMaxLean)) {
      if (!isEndAllowed(placement.side)) continue;
      meeting.side = placement.side;
      meeting.heading = placement.heading;
      if (const std::optional<Range>& location = input_.request.impact_location) {
        meeting.contact_position = contactPositionOf(0.5 * (location->min + location->max));
      }
      meeting.across = meeting.frenetOf(size).across;
      if (std::abs(meeting.across) < kMaxDeparture) possible.push_back(meeting);
    }
    // In the ego's own lane, a vehicle can follow or lead, or be parked on either side.
    const bool all_count =
        type == CollisionType::kRearEnd || (isFromBeside(type) && meeting.isEgosPath());
    if (!all_count && possible.size() > 1) {
      std::swap(
          possible.front(),
          *std::min_element(possible.begin(), possible.end(), [](const auto& a, const auto& b) {
            return std::abs(a.across) < std::abs(b.across);
          }));
      possible.resize(1);
    }
    meetings.insert(meetings.end(), possible.begin(), possible.end());
  }

  /// Returns true if the requested manoeuvre allows this end of the ego in a rear-end collision.
  bool isEndAllowed(Side side) const {
    const CollisionRequest& request = input_.request;
    if (request.type != CollisionType::kRearEnd || !request.manoeuvre) return true;
    return (*request.manoeuvre == Manoeuvre::kFollowerCloses) == (side == Side::kRear);
  }

  // Vehicles.

  void tryMeetings(const std::vector<AddedMeeting>& meetings, std::vector<AddedVehicle>& found) {
    std::vector<std::vector<ApproachManner>> manners;
    std::size_t most = 0;
    for (const AddedMeeting& meeting : meetings) {
      manners.push_back(drives_.mannersFor(meeting));
      most = std::max(most, manners.back().size());
    }
    for (std::size_t manner = 0; manner < most; ++manner) {
      for (std::size_t i = 0; i < meetings.size(); ++i) {
        if (manner >= manners[i].size()) continue;
        const char* reason = tryOne(meetings[i], manners[i][manner], found);
        if (reason) {
          ++reasons_[reason];
          continue;
        }
        if (isEnough(found)) return;
        // With few attempts, try different manners.
        if (!input_.isFutureKnown()) break;
      }
    }
  }

  /// Draws a kind and its length.
  AddedKind drawKind(const std::optional<AgentClass>& asked) {
    double sum = 0.0;
    const auto shareOf = [&](const AddedKind& kind) {
      if (!asked) return kind.share;
      // If no kind of the class has a share, the last one is used.
      return kind.agent_class == *asked ? std::max(kind.share, 1e-6) : 0.0;
    };
    for (const AddedKind& kind : added_.kinds) sum += shareOf(kind);
    double place = random_.uniform(0.0, sum);
    AddedKind drawn = added_.kinds.front();
    for (const AddedKind& kind : added_.kinds) {
      if (shareOf(kind) <= 0.0) continue;
      drawn = kind;
      place -= shareOf(kind);
      if (place < 0.0) break;
    }
    drawn.length += random_.bell(drawn.length_deviation);
    return drawn;
  }

  /// Adds the vehicle; returns the reason if it does not fit.
  const char* tryOne(const AddedMeeting& meeting, const ApproachManner& manner,
                     std::vector<AddedVehicle>& found) {
    const auto& asked = input_.request.attacker_class;
    const bool asks_for_cycle = asked && isCycle(*asked);
    if (manner.is_motorcycle_beside && asked && *asked != AgentClass::kMotorcycle &&
        !asks_for_cycle) {
      has_way_ = true;
      return "are too wide";
    }
    const AddedKind kind =
        drawKind(manner.is_motorcycle_beside && !asks_for_cycle ? AgentClass::kMotorcycle : asked);
    const BoxSize size{kind.length, kind.width};
    nameNext(found);
    if (!drives_.plan(meeting, manner, size, drive_, variation_))
      return "cannot reach the contact in time";
    const ReferencePath& path = meeting.way->path;
    const double ego_yaw = past_.ego.states.back().pose.yaw;
    const double approach = angleBetween(ego_yaw, path.at(drive_.back.front()).pose.yaw);
    if (input_.request.crash.rules == TypeRules::kFull &&
        !approachFits(approach, input_.request.bands())) {
      return "do not approach from the direction of the type";
    }
    has_way_ = true;
    Track track{name_, kind.agent_class, size, {}};
    if (const char* reason = added_past_.drive(drive_, path, track)) return reason;
    if (!startsAsRequested(track)) return "have another gap or headway at t0";
    const bool keeps_aside = drive_.aside != 0.0 && manner.kind != ApproachManner::kPark;
    AddedVehicle vehicle{std::move(track), keeps_aside ? path.beside(drive_.aside) : path, {}};
    addPatterns(meeting, vehicle);
    found.push_back(std::move(vehicle));
    return nullptr;
  }

  /// Returns true if the request's gap and headway at t0 allow the vehicle.
  bool startsAsRequested(const Track& track) const {
    const CollisionRequest& request = input_.request;
    if (!request.gap && !request.headway) return true;
    const auto fits = [](const std::optional<Range>& range, double value) {
      return !range || (value >= range->min && value <= range->max);
    };
    ContactConditions measured;
    const AgentState& now = track.states.back();
    measureStart(past_.ego.states.back(), past_.ego.size, now, track.size, measured);
    return fits(request.gap, measured.gap) && fits(request.headway, measured.headway);
  }

  /// Sets name_ and variation_ of the vehicle after those in `found`.
  void nameNext(const std::vector<AddedVehicle>& found) {
    if (!name_.empty() && found.size() == named_after_) return;
    name_ = newVehicleId(past_, found);
    variation_ = variationOf(name_, input_.request.seed);
    named_after_ = found.size();
  }

  void addPatterns(const AddedMeeting& meeting, AddedVehicle& vehicle) const {
    const Track& track = vehicle.track;
    CollisionPattern pattern;
    pattern.type = input_.request.type;
    pattern.attacker_id = track.id;
    pattern.time = past_.now + meeting.contact;
    pattern.ego = meeting.ego;
    const std::size_t last = drive_.on.size() - 1;
    const double before = last > 0 ? drive_.on[last - 1] : drive_.back.front();
    pattern.attacker_speed = std::max(0.0, (drive_.on[last] - before) / drive_.step());
    pattern.tolerance = options_.prediction.pattern_tolerance;
    pattern.attacker_offset = meeting.offsetOf(track.size);
    vehicle.patterns.push_back(pattern);
    if (input_.request.type == CollisionType::kRearEnd) return;
    const double sign = std::copysign(1.0, meeting.heading);
    for (const Placement& placement : placementsOf(
             input_.request.type, input_.lanes.map().driving_side, input_.request.turning)) {
      if (placement.side == meeting.side || (placement.sign != 0.0 && placement.sign != sign)) {
        continue;
      }
      AddedMeeting other = meeting;
      other.side = placement.side;
      pattern.attacker_offset = other.offsetOf(track.size);
      vehicle.patterns.push_back(pattern);
    }
  }

  const AddedVehicleInput& input_;
  const AttackOptions& options_;
  const AddedVehicleOptions& added_;
  const Snapshot& past_;
  AddedPaths ways_;
  AddedDrives drives_;
  AddedPast added_past_;
  Random random_;
  std::vector<const Track*> egos_;  // futures available to the search
  std::map<std::string, int> reasons_;
  bool has_way_ = false;  // a path leads to the ego from the type's direction
  AddedDrive drive_;
  std::string name_;             // of the vehicle that is tried
  SpeedVariation variation_;     // its own
  std::size_t named_after_ = 0;  // vehicles found when it was named
};

/// Returns the states of a vehicle in the frames of a snapshot.
Track within(const Track& track, const Snapshot& snapshot) {
  const double first = snapshot.ego.states.front().time;
  Track seen = track;
  seen.states.erase(seen.states.begin(),
                    std::find_if(seen.states.begin(), seen.states.end(),
                                 [&](const auto& state) { return state.time >= first - 1e-6; }));
  deriveVelocities(seen);
  return seen;
}

/// Calls realize() with all these vehicles.
Attack realizeBy(const std::vector<AddedVehicle>& vehicles, const AddedVehicleInput& input,
                 const TrajectoryRealizer& realizer, SearchedMotion motion) {
  Snapshot snapshot = input.snapshot;
  std::vector<CollisionPattern> patterns;
  AttackerPaths ways;
  for (const AddedVehicle& vehicle : vehicles) {
    snapshot.agents.push_back(within(vehicle.track, snapshot));
    patterns.insert(patterns.end(), vehicle.patterns.begin(), vehicle.patterns.end());
    ways.emplace(vehicle.track.id, vehicle.way);
  }
  Attack answer = realizer.realize(
      {patterns, {snapshot, input.future, input.request, input.lanes}, false, ways, motion});
  if (answer.status.code != StatusCode::kOk) return answer;
  const auto vehicle = std::find_if(
      vehicles.begin(), vehicles.end(),
      [&](const AddedVehicle& other) { return other.track.id == answer.trajectory.attacker_id; });
  answer.trajectory.past = vehicle->track.states;
  return answer;
}

}  // namespace

std::string newVehicleId(const Snapshot& past, const std::vector<AddedVehicle>& found) {
  std::string id;
  const auto isTaken = [&] {
    return findTrack(past.agents, id) != nullptr ||
           std::any_of(found.begin(), found.end(),
                       [&](const AddedVehicle& vehicle) { return vehicle.track.id == id; });
  };
  std::size_t index = found.size();
  do {
    id = "added-" + std::to_string(++index);
  } while (isTaken());
  return id;
}

AddedVehicles addVehicles(const AddedVehicleInput& input, const AttackOptions& options) {
  return VehicleInsertion(input, options).run();
}

Attack realizeByAdded(const AddedVehicles& vehicles, const AddedVehicleInput& input,
                      const AttackOptions& options, const TrajectoryRealizer& realizer,
                      SearchedMotion motion) {
  Attack best;
  best.status = vehicles.status;
  bool is_found = false;
  const auto first = vehicles.found.begin();
  const auto end = vehicles.found.end();
  const auto motorcycles = std::partition_point(first, end, isCar);
  for (const auto& [from, to] : {std::pair(first, motorcycles), std::pair(motorcycles, end)}) {
    if (from == to) continue;
    const bool is_last_resort = from == motorcycles && !input.request.attacker_class;
    const double cost = is_last_resort ? kRidingCost : 0.0;
    Attack answer = realizeBy({from, to}, input, realizer, motion);
    if (answer.status.code != StatusCode::kOk) {
      if (from == first) best.status = answer.status;
      continue;
    }
    answer.effort += cost;
    if (is_found && scoreOf(answer) <= scoreOf(best)) continue;
    is_found = true;
    best = std::move(answer);
    if (scoreOf(best) >= options.search.good_share) break;
  }
  return best;
}

}  // namespace forge
