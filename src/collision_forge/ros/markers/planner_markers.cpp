#include "collision_forge/ros/markers/planner_markers.h"

#include <algorithm>

#include "collision_forge/base/geometry/touch_point.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/base/scene/short_id.h"
#include "collision_forge/planner_test/trials/avoidance_words.h"
#include "collision_forge/ros/markers/label_places.h"
#include "collision_forge/ros/markers/marker_parts.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr double kProposalHeight = 4.4;    // m, under the ways
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

std::string words(const PlannerTrial& trial, double now, const std::string& planner) {
  const RolloutOutcome& outcome = trial.outcome;
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
  const std::optional<Avoidance>& last = trial.avoidability.last;
  if (!last && outcome.failure != PlannerFailure::kNone) return text;
  if (!last) return text + "\nno way to avoid it was found";
  return text + "\navoidable " + avoidanceWords(last->manoeuvre, last->start - now, false);
}

colors::MarkerColor colorOf(const Track& agent, const std::string& attacker_id) {
  if (agent.id == attacker_id) return colors::kAttacker;
  return colors::agentColor(static_cast<std::uint8_t>(agent.agent_class));
}

/// The attacker first, then the others: as they drove if they react, else as recorded.
std::vector<Track> agentsOf(const PlannerTrial& trial, const CrashScenario& scenario) {
  std::vector<Track> agents = othersFromNow(scenario);
  for (Track& agent : agents) {
    for (const Track& driven : trial.outcome.others) {
      if (driven.id == agent.id) agent = driven;
    }
  }
  return agents;
}

Pose2 poseAt(const std::vector<TrajectoryPoint>& points, double time) {
  return stateAt({"", {}, {}, toStates(points)},
                 std::clamp(time, points.front().time, points.back().time))
      ->pose;
}

double endOf(const PlannerTrial& trial) { return trial.outcome.driven.back().time; }

/// What the outcome in words fills: on the side of the ego's end that leaves both ways free.
OrientedBox outcomeBox(const PlannerTrial& trial, const CrashScenario& scenario, double scale) {
  std::vector<OrientedBox> ways;
  for (const TrajectoryPoint& point : trial.outcome.driven) {
    ways.push_back({point.pose, scenario.ego.size});
  }
  for (const TrajectoryPoint& point : scenario.attacker.points) {
    if (point.time <= endOf(trial)) ways.push_back({point.pose, scenario.attacker.size});
  }
  const OrientedBox ego{trial.outcome.driven.back().pose, scenario.ego.size};
  const std::string text = words(trial, scenario.snapshot.now, "");
  const LabelSide side = freestSide(ego, textSize(text, kWordsLetterHeight), ways);
  const BoxSize size = textSize(text, scale * kWordsLetterHeight);
  const Vector2 middle = placeBeside(ego, size, side);
  return {{middle.x(), middle.y(), 0.0}, size};
}

/// At the end of the rollout.
void addContactOf(const PlannerTrial& trial, const OrientedBox& ego,
                  const std::vector<Track>& agents, MarkerList& markers) {
  if (!trial.outcome.contact) return;
  for (const Track& agent : agents) {
    const auto state = stateAt(agent, endOf(trial));
    if (!state || agent.id != trial.outcome.contact->other_id) continue;
    markers.addDisc("contact", touchPoint(ego, {state->pose, agent.size}), kContactDiameter,
                    kContactHeight, colors::kContact);
  }
}

}  // namespace

visualization_msgs::MarkerArray plannerMarkers(const PlannerTrial& trial,
                                               const CrashScenario& scenario) {
  const double end = endOf(trial);
  MarkerList markers(headerAt(scenario.snapshot.now));
  addWay("recorded_ego", pointsOf(scenario.recorded.ego), end, scenario.ego.size,
         colors::kRecordedEgo, markers);
  addWay("attacker", scenario.attacker.points, end, scenario.attacker.size, colors::kAttacker,
         markers);
  addProposals(trial.proposals, markers);
  addWay("ego", trial.outcome.driven, end, scenario.ego.size, colors::kEgo, markers);
  return markers.take();
}

visualization_msgs::MarkerArray rolloutMarkers(const PlannerTrial& trial,
                                               const CrashScenario& scenario,
                                               const std::string& planner, double time) {
  const double now = scenario.snapshot.now;
  const double shown = std::min(time, endOf(trial));
  MarkerList markers(headerAt(shown));
  const OrientedBox ego{poseAt(trial.outcome.driven, shown), scenario.ego.size};
  markers.addBox("ego", ego, kVehicleHeight, colors::kEgo);
  const std::vector<Track> agents = agentsOf(trial, scenario);
  for (const Track& agent : agents) {
    const auto state = stateAt(agent, shown);
    if (!state) continue;
    const bool attacks = agent.id == scenario.attacker.attacker_id;
    markers.addBox(attacks ? "attacker" : "agents", {state->pose, agent.size}, kVehicleHeight,
                   colorOf(agent, scenario.attacker.attacker_id));
  }
  const bool is_over = shown == endOf(trial);
  if (is_over) addContactOf(trial, ego, agents, markers);
  const double scale = letterScale(rolloutArea(trial, scenario, shown));
  addWords(
      "report",
      is_over ? words(trial, now, planner) : planner + formatted(" drives, %.1f s", shown - now),
      outcomeBox(trial, scenario, scale).center.position(), scale * kWordsLetterHeight, markers);
  return markers.take();
}

ShownArea rolloutArea(const PlannerTrial& trial, const CrashScenario& scenario, double time) {
  const double shown = std::min(time, endOf(trial));
  std::vector<OrientedBox> boxes{{trial.outcome.driven.back().pose, scenario.ego.size},
                                 {poseAt(trial.outcome.driven, shown), scenario.ego.size}};
  boxes.push_back({poseAt(scenario.attacker.points, shown), scenario.attacker.size});
  const double scale = letterScale(areaAround(boxes, kCrashWidth));
  boxes.push_back(outcomeBox(trial, scenario, scale));
  return areaAround(boxes, kCrashWidth);
}

}  // namespace forge
