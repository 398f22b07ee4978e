#include "collision_forge/io/export/scenario_net.h"

#include <cmath>
#include <stdexcept>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/io/export/scenario_net_description.h"

namespace forge {
namespace {

void writeOwn(PickleWriter& own, const CrashRecord& record) {
  const SceneRequest& asked = record.scenario.asked;
  const Attack& answer = record.scenario.answer;
  own.text("scene", asked.scene);
  own.text("type", toString(asked.request.type));
  own.text("mode", toString(asked.request.mode));
  own.number("tta", asked.request.tta);
  own.count("seed", asked.request.seed);
  own.text("manoeuvre", toString(answer.report.manoeuvre));
  own.text("attacker", record.attacker.id);
  own.flag("attacker_is_added", answer.trajectory.isAdded());
  own.number("now", record.now);
  if (record.contact) {
    own.number("contact_time", *record.contact);
  } else {
    own.null("contact_time");
  }
}

PickleContent scenarioOf(const CrashRecord& record, const ExportOptions& options) {
  TrackTable table{{}, {record.ego, record.attacker}};
  for (const AgentState& state : record.ego.states) table.times.push_back(state.time);
  std::vector<Vector2> path_points;
  for (const Track& track : table.tracks) {
    for (const AgentState& state : track.states) path_points.push_back(state.pose.position());
  }
  table.tracks.insert(table.tracks.end(), record.other_agents.begin(), record.other_agents.end());
  const auto now = static_cast<std::size_t>(std::lround(record.now / record.step));
  return describe({record.name, std::move(table), record.step, now, record.lanes, record.lights,
                   [&](PickleWriter& own) { writeOwn(own, record); }},
                  path_points, options);
}

class ScenarioNetWriter : public CrashWriter {
 public:
  explicit ScenarioNetWriter(const ExportPlan& plan) : plan_(plan) {}

  std::vector<std::string> write(const CrashRecord& record) const override {
    const std::string file = scenarioNetFile(record.name);
    writeText(pathIn(plan_.folder, file), workers_.write(scenarioOf(record, plan_.options)));
    return {file};
  }

  void finish(const std::vector<ExportedCrash>& crashes) const override {
    std::vector<std::string> names;
    for (const ExportedCrash& crash : crashes) names.push_back(crash.name);
    writeScenarioNetSummary(plan_.folder, names, workers_);
  }

 private:
  ExportPlan plan_;
  mutable PickleWorkers workers_;
};

}  // namespace

std::unique_ptr<CrashWriter> makeScenarioNetWriter(const ExportPlan& plan) {
  if (plan.ego_free) {
    throw std::invalid_argument(
        "format scenarionet does not support a free ego: its tracks need a state at every step; "
        "leave out the ego's track when replaying");
  }
  return std::make_unique<ScenarioNetWriter>(plan);
}

}  // namespace forge
