#include "collision_forge/app/planner_pictures.h"

#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/io/drawing/draw_scenario.h"

namespace forge {
namespace {

/// Replaces the recorded states of `agents` by the driven ones, by id.
void show(const std::vector<Track>& driven, std::vector<Track>& agents) {
  for (Track& agent : agents) {
    if (const Track* as_driven = findTrack(driven, agent.id)) agent.states = as_driven->states;
  }
}

ScenarioView viewOf(const PlannerCase& one, const PlannerRow& row,
                    const std::vector<TrajectoryPoint>& ego, const AttackerTrajectory& attacker) {
  const CrashScenario& scenario = one.scenario;
  const PolicyKind policy = row.attacker.policy;
  const Mode mode = policy == PolicyKind::kAdaptive ? Mode::kAdaptive : one.request.mode;
  ScenarioView view{one.scene,         one.request.tta, mode,     scenario.snapshot,
                    scenario.recorded, one.pattern,     attacker, {}};
  view.planner = rowName(row);
  view.future.ego.states = toStates(ego);
  view.lights = scenario.lights;
  return view;
}

}  // namespace

ScenarioView viewOfCollision(const PlannerCase& one, const PlannerRow& row, const Config& config) {
  const CrashScenario& scenario = one.scenario;
  const RolloutOutcome& outcome = row.outcome;
  const PlannerContact& contact = *outcome.contact;
  ScenarioView view = viewOf(one, row, outcome.driven, outcome.attacker);
  show(outcome.others, view.future.agents);
  CollisionReport& report = view.report;
  report.contact = true;
  report.contact_time = contact.time;
  report.relative_heading = contact.relative_heading;
  report.ego_at_contact = outcome.driven.back().pose;
  report.attacker_at_contact = poseAt(outcome.attacker, contact.time);
  report.ego_side = contact.ego_side;
  report.attacker_side = contact.other_side;
  report.impact_speed = contact.impact_speed;
  report.severity = contact.severity;
  report.overlap = sideOverlap({report.ego_at_contact, view.future.ego.size}, report.ego_side,
                               {report.attacker_at_contact, scenario.attacker.size});
  view.crash = motionAfterContact(report, outcome.attacker, view.future.ego,
                                  config.attack.verification.severity);
  view.seconds_after_stand = config.attacked_bag.seconds_after_stand;
  return view;
}

ScenarioView viewOfEvasiveManoeuvre(const PlannerCase& one, const PlannerRow& row) {
  const Evasion& evasion = *row.evasion_drive;
  ScenarioView view =
      viewOf(one, row, wholeEvasion(row.outcome.driven, evasion.ego), evasion.attacker);
  view.avoided_hit = row.outcome.contact->time;
  return view;
}

void drawView(const std::string& path, const ScenarioView& view, const DrawingOptions& drawing) {
  drawScenarioPng(path + ".png", view, drawing);
  drawScenarioGif(path + ".gif", view, drawing);
}

}  // namespace forge
