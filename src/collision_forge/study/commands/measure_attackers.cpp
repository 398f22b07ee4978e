#include <array>
#include <iostream>
#include <sstream>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/run_config.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/attacker_stress.h"
#include "collision_forge/planner_test/trials/planner_cases.h"
#include "collision_forge/planner_test/trials/planner_result.h"
#include "collision_forge/study/commands/study_commands.h"

namespace forge {
namespace {

struct Arguments {
  LogSource logs;
  std::vector<std::string> scenarios;
  ConfigFolder config;
  std::size_t drives = 20;
  std::uint64_t seed = 0;
  int jobs = defaultJobs();
};

/// Counts the outcomes of the attackers for one behaviour of the ego.
struct Tally {
  int drives = 0;
  int broken = 0;   ///< drives in which a limit was broken
  int touched = 0;  ///< drives in which another agent was touched
  int hits = 0;     ///< drives in which the ego was touched
  int aborted = 0;  ///< drives that ended as normal traffic, aborted or after the attack
};

using Tallies = std::array<Tally, kEgoConducts.size()>;

/// Runs all drives of one case. Returns one line: the five counts of each behaviour, then the
/// broken limits, each preceded by a tab.
std::string stressCase(const PlannerCases& cases, std::size_t index, const Arguments& arguments,
                       const PredictionModels& models, const Config& config) {
  const PlannerCase one = cases.at(index);
  Tallies tallies;
  std::string broken;
  const bool is_tested = one.status.code == StatusCode::kOk;
  for (std::size_t i = 0; is_tested && i < arguments.drives; ++i) {
    const std::size_t kind = i % kEgoConducts.size();
    const auto attacker = makeAttacker(one, PolicyKind::kAdaptive, models, config);
    const StressOutcome outcome =
        stressAttacker(one.scenario, one.request, kEgoConducts[kind],
                       arguments.seed + index * arguments.drives + i,
                       {config.planners, config.attack, config.crash.types, Background::kReplay,
                        false, attacker.get()});
    Tally& tally = tallies[kind];
    ++tally.drives;
    tally.broken += !outcome.broken_limit.empty();
    tally.touched += !outcome.touched.empty();
    tally.hits += outcome.touches_ego;
    tally.aborted += outcome.phase == AttackerPhase::kDrivingOn;
    if (!outcome.broken_limit.empty()) {
      broken += "\t" + one.name + ", drive " + std::to_string(i) + ": " + outcome.broken_limit;
    }
  }
  std::string line;
  for (const Tally& tally : tallies) {
    for (const int count : {tally.drives, tally.broken, tally.touched, tally.hits, tally.aborted}) {
      line += std::to_string(count) + " ";
    }
  }
  return line + broken;
}

/// Parses a line of stressCase() and adds it to the sums.
void add(const std::string& line, Tallies& sums, std::string& broken) {
  const std::size_t end = line.find('\t');
  std::istringstream numbers(line.substr(0, end));
  for (Tally& sum : sums) {
    Tally tally;
    numbers >> tally.drives >> tally.broken >> tally.touched >> tally.hits >> tally.aborted;
    sum.drives += tally.drives;
    sum.broken += tally.broken;
    sum.touched += tally.touched;
    sum.hits += tally.hits;
    sum.aborted += tally.aborted;
  }
  if (end == std::string::npos) return;
  for (const char letter : line.substr(end)) broken += letter == '\t' ? '\n' : letter;
}

void print(const Tallies& tallies, const std::string& broken) {
  std::cout << "| ego behaviour | drives | limit broken | touched another agent | touched the ego "
               "| aborted or finished |\n|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const Tally& tally = tallies[i];
    std::cout << "| " << toString(kEgoConducts[i]) << " | " << tally.drives << " | " << tally.broken
              << " | " << tally.touched << " | " << tally.hits << " | " << tally.aborted << " |\n";
  }
  std::cout << broken << (broken.empty() ? "" : "\n");
}

int measure(const Arguments& arguments) {
  const Config config = loadRunConfig(arguments.config);
  const PredictionModels models = loadPredictionModels(config);
  const auto cases =
      openScenarioCases(arguments.scenarios, arguments.logs,
                        static_cast<std::size_t>(arguments.jobs) + 1, config, showReading());
  Tallies tallies;
  std::string broken;
  ProgressLine progress("cases");
  const std::size_t count = cases->names().size();
  const bool is_master = isMaster();
  dispatch(
      count,
      [&](std::size_t index) { return stressCase(*cases, index, arguments, models, config); },
      [&](std::size_t index, const std::string& line) {
        add(line, tallies, broken);
        progress.show(index + 1, count);
      },
      {arguments.jobs, 0});
  if (is_master) print(tallies, broken);
  return kExitOk;
}

}  // namespace

void addMeasureAttackers(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(
      kMeasuring, "study measure attackers",
      "Stress-tests adaptive attackers: the ego evades, stops, reverses, jumps or vanishes at a "
      "random instant; reports whether attackers keep their limits.",
      [arguments] { return measure(*arguments); });
  addSource(app, arguments->logs)->required();
  app.add_option("--scenarios", arguments->scenarios, "scenario files of forge generate")
      ->required();
  app.add_option("--drives", arguments->drives,
                 "drives per scenario, the five behaviours of the ego in turn")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addSeed(app, arguments->seed, "random seed of the instants and the evasive manoeuvres");
  addJobs(app, arguments->jobs, "scenarios tested in parallel on each MPI rank");
  addConfig(app, arguments->config);
}

}  // namespace forge
