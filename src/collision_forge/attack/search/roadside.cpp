#include "collision_forge/attack/search/roadside.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/placement.h"
#include "collision_forge/attack/search/recorded_traffic.h"
#include "collision_forge/attack/search/route_driver.h"
#include "collision_forge/attack/search/walker_path.h"
#include "collision_forge/attack/verify/reversing.h"
#include "collision_forge/attack/verify/step_out.h"

namespace forge {
namespace {

constexpr double kInterval = 0.2;     // s between the instants at which the attacker touches nobody
constexpr double kClearance = 0.3;    // m to recorded agents while it waits
constexpr double kSearchStep = 0.25;  // m between the places that are tried from the meeting out
constexpr double kNearest = 1.5;      // m from the meeting
constexpr double kFarthest = 18.0;    // m; a runner gets that far in the longest time to attack
constexpr double kFromKerb[] = {0.7, 1.5, 2.5};  // m that people wait behind the edge of the road
constexpr double kFromLane[] = {0.0, 0.5, 1.0};  // m that a vehicle stands deeper than necessary
// Share of the highest speed that a reversing vehicle has on average, started from rest.
constexpr double kMeanSpeed = 0.75;
constexpr double kContacts[] = {0.0, -0.3, 0.3};  // s, added to the requested time
constexpr std::size_t kMost = 8;                  // attackers that are searched

/// A kind of attacker that waits beside the road.
class Waiting {
 public:
  virtual ~Waiting() = default;
  virtual AgentClass agentClass() const = 0;
  /// Returns true if it moves with its rear ahead.
  virtual bool reverses() const = 0;
  /// Returns m from the meeting (its yaw is the direction of travel) back to the places that are
  /// tried; none if there is no roadside.
  virtual std::vector<double> places(const Pose2& meeting, const BoxSize& size) const = 0;
  /// Returns why it cannot wait at `start`, `away` m from the meeting, and get there within
  /// `duration` s; null if it can.
  virtual const char* whyNotFrom(const Pose2& start, double away, double duration) const = 0;
};

class WaitingWalker : public Waiting {
 public:
  WaitingWalker(AgentClass agent_class, const LaneIndex& lanes)
      : agent_class_(agent_class), lanes_(lanes) {}

  AgentClass agentClass() const override { return agent_class_; }
  bool reverses() const override { return false; }

  std::vector<double> places(const Pose2& meeting, const BoxSize&) const override {
    for (double away = 0.0; away < kFarthest; away += kSearchStep) {
      const Vector2 place = compose(meeting, {-away, 0.0, 0.0}).position();
      if (lanes_.drivable().contains(place)) continue;
      std::vector<double> found;
      for (const double behind : kFromKerb) found.push_back(std::max(away, kNearest) + behind);
      return found;
    }
    return {};
  }

  const char* whyNotFrom(const Pose2& start, double away, double duration) const override {
    if (away > gaitOf(agent_class_).fastest_mean * duration) return "would have to run too fast";
    if (!isWherePeopleWalk(start.position(), lanes_)) return "would wait where nobody walks";
    if (lanes_.drivable().contains(start.position())) return "would wait in the road";
    return nullptr;
  }

 private:
  AgentClass agent_class_;
  const LaneIndex& lanes_;
};

class ParkedNoseIn : public Waiting {
 public:
  ParkedNoseIn(AgentClass agent_class, double max_speed, const LaneIndex& lanes)
      : agent_class_(agent_class), max_speed_(max_speed), lanes_(lanes) {}

  AgentClass agentClass() const override { return agent_class_; }
  bool reverses() const override { return true; }

  std::vector<double> places(const Pose2& meeting, const BoxSize& size) const override {
    std::vector<double> found;
    const auto nearest = bayBehind(meeting, size, lanes_);
    if (!nearest) return found;
    for (const double deeper : kFromLane) {
      const double away = std::max(kNearest, *nearest) + deeper;
      if (isInBay({compose(meeting, {-away, 0.0, M_PI}), size}, lanes_)) found.push_back(away);
    }
    return found;
  }

  const char* whyNotFrom(const Pose2&, double away, double duration) const override {
    return away > kMeanSpeed * max_speed_ * duration ? "would have to reverse too fast" : nullptr;
  }

 private:
  AgentClass agent_class_;
  double max_speed_;
  const LaneIndex& lanes_;
};

std::unique_ptr<Waiting> waitingFor(const AddedVehicleInput& input, const AttackOptions& options) {
  const std::optional<AgentClass>& asked = input.request.attacker_class;
  if (input.request.reverses()) {
    return std::make_unique<ParkedNoseIn>(asked.value_or(AgentClass::kCar),
                                          options.verification.drivable.max_reverse_speed,
                                          input.lanes);
  }
  return std::make_unique<WaitingWalker>(asked.value_or(AgentClass::kPedestrian), input.lanes);
}

class RoadsideInsertion {
 public:
  RoadsideInsertion(const AddedVehicleInput& input, const AttackOptions& options)
      : input_(input),
        options_(options),
        past_(input.known()),
        waiting_(waitingFor(input, options)),
        traffic_(past_, input.future, input.request.tta, kInterval),
        random_(input.request.seed) {}

  AddedVehicles run() {
    AddedVehicles attackers;
    if (!input_.past) {
      attackers.status = {StatusCode::kNoCandidate,
                          std::string("no ") + toString(waiting_->agentClass()) +
                              " can be added live: the ego has seen the roadside"};
      return attackers;
    }
    for (const Track* ego : egos()) {
      for (const double early : kContacts) {
        addFor(*ego, input_.request.tta + early, attackers.found);
      }
    }
    if (attackers.found.empty()) attackers.status = refusal();
    return attackers;
  }

 private:
  /// Returns the recorded future, or a few predicted ones.
  std::vector<const Track*> egos() const {
    constexpr std::size_t kStride = 16;
    std::vector<const Track*> tracks = {&input_.future.ego};
    for (std::size_t i = 0; i < input_.future.ego_samples.size(); i += kStride) {
      tracks.push_back(&input_.future.ego_samples[i]);
    }
    return tracks;
  }

  void addFor(const Track& future, double contact, std::vector<AddedVehicle>& found) {
    const auto state = stateAt(future, past_.now + contact);
    if (!state || contact <= 0.0) return;
    const DrivingSide driving_side = input_.lanes.map().driving_side;
    for (const Placement& placement :
         placementsOf(input_.request.type, driving_side, input_.request.turning)) {
      if (input_.request.ego_side.value_or(placement.side) != placement.side) continue;
      for (const double sign : {1.0, -1.0}) {
        if (placement.sign != 0.0 && placement.sign != sign) continue;
        const Side from = sign < 0.0 ? Side::kLeft : Side::kRight;
        if (input_.request.from_side.value_or(from) != from) continue;
        addAt(*state, contact, placement.side, headingTo(state->pose, sign), found);
      }
    }
  }

  /// Returns the direction of travel relative to the ego's heading at the contact (rad): the type's
  /// nominal one, or if the ego must turn, as nearly as the type allows along its heading at t0.
  double headingTo(const Pose2& ego, double sign) const {
    const TypeDefinition band = input_.request.bands();
    if (input_.request.turning != Turning::kEgo) return wrapAngle(sign * band.nominal_heading);
    const double turn = angleBetween(past_.ego.states.back().pose.yaw, ego.yaw);
    const double along = turn * sign < 0.0 ? std::abs(turn) : M_PI - std::abs(turn);
    const double least = band.min_heading + kArrivalHeadingMargin;
    return sign *
           std::clamp(along, least, std::max(least, band.max_heading - kArrivalHeadingMargin));
  }

  /// `heading`: rad, direction of travel relative to the ego's heading.
  void addAt(const AgentState& ego, double contact, Side side, double heading,
             std::vector<AddedVehicle>& found) {
    if (found.size() >= kMost) return;
    const BoxSize size = drawSize();
    CollisionPattern pattern;
    pattern.type = input_.request.type;
    pattern.time = past_.now + contact;
    pattern.ego = {ego.pose, past_.ego.size};
    pattern.tolerance = options_.prediction.pattern_tolerance;
    const Pose2 offset = attackerOffset(past_.ego.size, size, side, heading, 0.0, 0.0);
    pattern.attacker_offset = facing(offset);
    const Pose2 meeting = compose(ego.pose, offset);
    const std::vector<double> places = waiting_->places(meeting, size);
    if (places.empty()) return void(++reasons_["find no place beside the road"]);
    for (const double away : places) {
      const Pose2 start = compose(meeting, {-away, 0.0, 0.0});
      if (const char* reason = whyNotFrom(start, size, away, contact)) {
        ++reasons_[reason];
        continue;
      }
      Track track{newVehicleId(past_, found), waiting_->agentClass(), size, {}};
      for (const AgentState& frame : past_.ego.states) {
        track.states.push_back({frame.time, facing(start), {0.0, 0.0}});
      }
      pattern.attacker_id = track.id;
      pattern.attacker_speed = (waiting_->reverses() ? -1.0 : 1.0) * away / contact;
      found.push_back({std::move(track), ReferencePath(*walkerPath(start, meeting)), {pattern}});
      return;
    }
  }

  /// Returns the pose of the box for a pose with the direction of travel.
  Pose2 facing(const Pose2& travel) const {
    return waiting_->reverses() ? turnedRound(travel) : travel;
  }

  const char* whyNotFrom(const Pose2& start, const BoxSize& size, double away,
                         double contact) const {
    const std::optional<Range>& departure = input_.request.departure_time;
    const double duration = contact - (departure ? departure->min : 0.0);
    if (const char* reason = waiting_->whyNotFrom(start, away, duration)) return reason;
    for (int instant = traffic_.firstInstant(); instant <= 0; ++instant) {
      if (traffic_.touches(start, size, instant, kClearance)) {
        return "would have touched an agent before t0";
      }
    }
    return nullptr;
  }

  BoxSize drawSize() {
    const auto& kinds = options_.added.kinds;
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const AddedKind& each) {
      return each.agent_class == waiting_->agentClass();
    });
    return {kind->length + random_.bell(kind->length_deviation), kind->width};
  }

  Status refusal() const {
    std::string message = std::string("no ") + toString(waiting_->agentClass()) + " can be added";
    const char* sign = ": ";
    for (const auto& [reason, count] : reasons_) {
      message += sign + std::to_string(count) + " " + reason;
      sign = ", ";
    }
    return {StatusCode::kNoCandidate, message};
  }

  const AddedVehicleInput& input_;
  const AttackOptions& options_;
  const Snapshot& past_;
  std::unique_ptr<Waiting> waiting_;
  RecordedTraffic traffic_;
  Random random_;
  std::map<std::string, int> reasons_;
};

}  // namespace

AddedVehicles addFromRoadside(const AddedVehicleInput& input, const AttackOptions& options) {
  return RoadsideInsertion(input, options).run();
}

}  // namespace forge
