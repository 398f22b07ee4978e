#include "collision_forge/attack/added_vehicle.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "collision_forge/attack/arrival_sampler.h"
#include "collision_forge/attack/lane_ways.h"
#include "collision_forge/attack/placement.h"
#include "collision_forge/attack/realizer.h"
#include "collision_forge/attack/recorded_traffic.h"
#include "collision_forge/attack/track_driver.h"
#include "collision_forge/forecast/random.h"
#include "collision_forge/map/reference_path.h"
#include "collision_forge/verify/believability.h"
#include "collision_forge/verify/drive_check.h"

namespace forge {
namespace {

constexpr double kStep = 0.1;          // s of a drive
constexpr int kSteps = 2;              // of a drive, an instant of the traffic
constexpr int kSmoothing = 3;          // steps to either side that a speed is told from
constexpr double kSpacing = 1.0;       // m between the speeds in bends
constexpr double kMinBend = 1e-3;      // 1/m; straight is no bend
constexpr double kMinContact = 0.3;    // s from now
constexpr double kUntouched = 0.3;     // s before the contact: until then nobody else is touched
constexpr double kGettingGoing = 0.4;  // s until somebody who stood has its acceleration
constexpr double kMoving = 2.0;        // m/s; slower vehicles tell no speed of the traffic
constexpr double kSameSpeed = 1.0;     // m/s
constexpr double kInLane = 2.0;        // m from the middle of a way: in its lane
constexpr double kOwnLane = 1.5;       // m from the middle of a way: the way is the ego's own
constexpr double kHeadsAlong = 0.7;    // rad between the ego and a way that it is on
constexpr std::size_t kFlows = 3;      // a way
constexpr double kFlowLength = 15.0;   // m; shorter drives are not followed
constexpr double kHeadway = 1.2;       // s between two that drive the same way
constexpr std::size_t kOwnSpeeds = 2;  // of recorded vehicles, a way

/// Where somebody is along a way.
struct Flow {
  std::vector<double> times;   // s from now, rising
  std::vector<double> alongs;  // m, never falling

  bool covers(double time) const { return time >= times.front() && time <= times.back(); }
  double at(double time) const {
    const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, time);
    const auto i = static_cast<std::size_t>(after - times.begin());
    const double ratio = (time - times[i - 1]) / (times[i] - times[i - 1]);
    return alongs[i - 1] + std::clamp(ratio, 0.0, 1.0) * (alongs[i] - alongs[i - 1]);
  }
  /// When it passes a place; empty where it does not move past it.
  std::optional<double> passing(double along) const {
    const auto after = std::upper_bound(alongs.begin(), alongs.end(), along);
    if (after == alongs.begin() || after == alongs.end()) return std::nullopt;
    const auto i = static_cast<std::size_t>(after - alongs.begin());
    const double ratio = (along - alongs[i - 1]) / (alongs[i] - alongs[i - 1]);
    return times[i - 1] + ratio * (times[i] - times[i - 1]);
  }
};

/// A way along lanes to a place beside the ego.
struct Way {
  explicit Way(const Polyline& line) : path(line) {}

  double cap(double along) const {
    const double place = std::clamp(along / kSpacing, 0.0, static_cast<double>(caps.size() - 1));
    return caps[static_cast<std::size_t>(place)];
  }

  ReferencePath path;
  std::vector<double> caps;    // m/s in bends, an entry a metre
  std::vector<double> speeds;  // m/s, of recorded vehicles on it
  std::vector<Flow> flows;     // of vehicles that drive along it
  std::vector<double> ego;     // where the ego was along it now, a step before, ...; while it was
  double ego_across = 0.0;     // m from its middle that the ego is now
};

/// Where a vehicle may meet the ego.
struct Meeting {
  const Way* way = nullptr;
  const Track* future = nullptr;  // of the ego
  double contact = 0.0;           // s from now
  Side side = Side::kLeft;        // of the ego
  double heading = 0.0;           // of the attacker from the ego's, rad
  double across = 0.0;            // m from the way's middle that a car is then
};

/// How a vehicle comes along its way.
struct Manner {
  enum Kind { kCruise, kTrain, kFollow, kStart, kStand, kPark };
  Kind kind = kCruise;
  double value = 0.0;  // m/s of a cruise; m/s2 from now on; index of a flow; m before the meeting
  bool waits = false;  // has not always stood
  double aside = 0.0;  // m to the left of the way's middle
};

/// Along a way, m.
struct Drive {
  double aside = 0.0;        // m to the left of its middle
  std::vector<double> back;  // now, a step before, ...
  std::vector<double> on;    // a step after now, ..., at the contact
  /// At a number of steps after now, negative before it; the ends beyond.
  double at(int step) const {
    if (step <= 0) return back[std::min(static_cast<std::size_t>(-step), back.size() - 1)];
    return on[std::min(static_cast<std::size_t>(step), on.size()) - 1];
  }
};

class Casting {
 public:
  Casting(const AddedVehicleInput& input, const AttackOptions& options)
      : input_(input),
        options_(options),
        added_(options.added),
        past_(input.past ? *input.past : input.snapshot),
        traffic_(past_, input.future, input.request.tta, kStep * kSteps),
        ways_to_(input.lanes),
        random_(input.request.seed) {
    const double known = past_.now - past_.ego.states.front().time;
    steps_back_ = static_cast<std::size_t>(std::ceil(known / kStep - 1e-6));
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
    for (const double early : added_.contacts) {
      std::vector<Meeting> meetings;
      for (const std::size_t ego : spread) {
        addMeetings(*egos_[ego], std::max(kMinContact, input_.request.tta + early), meetings);
      }
      std::stable_sort(meetings.begin(), meetings.end(),
                       [&](const Meeting& a, const Meeting& b) { return rankOf(a) < rankOf(b); });
      tryMeetings(meetings, vehicles.found);
      if (isEnough(vehicles.found)) return vehicles;
    }
    if (vehicles.found.empty()) vehicles.status = refusal();
    return vehicles;
  }

 private:
  /// Ways that are nearer to the meeting go first; to change into the ego's lane, others than it.
  long rankOf(const Meeting& meeting) const {
    constexpr long kLast = 100;
    const long rank = std::lround(std::abs(meeting.across));
    const bool is_change = input_.request.type == CollisionType::kLaneChange;
    return is_change && isEgosOwn(meeting) ? rank + kLast : rank;
  }

  /// The ego is on the way then.
  bool isEgosOwn(const Meeting& meeting) const {
    const Pose2 ego = poseOf(*meeting.future, past_.now + meeting.contact);
    const Pose2 place = meeting.way->path.at(meeting.way->path.project(ego.position())).pose;
    return std::abs(relativeTo(place, ego).y) < kOwnLane;
  }

  /// The ego's future is.
  bool isKnown() const { return input_.future.ego_samples.empty(); }

  bool isEnough(const std::vector<AddedVehicle>& found) const {
    return static_cast<int>(found.size()) >=
           (isKnown() ? added_.candidates : added_.predicted_candidates);
  }

  Status refusal() const {
    const bool allows = std::any_of(egos_.begin(), egos_.end(), [&](const Track* ego) {
      return roadAllows(*ego, past_.now, input_.request, input_.lanes,
                        options_.verification.believability);
    });
    const std::string type = toString(input_.request.type);
    if (!allows) {
      return {StatusCode::kRoadDoesNotAllow,
              "no lane near the ego at the asked time has a direction of type = " + type};
    }
    if (!has_way_) {
      return {StatusCode::kRoadDoesNotAllow,
              "no lane leads to the ego at the asked time from where type = " + type + " comes"};
    }
    std::string message = "no vehicle can be added";
    const char* sign = ": ";
    for (const auto& [reason, count] : reasons_) {
      message += sign + std::to_string(count) + " " + reason;
      sign = ", ";
    }
    return {StatusCode::kNoCandidate, message};
  }

  // Ways and meetings.

  /// The ways to a lane, made when first asked for.
  const std::vector<std::unique_ptr<Way>>& waysTo(const FittingLane& fitting) {
    const auto [entry, is_new] = ways_.try_emplace(fitting.lane);
    if (is_new) {
      const double fastest = *std::max_element(added_.speeds.begin(), added_.speeds.end());
      const double back = fastest * (kStep * static_cast<double>(steps_back_) + input_.request.tta);
      for (const Polyline& line :
           ways_to_.to(fitting.lane, fitting.arc_length, back, added_.way_ahead,
                       static_cast<std::size_t>(added_.branches))) {
        entry->second.push_back(wayOf(line));
      }
    }
    return entry->second;
  }

  std::unique_ptr<Way> wayOf(const Polyline& line) const {
    auto way = std::make_unique<Way>(line);
    const auto count = static_cast<std::size_t>(way->path.length() / kSpacing) + 1;
    std::vector<double>& caps = way->caps;
    for (std::size_t i = 0; i < count; ++i) {
      const double bend = std::abs(way->path.at(static_cast<double>(i) * kSpacing).curvature);
      caps.push_back(std::sqrt(added_.lateral / std::max(kMinBend, bend)));
    }
    const auto hold = [&](double& cap, double next) {
      cap = std::min(cap, std::sqrt(next * next + 2.0 * added_.braking * kSpacing));
    };
    for (std::size_t i = count - 1; i-- > 0;) hold(caps[i], caps[i + 1]);
    for (std::size_t i = 1; i < count; ++i) hold(caps[i], caps[i - 1]);
    followEgo(*way);
    addSpeeds(*way);
    addFlows(*way);
    return way;
  }

  void followEgo(Way& way) const {
    for (std::size_t i = 0; i <= steps_back_; ++i) {
      const double time = past_.now - kStep * static_cast<double>(i);
      const auto state = stateAt(past_.ego, std::max(time, past_.ego.states.front().time));
      if (!state) return;
      const double along = way.path.project(state->pose.position());
      const Pose2 apart = relativeTo(way.path.at(along).pose, state->pose);
      if (i == 0) way.ego_across = apart.y;
      if (std::abs(apart.y) > added_.train_distance || std::abs(apart.yaw) > kHeadsAlong) return;
      way.ego.push_back(along);
    }
  }

  void addSpeeds(Way& way) const {
    const double range = added_.sensing_range;
    for (const Track& agent : input_.snapshot.agents) {
      const AgentState& state = agent.states.back();
      const double speed = state.velocity.norm();
      if (way.speeds.size() >= kOwnSpeeds || speed < kMoving || !canAttack(agent.agent_class) ||
          (state.pose.position() - past_.ego.states.back().pose.position()).norm() > range) {
        continue;
      }
      const Pose2 place = way.path.at(way.path.project(state.pose.position())).pose;
      const Pose2 apart = relativeTo(place, state.pose);
      if (apart.position().norm() < kInLane && std::abs(apart.yaw) < kHeadsAlong) {
        addSpeed(speed, way.speeds);
      }
    }
  }

  /// The longest that each vehicle drives along the way, of those that are on it now or then.
  void addFlows(Way& way) const {
    for (const Track& agent : past_.agents) {
      if (way.flows.size() >= kFlows) return;
      if (!canAttack(agent.agent_class)) continue;
      const auto later = std::find_if(input_.future.agents.begin(), input_.future.agents.end(),
                                      [&](const Track& track) { return track.id == agent.id; });
      const bool has_later = later != input_.future.agents.end() && !later->states.empty();
      const AgentState& last = has_later ? later->states.back() : agent.states.back();
      const Vector2 from = agent.states.front().pose.position();
      if ((last.pose.position() - from).norm() < kFlowLength) continue;
      Flow flow;
      bool goes_on = follow(agent, way, flow);
      if (goes_on && has_later) follow(*later, way, flow);
      if (flow.times.size() > 2 && flow.alongs.back() - flow.alongs.front() > kFlowLength) {
        way.flows.push_back(std::move(flow));
      }
    }
  }

  /// Adds where a track is along the way; false where it leaves the way.
  bool follow(const Track& track, const Way& way, Flow& flow) const {
    for (const AgentState& state : track.states) {
      const double time = state.time - past_.now;
      if (!flow.times.empty() && time <= flow.times.back()) continue;
      const double along = way.path.project(state.pose.position());
      const Pose2 apart = relativeTo(way.path.at(along).pose, state.pose);
      if (apart.position().norm() > kInLane || std::abs(apart.yaw) > kHeadsAlong) {
        if (flow.times.size() > 2) return false;
        flow = {};
        continue;
      }
      flow.times.push_back(time);
      flow.alongs.push_back(flow.alongs.empty() ? along : std::max(along, flow.alongs.back()));
    }
    return true;
  }

  static void addSpeed(double speed, std::vector<double>& speeds) {
    const bool has = std::any_of(speeds.begin(), speeds.end(), [&](double other) {
      return std::abs(other - speed) < kSameSpeed;
    });
    if (!has) speeds.push_back(speed);
  }

  static Pose2 poseOf(const Track& ego, double time) {
    return stateAt(ego, time).value_or(ego.states.back()).pose;
  }

  void addMeetings(const Track& future, double contact, std::vector<Meeting>& meetings) {
    const Pose2 ego = poseOf(future, past_.now + contact);
    const std::vector<FittingLane> fitting =
        fittingLanes({ego, past_.ego.size}, input_.request.bands(), input_.request.type,
                     input_.lanes, options_.verification.believability);
    for (const FittingLane& lane : fitting) {
      // The ways to a lane that follows are the same, and more.
      const std::vector<std::size_t>& next = input_.lanes.successors(lane.lane);
      if (std::any_of(fitting.begin(), fitting.end(), [&](const FittingLane& other) {
            return std::find(next.begin(), next.end(), other.lane) != next.end();
          })) {
        continue;
      }
      for (const auto& way : waysTo(lane)) {
        Meeting meeting;
        meeting.way = way.get();
        meeting.future = &future;
        meeting.contact = contact;
        addMeetingsOn(lane.pose, ego, meeting, meetings);
      }
    }
  }

  /// At the placement that is nearest to the way; in rear ends the other one, too.
  void addMeetingsOn(const Pose2& place, const Pose2& ego, Meeting meeting,
                     std::vector<Meeting>& meetings) const {
    const CollisionType type = input_.request.type;
    const ReferencePath& path = meeting.way->path;
    const double direction =
        angleBetween(ego.yaw, path.at(path.project(place.position())).pose.yaw);
    const BoxSize size{added_.kinds.front().length, added_.kinds.front().width};
    std::vector<Meeting> possible;
    for (const HeadedPlacement& placement :
         placementsAlong(direction, type, input_.request.bands(), input_.lanes.map().driving_side,
                         options_.route.heading_margin, options_.route.max_lean)) {
      if (!isSideAsked(placement.side)) continue;
      meeting.side = placement.side;
      meeting.heading = placement.heading;
      meeting.across = seen(meeting, size).across;
      if (std::abs(meeting.across) < options_.route.max_departure) possible.push_back(meeting);
    }
    if (type != CollisionType::kRearEnd && possible.size() > 1) {
      std::swap(
          possible.front(),
          *std::min_element(possible.begin(), possible.end(), [](const auto& a, const auto& b) {
            return std::abs(a.across) < std::abs(b.across);
          }));
      possible.resize(1);
    }
    meetings.insert(meetings.end(), possible.begin(), possible.end());
  }

  /// By the request's side of the ego, or by its manoeuvre.
  bool isSideAsked(Side side) const {
    const CollisionRequest& request = input_.request;
    if (request.ego_side && *request.ego_side != side) return false;
    if (request.type != CollisionType::kRearEnd || !request.manoeuvre) return true;
    return (*request.manoeuvre == Manoeuvre::kFollowerCloses) == (side == Side::kRear);
  }

  Pose2 offsetOf(const Meeting& meeting, const BoxSize& size) const {
    return attackerOffset(past_.ego.size, size, meeting.side, meeting.heading, 0.0, 0.0);
  }

  /// Of a vehicle at the meeting, from the way.
  PathPose seen(const Meeting& meeting, const BoxSize& size) const {
    const Pose2 ego = poseOf(*meeting.future, past_.now + meeting.contact);
    return meeting.way->path.seen(compose(ego, offsetOf(meeting, size)));
  }

  // Drives.

  /// What is tried, in this order.
  std::vector<Manner> mannersOf(const Meeting& meeting) const {
    switch (input_.request.type) {
      case CollisionType::kRearEnd:
        return mannersInLane(meeting);
      case CollisionType::kLaneChange:
        return mannersBeside(meeting);
      case CollisionType::kOppositeDirection:
        return mannersOncoming(meeting);
      case CollisionType::kJunctionCrossing:
      case CollisionType::kLtap:
        break;
    }
    return mannersCrossing(meeting);
  }

  std::vector<Manner> mannersInLane(const Meeting& meeting) const {
    std::vector<Manner> trains = trainsOf(meeting);
    std::vector<Manner> cruises;
    std::vector<double> speeds = speedsOf(meeting);
    if (!isKnown()) {
      // The faster one comes to the other, the less does it matter where exactly the ego will be.
      const double own = past_.ego.states.back().velocity.norm();
      std::sort(speeds.begin(), speeds.end(),
                [&](double a, double b) { return std::abs(a - own) > std::abs(b - own); });
    }
    for (const double speed : speeds) cruises.push_back({Manner::kCruise, speed});
    std::vector<Manner> stands;
    if (meeting.side == Side::kFront) stands.push_back({Manner::kStand});
    const bool stands_first = !isKnown() || input_.request.manoeuvre == Manoeuvre::kLeadStopped;
    return stands_first ? joined({stands, cruises, trains}) : joined({trains, cruises, stands});
  }

  std::vector<Manner> mannersBeside(const Meeting& meeting) const {
    std::vector<Manner> parks;
    for (const double before : added_.parked) parks.push_back({Manner::kPark, before});
    std::vector<Manner> cruises;
    for (const double speed : speedsOf(meeting)) cruises.push_back({Manner::kCruise, speed});
    const std::optional<Manoeuvre>& asked = input_.request.manoeuvre;
    if (asked == Manoeuvre::kPullOut) return parks;
    if (asked) return joined({trainsOf(meeting), cruises});
    return isEgosOwn(meeting) ? joined({parks, trainsOf(meeting), cruises})
                              : joined({trainsOf(meeting), cruises, parks});
  }

  std::vector<Manner> mannersOncoming(const Meeting& meeting) const {
    std::vector<Manner> manners;
    // Who comes slowly cannot cross the centre line in time.
    for (const double speed : speedsOf(meeting)) {
      if (speed >= added_.least_crossing_speed) manners.push_back({Manner::kCruise, speed});
    }
    manners = joined({manners, followsOf(meeting)});
    for (const double start : added_.starts) manners.push_back({Manner::kStart, start, false});
    std::vector<Manner> nearer = manners;
    for (Manner& manner : nearer) manner.aside = std::copysign(added_.aside, meeting.across);
    return joined({manners, nearer});
  }

  std::vector<Manner> mannersCrossing(const Meeting& meeting) const {
    const std::vector<double> speeds = speedsOf(meeting);
    std::vector<Manner> manners;
    for (std::size_t i = 0; i < std::max(speeds.size(), added_.starts.size()); ++i) {
      if (i < speeds.size()) manners.push_back({Manner::kCruise, speeds[i]});
      if (i >= added_.starts.size()) continue;
      manners.push_back({Manner::kStart, added_.starts[i], false});
      manners.push_back({Manner::kStart, added_.starts[i], true});
    }
    const std::vector<Manner> follows = followsOf(meeting);
    manners.insert(manners.begin() + std::min<std::ptrdiff_t>(2, manners.size()), follows.begin(),
                   follows.end());
    return manners;
  }

  /// Of the recorded vehicles on its way, of the ego and of the configuration.
  std::vector<double> speedsOf(const Meeting& meeting) const {
    std::vector<double> speeds = meeting.way->speeds;
    const double own = past_.ego.states.back().velocity.norm();
    if (own > kMoving) addSpeed(own, speeds);
    for (const double speed : added_.speeds) addSpeed(speed, speeds);
    return speeds;
  }

  std::vector<Manner> trainsOf(const Meeting& meeting) const {
    std::vector<Manner> trains;
    for (const double closing : added_.closings) trains.push_back({Manner::kTrain, closing});
    return joined({trains, followsOf(meeting)});
  }

  std::vector<Manner> followsOf(const Meeting& meeting) const {
    std::vector<Manner> follows;
    for (std::size_t i = 0; i < meeting.way->flows.size(); ++i) {
      follows.push_back({Manner::kFollow, static_cast<double>(i)});
    }
    return follows;
  }

  static std::vector<Manner> joined(std::initializer_list<std::vector<Manner>> lists) {
    std::vector<Manner> all;
    for (const std::vector<Manner>& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
  }

  /// Goes on backwards, no faster than bends allow, until everything is known or the way begins.
  void cruiseBack(const Way& way, double speed, double now, std::vector<double>& back) const {
    const double change = added_.braking * kStep;
    while (back.size() <= steps_back_ && back.back() >= 0.0) {
      const double wanted = std::min(speed, way.cap(back.back()));
      const double before = std::clamp(wanted, now - change, now + change);
      back.push_back(back.back() - 0.5 * (now + before) * kStep);
      now = before;
    }
  }

  bool cruise(const Meeting& meeting, double along, double speed, Drive& drive) const {
    const auto count = static_cast<std::size_t>(std::ceil(meeting.contact / kStep));
    const double step = meeting.contact / static_cast<double>(count);
    drive.on.resize(count);
    double now = 0.0;
    for (std::size_t i = count; i-- > 0;) {
      drive.on[i] = along;
      now = std::min(speed, meeting.way->cap(along));
      along -= now * step;
    }
    drive.back = {along};
    cruiseBack(*meeting.way, speed, now, drive.back);
    return true;
  }

  /// On at a steady acceleration; false where that leads backwards.
  bool goOn(const Meeting& meeting, double along, double speed, double acceleration,
            Drive& drive) const {
    if (speed + acceleration * meeting.contact < 0.0) return false;
    const auto count = static_cast<std::size_t>(std::ceil(meeting.contact / kStep));
    const double step = meeting.contact / static_cast<double>(count);
    for (std::size_t i = 1; i <= count; ++i) {
      const double time = step * static_cast<double>(i);
      drive.on.push_back(along + speed * time + 0.5 * acceleration * time * time);
    }
    return true;
  }

  /// As the ego drove so far, at a distance at which `closing` brings both together.
  bool train(const Meeting& meeting, double along, const BoxSize& size, double closing,
             Drive& drive) const {
    const Way& way = *meeting.way;
    const std::size_t count = way.ego.size();
    constexpr std::size_t kSpan = 5;
    if (count <= kSpan) return false;
    const double speed = std::max(0.0, (way.ego[0] - way.ego[kSpan]) / (kSpan * kStep));
    const double contact = meeting.contact;
    const double start = along - speed * contact - 0.5 * closing * contact * contact;
    const double gap = start - way.ego[0];
    const double least = 0.5 * (past_.ego.size.length + size.length) + added_.least_gap;
    if (std::abs(way.ego_across) < kInLane && std::abs(gap) < least) return false;
    if (!goOn(meeting, start, speed, closing, drive)) return false;
    for (const double ego : way.ego) {
      drive.back.push_back(ego + gap);
      if (drive.back.back() < 0.0) return true;
    }
    const double first =
        std::max(0.0, (way.ego[count - 1 - kSpan] - way.ego[count - 1]) / (kSpan * kStep));
    cruiseBack(way, std::max(first, kMoving), first, drive.back);
    return true;
  }

  /// As a vehicle drives along the way, so much later or earlier that it comes to the meeting.
  bool followFlow(const Meeting& meeting, double along, const Flow& flow, Drive& drive) const {
    const auto passing = flow.passing(along);
    if (!passing) return false;
    const double later = meeting.contact - *passing;
    if (std::abs(later) < kHeadway || !flow.covers(-later)) return false;
    const auto count = static_cast<std::size_t>(std::ceil(meeting.contact / kStep));
    const double step = meeting.contact / static_cast<double>(count);
    for (std::size_t i = 1; i <= count; ++i) {
      drive.on.push_back(flow.at(step * static_cast<double>(i) - later));
    }
    double ago = 0.0;
    for (; drive.back.size() <= steps_back_ && flow.covers(-ago - later); ago += kStep) {
      drive.back.push_back(flow.at(-ago - later));
    }
    const double first = flow.times.front();
    const double speed = (flow.at(first + 1.0) - flow.at(first)) / 1.0;
    cruiseBack(*meeting.way, std::max(speed, kMoving), speed, drive.back);
    return true;
  }

  bool start(const Meeting& meeting, double along, const Manner& manner, Drive& drive) const {
    const double moving = std::max(0.0, meeting.contact - kGettingGoing);
    const double place = along - 0.5 * manner.value * moving * moving;
    const double mean = 2.0 * (along - place) / (meeting.contact * meeting.contact);
    if (!goOn(meeting, place, 0.0, mean, drive)) return false;
    const auto waited = static_cast<std::size_t>(std::ceil(added_.wait / kStep));
    drive.back.assign(std::min(steps_back_, manner.waits ? waited : steps_back_) + 1, place);
    cruiseBack(*meeting.way, added_.speeds.front(), 0.0, drive.back);
    return true;
  }

  /// Parked beside the way, a little before the meeting and farther out.
  bool park(const Meeting& meeting, const PathPose& place, double before, Drive& drive) const {
    constexpr double kOutward = 0.15;  // a metre along
    const Pose2 ego = poseOf(*meeting.future, past_.now + meeting.contact);
    const double outward = place.across - meeting.way->path.seen(ego).across;
    drive.aside = place.across + std::copysign(kOutward * before, outward);
    if (std::abs(drive.aside) > options_.route.parking_distance) return false;
    drive.back.assign(steps_back_ + 1, place.along - before);
    return goOn(meeting, place.along - before, 0.0, 0.0, drive);
  }

  bool planOf(const Meeting& meeting, const Manner& manner, const BoxSize& size,
              Drive& drive) const {
    const PathPose place = seen(meeting, size);
    const double along = place.along;
    drive.aside = manner.aside;
    drive.back.clear();
    drive.on.clear();
    switch (manner.kind) {
      case Manner::kCruise:
        return cruise(meeting, along, manner.value, drive);
      case Manner::kTrain:
        return train(meeting, along, size, manner.value, drive);
      case Manner::kFollow:
        return followFlow(meeting, along,
                          meeting.way->flows[static_cast<std::size_t>(manner.value)], drive);
      case Manner::kStart:
        return start(meeting, along, manner, drive);
      case Manner::kStand:
        drive.back.assign(steps_back_ + 1, along);
        return goOn(meeting, along, 0.0, 0.0, drive);
      case Manner::kPark:
        return park(meeting, place, manner.value, drive);
    }
    return false;
  }

  /// Of the drive that is tried, at a number of steps after now.
  Pose2 poseAt(const ReferencePath& path, int step) const { return poseOn(path, drive_.at(step)); }
  Pose2 poseOn(const ReferencePath& path, double along) const {
    return compose(path.at(along).pose, {0.0, drive_.aside, 0.0});
  }

  // Vehicles.

  void tryMeetings(const std::vector<Meeting>& meetings, std::vector<AddedVehicle>& found) {
    std::vector<std::vector<Manner>> manners;
    std::size_t most = 0;
    for (const Meeting& meeting : meetings) {
      manners.push_back(mannersOf(meeting));
      most = std::max(most, manners.back().size());
    }
    for (std::size_t manner = 0; manner < most; ++manner) {
      for (std::size_t i = 0; i < meetings.size(); ++i) {
        if (manner >= manners[i].size()) continue;
        const AddedKind kind = drawKind();
        if (const char* reason = tryOne(meetings[i], manners[i][manner], kind, found)) {
          ++reasons_[reason];
          continue;
        }
        if (isEnough(found)) return;
        // Where few are tried, these shall differ.
        if (!isKnown()) break;
      }
    }
  }

  /// With its length drawn, too.
  AddedKind drawKind() {
    double sum = 0.0;
    const auto shareOf = [&](const AddedKind& kind) {
      const auto& asked = input_.request.attacker_class;
      if (!asked) return kind.share;
      // The last of them where none has a share.
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

  /// Adds the vehicle; else why it does not fit.
  const char* tryOne(const Meeting& meeting, const Manner& manner, const AddedKind& kind,
                     std::vector<AddedVehicle>& found) {
    const BoxSize size{kind.length, kind.width};
    if (!planOf(meeting, manner, size, drive_)) return "cannot drive so";
    const ReferencePath& path = meeting.way->path;
    const double ego_yaw = past_.ego.states.back().pose.yaw;
    const double approach = angleBetween(ego_yaw, path.at(drive_.back.front()).pose.yaw);
    if (input_.request.crash.rules == TypeRules::kFull &&
        !approachFits(approach, input_.request.bands())) {
      return "do not come from where the type wants them";
    }
    has_way_ = true;
    if (drive_.back.front() < 0.0) return "come from beyond the map";
    if (touchesAhead(path, size, meeting.contact)) return "touch somebody else first";
    const std::size_t clear = clearSteps(path, size);
    const auto first = firstFrame(path, clear);
    if (!first) {
      return clear < static_cast<std::size_t>(added_.least_past / kStep) && clear < steps_back_
                 ? clear + 1 < drive_.back.size() ? "would have touched somebody"
                                                  : "come from beyond the map"
                 : "would appear in sight";
    }
    AddedVehicle vehicle{{}, path, {}};
    Track& track = vehicle.track;
    track = {nameOf(found.size()), kind.agent_class, size, {}};
    if (const char* reason = driveFrom(*first, path, track)) return reason;
    addPatterns(meeting, vehicle);
    found.push_back(std::move(vehicle));
    return nullptr;
  }

  std::string nameOf(std::size_t index) const {
    std::string name;
    const auto isTaken = [&](const Track& agent) { return agent.id == name; };
    do {
      name = "added-" + std::to_string(++index);
    } while (std::any_of(past_.agents.begin(), past_.agents.end(), isTaken));
    return name;
  }

  bool touchesAhead(const ReferencePath& path, const BoxSize& size, double contact) const {
    const int last = static_cast<int>((contact - kUntouched) / traffic_.interval());
    for (int instant = 1; instant <= last; ++instant) {
      const Pose2 pose = poseAt(path, instant * kSteps);
      if (traffic_.touches(pose, size, instant, 0.0)) return true;
    }
    return false;
  }

  /// So many steps back from now, to an instant of the traffic, it is on its way and touches
  /// nobody.
  std::size_t clearSteps(const ReferencePath& path, const BoxSize& size) const {
    for (std::size_t i = 0; i < drive_.back.size(); ++i) {
      const bool is_instant = i % kSteps == 0;
      if (drive_.back[i] < 0.0 ||
          (is_instant && traffic_.touches(poseOn(path, drive_.back[i]), size,
                                          -static_cast<int>(i / kSteps), added_.clearance))) {
        // Nothing is known of the steps between this and the instant before.
        const std::size_t past_instant = is_instant ? kSteps : i % kSteps;
        return i - std::min(i, past_instant);
      }
    }
    return drive_.back.size() - 1;
  }

  /// The first frame from which on it may have been there.
  std::optional<std::size_t> firstFrame(const ReferencePath& path, std::size_t clear) const {
    const std::vector<AgentState>& frames = past_.ego.states;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const double ago = past_.now - frames[i].time;
      if (ago / kStep > static_cast<double>(clear) + 1e-6) continue;
      if (!input_.past) return isUnseen(path, 0.0) ? std::make_optional(i) : std::nullopt;
      if (i == 0 || (ago >= added_.least_past - 1e-6 && isUnseen(path, ago))) return i;
    }
    return std::nullopt;
  }

  bool isUnseen(const ReferencePath& path, double ago) const {
    const Vector2 place = poseAt(path, -static_cast<int>(std::lround(ago / kStep))).position();
    const int instant = -static_cast<int>(std::lround(ago / traffic_.interval()));
    const auto distance = traffic_.distanceToEgo(place, instant);
    return !distance || *distance > added_.sensing_range || traffic_.hides(place, instant);
  }

  /// Drives it from a frame to now; its states at the frames. Why not, if it cannot.
  const char* driveFrom(std::size_t frame, const ReferencePath& path, Track& track) {
    const std::vector<AgentState>& frames = past_.ego.states;
    const double ago = past_.now - frames[frame].time;
    const int steps = static_cast<int>(std::ceil(ago / kStep - 1e-6));
    const double begin = past_.now - kStep * steps;
    const RouteDriverOptions& route = options_.route;
    const TrackDriver driver(
        driveLimitsOf(track.agent_class, track.size, options_.verification.drivable),
        route.limit_share, route.preview, kStep);
    const DriveLimits& limits = driver.limits();
    planned_.clear();
    for (int i = -steps; i <= static_cast<int>(std::ceil(route.preview / kStep)); ++i) {
      const double speed =
          (drive_.at(i + kSmoothing) - drive_.at(i - kSmoothing)) / (2.0 * kSmoothing * kStep);
      planned_.push_back({poseAt(path, i), std::max(0.0, speed)});
    }
    const ReferencePath::Place place = path.at(drive_.at(-steps));
    DriveState start;
    start.axle = compose(planned_.front().middle, {-limits.axle_to_middle, 0.0, 0.0});
    start.speed = std::min(planned_.front().speed, limits.max_speed);
    start.steering = std::clamp(std::atan(limits.wheelbase * place.curvature),
                                -limits.max_steering_angle, limits.max_steering_angle);
    driver.drive(start, begin, planned_, points_);
    points_.resize(static_cast<std::size_t>(steps) + 1);
    if (findBrokenDrive(points_, start, past_.now, limits)) return "cannot keep their limits";
    for (int i = steps % kSteps; i <= steps; i += kSteps) {
      if (traffic_.touches(points_[static_cast<std::size_t>(i)].pose, track.size,
                           (i - steps) / kSteps, added_.clearance)) {
        return "would have touched somebody";
      }
    }
    const RoadUse road =
        roadUse(points_, track.size, past_.now, input_.lanes, options_.verification.believability);
    const bool is_parked = points_.back().speed == 0.0 && points_.front().speed == 0.0;
    if (is_parked && isInJunction(points_.back().pose)) return "would be parked in a junction";
    if ((!is_parked && road.on_lane < added_.min_on_lane) || road.on_walkway > 0.0 ||
        road.on_island > 0.0 || road.off_road > added_.max_off_road) {
      return "leave their lane or the road";
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

  bool isInJunction(const Pose2& pose) const {
    const auto near = input_.lanes.lanesNear(pose, options_.route.parking_distance,
                                             options_.prediction.on_lane_heading);
    return std::any_of(near.begin(), near.end(), [&](const LaneMatch& match) {
      const Lane& lane = input_.lanes.map().lanes[match.lane];
      return lane.is_connector || lane.is_intersection;
    });
  }

  void addPatterns(const Meeting& meeting, AddedVehicle& vehicle) const {
    const Track& track = vehicle.track;
    CollisionPattern pattern;
    pattern.type = input_.request.type;
    pattern.attacker_id = track.id;
    pattern.time = past_.now + meeting.contact;
    pattern.ego = {poseOf(*meeting.future, pattern.time), past_.ego.size};
    const std::size_t last = drive_.on.size() - 1;
    const double before = last > 0 ? drive_.on[last - 1] : drive_.back.front();
    pattern.attacker_speed = std::max(0.0, (drive_.on[last] - before) / kStep);
    pattern.tolerance = options_.prediction.pattern_tolerance;
    pattern.attacker_offset = offsetOf(meeting, track.size);
    vehicle.patterns.push_back(pattern);
    if (input_.request.type == CollisionType::kRearEnd) return;
    const double sign = std::copysign(1.0, meeting.heading);
    for (const Placement& placement :
         placementsOf(input_.request.type, input_.lanes.map().driving_side)) {
      if (placement.side == meeting.side || (placement.sign != 0.0 && placement.sign != sign)) {
        continue;
      }
      Meeting other = meeting;
      other.side = placement.side;
      pattern.attacker_offset = offsetOf(other, track.size);
      vehicle.patterns.push_back(pattern);
    }
  }

  const AddedVehicleInput& input_;
  const AttackOptions& options_;
  const AddedVehicleOptions& added_;
  const Snapshot& past_;
  RecordedTraffic traffic_;
  LaneWays ways_to_;
  Random random_;
  std::size_t steps_back_ = 0;
  std::vector<const Track*> egos_;                                 // those that are searched
  std::map<std::size_t, std::vector<std::unique_ptr<Way>>> ways_;  // by lane
  std::map<std::string, int> reasons_;
  bool has_way_ = false;  // that comes from where the type wants it
  Drive drive_;
  std::vector<PlannedStep> planned_;
  std::vector<TrajectoryPoint> points_;
};

/// What is known of a vehicle in the frames of a snapshot.
Track within(const Track& track, const Snapshot& snapshot) {
  const double first = snapshot.ego.states.front().time;
  Track seen = track;
  seen.states.erase(seen.states.begin(),
                    std::find_if(seen.states.begin(), seen.states.end(),
                                 [&](const auto& state) { return state.time >= first - 1e-6; }));
  deriveVelocities(seen);
  return seen;
}

}  // namespace

AddedVehicles addVehicles(const AddedVehicleInput& input, const AttackOptions& options) {
  return Casting(input, options).run();
}

Realization realizeByAdded(const AddedVehicleInput& input, const AttackOptions& options) {
  const AddedVehicles vehicles = addVehicles(input, options);
  Realization best;
  best.status = vehicles.status;
  bool is_found = false;
  double best_worth = 0.0;
  // Where the ego is known, the first one that can is as good as any.
  const std::size_t together = input.future.ego_samples.empty() ? 1 : vehicles.found.size();
  for (std::size_t i = 0; i < vehicles.found.size(); i += together) {
    Snapshot snapshot = input.snapshot;
    std::vector<CollisionPattern> patterns;
    AttackerWays ways;
    for (std::size_t j = i; j < i + together; ++j) {
      const AddedVehicle& vehicle = vehicles.found[j];
      snapshot.agents.push_back(within(vehicle.track, snapshot));
      patterns.insert(patterns.end(), vehicle.patterns.begin(), vehicle.patterns.end());
      ways.emplace(vehicle.track.id, vehicle.way);
    }
    Realization answer = realize(patterns, {snapshot, input.future, input.request, input.lanes},
                                 options, false, ways);
    if (answer.status.code != StatusCode::kOk) {
      if (i == 0) best.status = answer.status;
      continue;
    }
    const double worth = answer.report.confidence - answer.effort;
    if (is_found && worth <= best_worth) continue;
    is_found = true;
    best_worth = worth;
    best = std::move(answer);
    const auto vehicle = std::find_if(
        vehicles.found.begin(), vehicles.found.end(),
        [&](const AddedVehicle& other) { return other.track.id == best.trajectory.attacker_id; });
    best.trajectory.past = vehicle->track.states;
    if (best_worth >= options.search.good_share) break;
  }
  return best;
}

}  // namespace forge
