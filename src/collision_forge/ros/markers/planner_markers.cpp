#include "collision_forge/ros/markers/planner_markers.h"

#include <algorithm>

#include "collision_forge/base/geometry/touch_point.h"
#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/base/scene/short_id.h"
#include "collision_forge/planner_test/trials/avoidance_words.h"
#include "collision_forge/ros/markers/label_places.h"
#include "collision_forge/ros/markers/marker_parts.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr double kWayStep = 0.5;           // s between the boxes that texts do not cover
constexpr double kProposalHeight = 4.4;    // m, below the paths
constexpr double kProposalWidth = 0.12;    // m
constexpr double kProposalDiameter = 0.5;  // m, of the disc at its end

std_msgs::Header headerAt(double time) {
  std_msgs::Header header;
  header.frame_id = names::kMapFrame;
  header.stamp = stampOf(time);
  return header;
}

std::vector<TrajectoryPoint> pointsOf(const Track& track) {
  std::vector<TrajectoryPoint> points;
  for (const AgentState& state : track.states) points.push_back({state.time, state.pose});
  return points;
}

void addProposals(const std::vector<std::vector<Pose2>>& proposals, MarkerList& markers) {
  std::vector<Vector2> lines;
  for (const std::vector<Pose2>& proposal : proposals) {
    std::vector<Vector2> way;
    for (const Pose2& pose : proposal) way.push_back(pose.position());
    if (way.empty()) continue;
    appendPolyline(way, lines);
    markers.addDisc("proposal_ends", way.back(), kProposalDiameter, kProposalHeight,
                    colors::kProposal);
  }
  markers.addLines("proposals", lines, kProposalWidth, kProposalHeight, colors::kProposal);
}

std::string words(const ShownRollout& shown, const std::string& planner) {
  const RolloutOutcome& outcome = shown.trial.outcome;
  const double now = shown.now();
  std::string text = planner;
  if (outcome.contact) {
    const PlannerContact& contact = *outcome.contact;
    text +=
        contact.is_attacker ? ": touches the attacker" : ": touches " + shortId(contact.other_id);
    text += formatted("\nafter %.2f s", contact.time - now);
    text += formatted(", impact %.1f m/s", contact.impact_speed);
    text += contact.at_fault ? "\nat fault" : "\nnot at fault";
  } else if (outcome.failure != PlannerFailure::kNone) {
    text += std::string(": fails, ") + toString(outcome.failure);
    text += formatted("\nafter %.2f s", outcome.duration);
  } else {
    text += formatted(": no contact in %.2f s", outcome.duration);
  }
  const std::optional<Avoidance>& last = shown.trial.avoidability.last;
  if (!last && outcome.failure != PlannerFailure::kNone) return text;
  if (!last) return text + "\nno evasive manoeuvre found";
  return text + "\navoidable " + avoidanceText(last->manoeuvre, last->start - now, false);
}

colors::MarkerColor colorOf(const Track& agent, const std::string& attacker_id) {
  if (agent.id == attacker_id) return colors::kAttacker;
  return colors::agentColor(static_cast<std::uint8_t>(agent.agent_class));
}

/// Returns the pose of an agent in the picture; empty if it is unknown.
std::optional<Pose2> shownPose(const Track& agent, const ShownRollout& shown, double time) {
  if (shown.crash && agent.id == shown.crash->other.id && time > shown.end()) {
    return shown.crash->motion.attackerAt(time).pose;
  }
  const Track* driven = findTrack(shown.trial.outcome.others, agent.id);
  const auto state =
      driven != nullptr ? stateAt(*driven, std::min(time, shown.end())) : stateAt(agent, time);
  if (!state) return std::nullopt;
  return state->pose;
}

OrientedBox egoBox(const ShownRollout& shown, double time) {
  const std::vector<TrajectoryPoint>& driven = shown.trial.outcome.driven;
  const Pose2 pose = shown.crash && time > shown.end()
                         ? shown.crash->motion.egoAt(time).pose
                         : stateAt({"", {}, {}, toStates(driven)},
                                   std::clamp(time, driven.front().time, driven.back().time))
                               ->pose;
  return {pose, shown.scenario.ego.size};
}

/// Returns the boxes that the text must not cover: the paths of all vehicles until they stop.
std::vector<OrientedBox> waysOf(const ShownRollout& shown) {
  std::vector<OrientedBox> ways;
  const std::vector<Track> agents = agentsFromT0(shown.scenario);
  for (double time = shown.now(); time < shown.standTime() + kWayStep; time += kWayStep) {
    ways.push_back(egoBox(shown, std::min(time, shown.standTime())));
    for (const Track& agent : agents) {
      const auto pose = shownPose(agent, shown, time);
      if (pose) ways.push_back({*pose, agent.size});
    }
  }
  return ways;
}

/// Returns the box of the outcome text, beside the place where the ego stops.
OrientedBox outcomeBox(const ShownRollout& shown, double scale) {
  const BoxSize size = textSize(words(shown, ""), scale * kWordsLetterHeight);
  const Vector2 middle = placeBeside(egoBox(shown, shown.standTime()), size, shown.words_side);
  return {{middle.x(), middle.y(), 0.0}, size};
}

/// Adds the contact, which is at the end of the rollout.
void addContactOf(const ShownRollout& shown, MarkerList& markers) {
  if (!shown.crash) return;
  const PostCrashMotion& motion = shown.crash->motion;
  const OrientedBox other{motion.attackerAt(shown.end()).pose, shown.crash->other.size};
  markers.addDisc("contact", touchPoint(egoBox(shown, shown.end()), other), kContactDiameter,
                  kContactHeight, colors::kContact);
}

}  // namespace

ShownRollout shownRollout(const PlannerTrial& trial, const CrashScenario& scenario,
                          const std::string& planner, const SeverityOptions& severity) {
  ShownRollout shown{trial, scenario, planner,
                     crashOf(trial.outcome, scenario.ego.size, scenario.recorded.agents, severity)};
  shown.words_side =
      freestSide(egoBox(shown, shown.standTime()), textSize(words(shown, ""), kWordsLetterHeight),
                 waysOf(shown), kFarRings);
  return shown;
}

visualization_msgs::MarkerArray plannerMarkers(const PlannerTrial& trial,
                                               const CrashScenario& scenario) {
  const double end = trial.outcome.driven.back().time;
  MarkerList markers(headerAt(scenario.snapshot.now));
  addPath("recorded_ego", pointsOf(scenario.recorded.ego), end, scenario.ego.size,
          colors::kRecordedEgo, markers);
  addPath("attacker", scenario.attacker.points, end, scenario.attacker.size, colors::kAttacker,
          markers);
  addProposals(trial.proposals, markers);
  addPath("ego", trial.outcome.driven, end, scenario.ego.size, colors::kEgo, markers);
  return markers.take();
}

visualization_msgs::MarkerArray rolloutMarkers(const ShownRollout& shown, double time) {
  const double instant = std::min(time, shown.standTime());
  MarkerList markers(headerAt(instant));
  markers.addBox("ego", egoBox(shown, instant), kVehicleHeight, colors::kEgo);
  const std::string& attacker_id = shown.scenario.attacker.attacker_id;
  for (const Track& agent : agentsFromT0(shown.scenario)) {
    const auto pose = shownPose(agent, shown, instant);
    if (!pose) continue;
    markers.addBox(agent.id == attacker_id ? "attacker" : "agents", {*pose, agent.size},
                   kVehicleHeight, colorOf(agent, attacker_id));
  }
  const bool is_over = time >= shown.end();
  if (is_over) addContactOf(shown, markers);
  const double scale = letterScale(rolloutArea(shown, instant));
  addWords("report",
           is_over ? words(shown, shown.planner)
                   : shown.planner + formatted(" drives, %.1f s", instant - shown.now()),
           outcomeBox(shown, scale).center.position(), scale * kWordsLetterHeight, markers);
  return markers.take();
}

ShownArea rolloutArea(const ShownRollout& shown, double time) {
  const double instant = std::min(time, shown.standTime());
  std::vector<OrientedBox> boxes{egoBox(shown, shown.standTime()), egoBox(shown, instant)};
  const Track attacker = attackerTrack(shown.scenario);
  if (const auto pose =
          shownPose(attacker, shown, std::min(instant, attacker.states.back().time))) {
    boxes.push_back({*pose, attacker.size});
  }
  const double scale = letterScale(areaAround(boxes, kCrashWidth));
  boxes.push_back(outcomeBox(shown, scale));
  return areaAround(boxes, kCrashWidth);
}

}  // namespace forge
