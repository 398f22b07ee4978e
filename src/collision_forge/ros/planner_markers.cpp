#include "collision_forge/ros/planner_markers.h"

#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/marker_parts.h"
#include "collision_forge/ros/topic_names.h"
#include "collision_forge/scene/short_id.h"

namespace forge {
namespace {

constexpr double kProposalHeight = 4.4;    // m, under the ways
constexpr double kProposalWidth = 0.12;    // m
constexpr double kProposalDiameter = 0.5;  // m, of the disc at its end
constexpr float kOthersAlpha = 0.5F;

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
  text += formatted("\navoidable up to %.1f s", last->start - now);
  return text + " by " + toString(last->manoeuvre);
}

colors::MarkerColor colorOf(const Track& agent, const std::string& attacker_id) {
  if (agent.id == attacker_id) return colors::kAttacker;
  return colors::agentColor(static_cast<std::uint8_t>(agent.agent_class));
}

/// Everybody where the test ended, and the outcome beside the ego's way.
void addEnd(const PlannerTrial& trial, const CrashScenario& scenario, const std::string& text,
            MarkerList& markers) {
  const TrajectoryPoint& end = trial.outcome.driven.back();
  const OrientedBox ego{end.pose, scenario.ego.size};
  const auto& contact = trial.outcome.contact;
  for (const Track& agent : othersFromNow(scenario)) {
    const auto state = stateAt(agent, end.time);
    if (!state) continue;
    const OrientedBox box{state->pose, agent.size};
    const colors::MarkerColor color = colorOf(agent, scenario.attacker.attacker_id);
    if (contact && contact->other_id == agent.id) {
      addContact(ego, box, color, markers);
    } else {
      markers.addSlab("others", box, kGhostHeight, colors::withAlpha(color, kOthersAlpha));
    }
  }
  if (!contact) {
    markers.addSlab("ego_at_end", ego, kPathHeight, colors::withAlpha(colors::kEgo, kContactAlpha));
  }
  addReport(text, end.pose.position(), {-end.pose.heading().y(), end.pose.heading().x()}, markers);
}

}  // namespace

visualization_msgs::MarkerArray plannerMarkers(const PlannerTrial& trial,
                                               const CrashScenario& scenario,
                                               const std::string& planner) {
  const double now = scenario.snapshot.now;
  const double end = trial.outcome.driven.back().time;
  MarkerList markers(headerAt(now));
  addWay("recorded_ego", pointsOf(scenario.recorded.ego), end, scenario.ego.size,
         colors::kRecordedEgo, markers);
  addWay("attacker", scenario.attacker.points, end, scenario.attacker.size, colors::kAttacker,
         markers);
  addProposals(trial.proposals, markers);
  addWay("ego", trial.outcome.driven, end, scenario.ego.size, colors::kEgo, markers);
  addEnd(trial, scenario, words(trial, now, planner), markers);
  return markers.take();
}

}  // namespace forge
