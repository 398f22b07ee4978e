#include "collision_forge/io/export/crash_record.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/scene/clock.h"
#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/base/scene/support_vehicles.h"
#include "collision_forge/io/logs/nuscenes_map.h"

namespace forge {
namespace {

constexpr double kTouchDepth = 5e-3;   // m, least overlap of the boxes after contact
constexpr double kCropSpacing = 10.0;  // m between the points around which lanes are selected

bool isPlainWord(const std::string& text) {
  const auto isPlain = [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '-' || letter == '_' || letter == '.';
  };
  return !text.empty() && text.front() != '.' && std::all_of(text.begin(), text.end(), isPlain);
}

/// Adds the lanes before and after each connector of a crop: a connector without them is not a
/// valid road.
void completeConnectors(const LaneMap& map, LaneMap& crop) {
  std::unordered_map<std::string, const Lane*> lanes;
  for (const Lane& lane : map.lanes) lanes.emplace(lane.id, &lane);
  std::unordered_set<std::string> kept;
  for (const Lane& lane : crop.lanes) kept.insert(lane.id);
  for (std::size_t i = 0; i < crop.lanes.size(); ++i) {  // the list grows
    if (!crop.lanes[i].is_connector) continue;
    const Lane& whole = *lanes.at(crop.lanes[i].id);
    for (const auto* ids : {&whole.incoming, &whole.outgoing}) {
      for (const std::string& id : *ids) {
        if (kept.insert(id).second) crop.lanes.push_back(*lanes.at(id));
      }
    }
  }
  const auto is_lost = [&](const std::string& id) { return kept.count(id) == 0; };
  for (Lane& lane : crop.lanes) {
    const Lane& whole = *lanes.at(lane.id);
    lane.incoming = whole.incoming;
    lane.outgoing = whole.outgoing;
    for (auto* ids : {&lane.incoming, &lane.outgoing}) {
      ids->erase(std::remove_if(ids->begin(), ids->end(), is_lost), ids->end());
    }
  }
}

/// Builds one record.
class RecordBuilder {
 public:
  RecordBuilder(const Scenario& scenario, double history, const RecordContext& context)
      : scenario_(scenario),
        trajectory_(scenario.answer.trajectory),
        scene_(context.indexed.scene),
        context_(context),
        step_(context.options.step) {
    const double now = scenario.asked.now;
    if (!stateAt(scene_.ego, now)) {
      throw std::runtime_error("the ego has no pose in " + scene_.name +
                               " at now = " + numberText(now) + " s");
    }
    const double known = std::min(history, now - scene_.ego.states.front().time);
    now_step_ = static_cast<std::size_t>(std::floor(known / step_ + kTimeEpsilon));
    begin_ = now - static_cast<double>(now_step_) * step_;
    drive_ = {trajectory_.attacker_id, trajectory_.agent_class, trajectory_.size,
              toStates(trajectory_.points)};
    const Track* recorded = findTrack(scene_.agents, trajectory_.attacker_id);
    if (recorded && !trajectory_.isAdded()) drive_.height = recorded->height;
    findEnd();
  }

  CrashRecord build(const std::string& name) {
    CrashRecord record;
    record.name = name;
    record.scenario = scenario_;
    record.step = step_;
    record.now = timeOf(now_step_);
    if (contact_) record.contact = *contact_ - begin_;
    record.ego = egoTrack();
    record.attacker = attackerTrack();
    record.other_agents = otherTracks(record);
    addLanes(record);
    return record;
  }

 private:
  void findEnd() {
    const double last = std::min(scene_.ego.states.back().time, drive_.states.back().time);
    contact_ =
        firstContactTime(trajectory_, scene_.ego, last, context_.verification.overlap_tolerance);
    if (contact_) {
      const AgentState ego = stateAt(scene_.ego, *contact_).value();
      AgentState attacker = stateAt(drive_, *contact_).value();
      attacker.pose = overlapping(ego.pose, attacker.pose);
      crash_.emplace(CrashedVehicle{scene_.ego.agent_class, scene_.ego.size, ego},
                     CrashedVehicle{drive_.agent_class, drive_.size, attacker},
                     context_.verification.severity);
    }
    const double end = contact_ ? *contact_ + context_.options.tail : last;
    const double steps = (end - begin_) / step_;
    count_ = 1 + static_cast<std::size_t>(contact_ ? std::ceil(steps - kTimeEpsilon)
                                                   : std::floor(steps + kTimeEpsilon));
  }

  /// Returns the attacker's pose, moved towards the ego until their boxes overlap: the contact is
  /// found within a tolerance, but readers test exact boxes.
  Pose2 overlapping(const Pose2& ego, Pose2 attacker) const {
    const auto gaps = axisGaps({ego, scene_.ego.size}, {attacker, drive_.size});
    const auto widest = std::max_element(
        gaps.begin(), gaps.end(), [](const AxisGap& a, const AxisGap& b) { return a.gap < b.gap; });
    const double shift = std::max(0.0, widest->gap + kTouchDepth);
    attacker.x -= shift * widest->axis.x();
    attacker.y -= shift * widest->axis.y();
    return attacker;
  }

  /// Returns the record's time of a step, s, to the microsecond.
  double timeOf(std::size_t index) const {
    return std::round(static_cast<double>(index) * step_ * 1e6) / 1e6;
  }

  /// Returns the scene's time of a step, s.
  double sceneTime(std::size_t index) const { return begin_ + static_cast<double>(index) * step_; }

  /// Returns the states at the steps for which `at` returns one.
  template <class StateAtTime>
  Track sampled(const Track& like, const StateAtTime& at) const {
    Track track{like.id, like.agent_class, like.size, {}, like.height};
    for (std::size_t index = 0; index < count_; ++index) {
      std::optional<AgentState> state = at(sceneTime(index));
      if (!state) continue;
      state->time = timeOf(index);
      track.states.push_back(*state);
    }
    return track;
  }

  bool isAfterContact(double time) const { return contact_ && time >= *contact_ - kTimeEpsilon; }

  Track egoTrack() const {
    Track track = sampled(scene_.ego, [&](double time) -> std::optional<AgentState> {
      if (isAfterContact(time)) return crash_->egoAt(time);
      return stateAt(scene_.ego, time);
    });
    if (track.states.size() < count_) {
      throw std::runtime_error("the ego's track has a gap in " + scene_.name);
    }
    track.id = kEgoId;
    return track;
  }

  Track attackerTrack() const {
    const Track past = attackerPast(trajectory_, scene_.agents);
    const double now = scenario_.asked.now;
    Track track = sampled(drive_, [&](double time) -> std::optional<AgentState> {
      if (isAfterContact(time)) {
        AgentState state = crash_->attackerAt(time);
        // Readers test the boxes at the steps, and grazing vehicles may part within a step.
        const bool is_first_step = time < *contact_ + step_ - kTimeEpsilon;
        if (is_first_step) state.pose = overlapping(crash_->egoAt(time).pose, state.pose);
        return state;
      }
      const bool is_attacking = time >= now - kTimeEpsilon;
      return is_attacking ? stateAt(drive_, std::max(time, now)) : stateAt(past, time);
    });
    track.states = splitAtGaps(track, step_).back();
    return track;
  }

  bool isNear(const Track& track, const CrashRecord& record) const {
    const double squared = context_.options.radius * context_.options.radius;
    const auto comesNear = [&](const AgentState& state, const Track& other) {
      return std::any_of(other.states.begin(), other.states.end(), [&](const AgentState& its) {
        return (its.pose.position() - state.pose.position()).squaredNorm() <= squared;
      });
    };
    return std::any_of(track.states.begin(), track.states.end(), [&](const AgentState& state) {
      return comesNear(state, record.ego) || comesNear(state, record.attacker);
    });
  }

  std::vector<Track> otherTracks(const CrashRecord& record) const {
    std::vector<Track> others;
    for (const Track& agent : scene_.agents) {
      if (agent.id == trajectory_.attacker_id) continue;
      Track track = sampled(agent, [&](double time) { return stateAt(agent, time); });
      if (isNear(track, record)) others.push_back(std::move(track));
    }
    std::sort(others.begin(), others.end(),
              [](const Track& a, const Track& b) { return a.id < b.id; });
    return others;
  }

  void addLanes(CrashRecord& record) const {
    std::vector<Vector2> points;
    for (const Track* track : {&record.ego, &record.attacker}) {
      for (const AgentState& state : track->states) {
        const Vector2 point = state.pose.position();
        if (points.empty() || (point - points.back()).norm() > kCropSpacing)
          points.push_back(point);
      }
    }
    record.lanes = cropped(context_.indexed.lanes->map(), points, context_.options.radius);
    completeConnectors(context_.indexed.lanes->map(), record.lanes);
    for (const Lane& lane : record.lanes.lanes) {
      const auto arcs = context_.arcs.find(lane.id);
      if (arcs != context_.arcs.end()) record.arcs.insert(*arcs);
    }
    for (const TrafficLight& light : shifted(scene_.lights, -begin_)) {
      const auto& lanes = record.lanes.lanes;
      const bool is_kept = std::any_of(lanes.begin(), lanes.end(),
                                       [&](const Lane& lane) { return lane.id == light.lane; });
      if (is_kept) record.lights.push_back(light);
    }
    const auto origin = context_.options.origins.find(record.lanes.location);
    if (origin != context_.options.origins.end()) record.origin = origin->second;
  }

  const Scenario& scenario_;
  const AttackerTrajectory& trajectory_;
  const Scene& scene_;
  const RecordContext& context_;
  double step_;
  double begin_ = 0.0;  // s, scene's clock
  std::size_t now_step_ = 0;
  std::size_t count_ = 0;
  Track drive_;
  std::optional<double> contact_;         // s, scene's clock
  std::optional<PostCrashMotion> crash_;  // set with a contact
};

}  // namespace

std::vector<std::vector<AgentState>> splitAtGaps(const Track& track, double step) {
  std::vector<std::vector<AgentState>> stretches;
  for (const AgentState& state : track.states) {
    if (stretches.empty() || state.time - stretches.back().back().time > 1.5 * step) {
      stretches.emplace_back();
    }
    stretches.back().push_back(state);
  }
  return stretches;
}

CrashRecord crashRecord(const Scenario& scenario, std::size_t line, double history,
                        const RecordContext& context) {
  const std::string& scene = scenario.asked.scene;
  if (!isPlainWord(scene)) {
    throw std::runtime_error("scene = \"" + scene +
                             "\" cannot be part of a file name: use letters, digits, '-', '_' and "
                             "'.'");
  }
  const std::string name = scene + "_" + std::to_string(line);
  if (scenario.answer.supports.empty()) {
    return RecordBuilder(scenario, history, context).build(name);
  }
  IndexedScene supported = context.indexed;
  addSupports(scenario.answer.supports, supported.scene);
  const RecordContext whole{supported, context.arcs, context.options, context.verification};
  return RecordBuilder(scenario, history, whole).build(name);
}

}  // namespace forge
