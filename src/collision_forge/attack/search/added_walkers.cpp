#include "collision_forge/attack/search/added_walkers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/placement.h"
#include "collision_forge/attack/search/recorded_traffic.h"
#include "collision_forge/attack/search/walker_path.h"
#include "collision_forge/attack/verify/step_out.h"

namespace forge {
namespace {

constexpr double kInterval = 0.2;     // s between the instants at which the walker touches nobody
constexpr double kClearance = 0.3;    // m to recorded agents while it waits
constexpr double kSearchStep = 0.25;  // m between the places that are tried from the meeting out
constexpr double kNearest = 1.5;      // m from the meeting
constexpr double kFarthest = 18.0;    // m; a runner gets that far in the longest time to attack
constexpr double kFromKerb[] = {0.7, 1.5, 2.5};   // m that it waits behind the edge of the road
constexpr double kContacts[] = {0.0, -0.3, 0.3};  // s, added to the requested time
constexpr std::size_t kMost = 8;                  // walkers that are searched

class WalkerInsertion {
 public:
  WalkerInsertion(const AddedVehicleInput& input, const AttackOptions& options)
      : input_(input),
        options_(options),
        past_(input.known()),
        agent_class_(input.request.attacker_class.value_or(AgentClass::kPedestrian)),
        traffic_(past_, input.future, input.request.tta, kInterval),
        random_(input.request.seed) {}

  AddedVehicles run() {
    AddedVehicles walkers;
    if (!input_.past) {
      walkers.status = {StatusCode::kNoCandidate,
                        std::string("no ") + toString(agent_class_) +
                            " can be added live: the ego has seen the roadside"};
      return walkers;
    }
    for (const Track* ego : egos()) {
      for (const double early : kContacts) addFor(*ego, input_.request.tta + early, walkers.found);
    }
    if (walkers.found.empty()) walkers.status = refusal();
    return walkers;
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
    const double nominal = input_.request.bands().nominal_heading;
    const DrivingSide driving_side = input_.lanes.map().driving_side;
    for (const Placement& placement :
         placementsOf(input_.request.type, driving_side, input_.request.turning)) {
      if (input_.request.ego_side.value_or(placement.side) != placement.side) continue;
      for (const double sign : {1.0, -1.0}) {
        if (placement.sign != 0.0 && placement.sign != sign) continue;
        addAt(*state, contact, placement.side, wrapAngle(sign * nominal), found);
      }
    }
  }

  void addAt(const AgentState& ego, double contact, Side side, double heading,
             std::vector<AddedVehicle>& found) {
    if (found.size() >= kMost) return;
    const BoxSize size = drawSize();
    CollisionPattern pattern;
    pattern.type = input_.request.type;
    pattern.time = past_.now + contact;
    pattern.ego = {ego.pose, past_.ego.size};
    pattern.attacker_offset = attackerOffset(past_.ego.size, size, side, heading, 0.0, 0.0);
    pattern.tolerance = options_.prediction.pattern_tolerance;
    const Pose2 meeting = compose(ego.pose, pattern.attacker_offset);
    const auto edge = roadEdge(meeting);
    if (!edge) return void(++reasons_["find no roadside"]);
    for (const double behind : kFromKerb) {
      const double away = *edge + behind;
      const Pose2 start = compose(meeting, {-away, 0.0, 0.0});
      if (const char* reason = whyNotFrom(start, size, away, contact)) {
        ++reasons_[reason];
        continue;
      }
      Track track{newVehicleId(past_, found), agent_class_, size, {}};
      for (const AgentState& frame : past_.ego.states) {
        track.states.push_back({frame.time, start, {0.0, 0.0}});
      }
      pattern.attacker_id = track.id;
      pattern.attacker_speed = away / contact;
      found.push_back({std::move(track), ReferencePath(*walkerPath(start, meeting)), {pattern}});
      return;
    }
  }

  /// Returns m from the meeting back to the edge of the road, or 0 if the meeting is beside it.
  std::optional<double> roadEdge(const Pose2& meeting) const {
    for (double away = 0.0; away < kFarthest; away += kSearchStep) {
      const Vector2 place = compose(meeting, {-away, 0.0, 0.0}).position();
      if (!input_.lanes.drivable().contains(place)) return std::max(away, kNearest);
    }
    return std::nullopt;
  }

  const char* whyNotFrom(const Pose2& start, const BoxSize& size, double away,
                         double contact) const {
    const std::optional<Range>& departure = input_.request.departure_time;
    const double duration = contact - (departure ? departure->min : 0.0);
    if (away > gaitOf(agent_class_).fastest_mean * duration) return "would have to run too fast";
    if (!isWherePeopleWalk(start.position(), input_.lanes)) return "would wait where nobody walks";
    if (input_.lanes.drivable().contains(start.position())) return "would wait in the road";
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
      return each.agent_class == agent_class_;
    });
    return {kind->length + random_.bell(kind->length_deviation), kind->width};
  }

  Status refusal() const {
    std::string message = std::string("no ") + toString(agent_class_) + " can be added";
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
  AgentClass agent_class_;
  RecordedTraffic traffic_;
  Random random_;
  std::map<std::string, int> reasons_;
};

}  // namespace

AddedVehicles addWalkers(const AddedVehicleInput& input, const AttackOptions& options) {
  return WalkerInsertion(input, options).run();
}

}  // namespace forge
