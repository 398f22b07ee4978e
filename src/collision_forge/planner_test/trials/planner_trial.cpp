#include "collision_forge/planner_test/trials/planner_trial.h"

#include <algorithm>
#include <chrono>

#include "collision_forge/planner_test/trials/evasion.h"

namespace forge {
namespace {

/// Forwards calls to a planner and measures their time.
class WatchedPlanner : public Planner {
 public:
  explicit WatchedPlanner(Planner& planner) : planner_(planner) {}

  void initialize(const DrivingTask& task) override { planner_.initialize(task); }

  std::vector<TrajectoryPoint> plan(const Observation& observation) override {
    const auto start = std::chrono::steady_clock::now();
    std::vector<TrajectoryPoint> points = planner_.plan(observation);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    sum_ += elapsed.count();
    max_ = std::max(max_, elapsed.count());
    ++calls_;
    proposals_ = planner_.proposals();
    return points;
  }

  void report(PlannerTrial& trial) {
    trial.proposals = std::move(proposals_);
    trial.mean_call = calls_ > 0 ? sum_ / calls_ : 0.0;
    trial.max_call = max_;
  }

 private:
  Planner& planner_;
  double sum_ = 0.0;  // s
  double max_ = 0.0;  // s
  int calls_ = 0;     // successful ones
  std::vector<std::vector<Pose2>> proposals_;
};

/// Returns the avoidability of a rollout against an adaptive attacker.
Avoidability avoidabilityOf(const RolloutOutcome& outcome, const CrashScenario& scenario,
                            const RolloutSetup& setup) {
  Avoidability found;
  if (outcome.contact) {
    if (auto evasion = findEvasion(scenario, outcome.driven, setup)) found.last = evasion->ego;
  } else if (outcome.failure == PlannerFailure::kNone) {
    found.last = Avoidance{EvasiveManoeuvre::kKeeping, scenario.snapshot.now, outcome.driven,
                           outcome.off_road_share};
  }
  return found;
}

}  // namespace

PlannerTrial tryPlanner(Planner& planner, const Driving& driving, const CrashScenario& scenario,
                        const RolloutSetup& setup) {
  PlannerTrial trial;
  WatchedPlanner watched(planner);
  trial.outcome = rollout(watched, driving, scenario, setup);
  watched.report(trial);
  trial.avoidability = setup.attacker
                           ? avoidabilityOf(trial.outcome, scenario, setup)
                           : findAvoidability(scenario, setup.planners.avoidability,
                                              setup.planners.planning.route, setup.attack);
  return trial;
}

}  // namespace forge
