#include "collision_forge/planner_test/planners/planner_factory.h"

#include <stdexcept>

#include "collision_forge/planner_test/planners/idm.h"
#include "collision_forge/planner_test/planners/pdm_planner.h"
#include "collision_forge/planner_test/planners/planner_process.h"
#include "collision_forge/planner_test/planners/rule_based_planner.h"
#include "collision_forge/planner_test/planners/torchscript_planner.h"

namespace forge {
namespace {

using MakePlanner = std::unique_ptr<Planner> (*)(const PlannerOptions&, const std::string&);

struct Entry {
  const char* name;
  MakePlanner make;
  double (*interval)(const PlannerOptions&);
  bool is_exact = false;
};

const Entry kEntries[] = {
    {"idm",
     [](const PlannerOptions& options, const std::string&) -> std::unique_ptr<Planner> {
       return std::make_unique<IdmPlanner>(options.idm, options.route_centerline);
     },
     [](const PlannerOptions& options) { return options.planning.interval; }},
    {"idm_published",
     [](const PlannerOptions& options, const std::string& attacker) -> std::unique_ptr<Planner> {
       return std::make_unique<PublishedIdmPlanner>(options.published_idm, attacker);
     },
     [](const PlannerOptions& options) { return options.published_idm.step; }, true},
    {"pdm",
     [](const PlannerOptions& options, const std::string&) -> std::unique_ptr<Planner> {
       return std::make_unique<PdmPlanner>(options.pdm, options.route_centerline, options.car,
                                           options.lqr);
     },
     [](const PlannerOptions& options) { return options.planning.interval; }},
    {"rule_based",
     [](const PlannerOptions& options, const std::string&) -> std::unique_ptr<Planner> {
       return std::make_unique<RuleBasedPlanner>(options.rule_based);
     },
     [](const PlannerOptions& options) { return options.rule_based.step; }},
    {"rule_based_tuned",
     [](const PlannerOptions& options, const std::string&) -> std::unique_ptr<Planner> {
       return std::make_unique<RuleBasedPlanner>(options.tuned_rule_based);
     },
     [](const PlannerOptions& options) { return options.tuned_rule_based.step; }},
    {kExternal,
     [](const PlannerOptions& options, const std::string&) -> std::unique_ptr<Planner> {
       return std::make_unique<ProcessPlanner>(options.external);
     },
     [](const PlannerOptions& options) { return options.external.interval; }},
    {kTorchscript,
     [](const PlannerOptions& options, const std::string&) -> std::unique_ptr<Planner> {
       return std::make_unique<TorchscriptPlanner>(options.torchscript, options.route_centerline);
     },
     [](const PlannerOptions& options) { return options.torchscript.interval; }},
};

std::string knownNames() {
  std::string names;
  for (const std::string& name : plannerNames()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

const std::vector<std::string>& plannerNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    for (const Entry& entry : kEntries) found.emplace_back(entry.name);
    return found;
  }();
  return names;
}

PlannerUnderTest makePlanner(const std::string& name, const PlannerOptions& options,
                             const std::string& attacker_id) {
  for (const Entry& entry : kEntries) {
    if (name != entry.name) continue;
    return {entry.make(options, attacker_id), {entry.interval(options), entry.is_exact}};
  }
  throw std::invalid_argument("unknown planner \"" + name + "\"; known planners: " + knownNames());
}

}  // namespace forge
