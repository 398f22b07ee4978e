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

/// What became of the attackers of a conduct of the ego.
struct Tally {
  int drives = 0;
  int broken = 0;
  int touched = 0;
  int hits = 0;
  int gave_up = 0;
};

using Tallies = std::array<Tally, kEgoConducts.size()>;

/// Of one case a line: five numbers a conduct, then, each after a tab, the limits that were broken.
std::string driveCase(const PlannerCases& cases, std::size_t index, const Arguments& arguments,
                      const Foresight& foresight, const Config& config) {
  const PlannerCase one = cases.at(index);
  Tallies tallies;
  std::string broken;
  const bool is_tested = one.status.code == StatusCode::kOk;
  for (std::size_t i = 0; is_tested && i < arguments.drives; ++i) {
    const std::size_t kind = i % kEgoConducts.size();
    const auto attacker = makeAttacker(one, PolicyKind::kAdaptive, foresight, config);
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
    tally.gave_up += outcome.phase == AttackerPhase::kDrivingOn;
    if (!outcome.broken_limit.empty()) {
      broken += "\t" + one.name + ", drive " + std::to_string(i) + ": " + outcome.broken_limit;
    }
  }
  std::string line;
  for (const Tally& tally : tallies) {
    for (const int count : {tally.drives, tally.broken, tally.touched, tally.hits, tally.gave_up}) {
      line += std::to_string(count) + " ";
    }
  }
  return line + broken;
}

/// Adds what driveCase() returned.
void add(const std::string& line, Tallies& sums, std::string& broken) {
  const std::size_t end = line.find('\t');
  std::istringstream numbers(line.substr(0, end));
  for (Tally& sum : sums) {
    Tally tally;
    numbers >> tally.drives >> tally.broken >> tally.touched >> tally.hits >> tally.gave_up;
    sum.drives += tally.drives;
    sum.broken += tally.broken;
    sum.touched += tally.touched;
    sum.hits += tally.hits;
    sum.gave_up += tally.gave_up;
  }
  if (end == std::string::npos) return;
  for (const char letter : line.substr(end)) broken += letter == '\t' ? '\n' : letter;
}

void print(const Tallies& tallies, const std::string& broken) {
  std::cout << "| the ego | drives | limit broken | touched somebody else | touched the ego | gave "
               "up, or was done |\n|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const Tally& tally = tallies[i];
    std::cout << "| " << toString(kEgoConducts[i]) << " | " << tally.drives << " | " << tally.broken
              << " | " << tally.touched << " | " << tally.hits << " | " << tally.gave_up << " |\n";
  }
  std::cout << broken << (broken.empty() ? "" : "\n");
}

int measure(const Arguments& arguments) {
  const Config config = loadRunConfig(arguments.config);
  const Foresight foresight = loadForesight(config);
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
      [&](std::size_t index) { return driveCase(*cases, index, arguments, foresight, config); },
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
      "Drives attackers that see and react against egos that evade, stop, reverse, jump or vanish "
      "at a random instant, and tells whether they keep their limits.",
      [arguments] { return measure(*arguments); });
  addSource(app, arguments->logs)->required();
  app.add_option("--scenarios", arguments->scenarios, "scenario files of forge generate")
      ->required();
  app.add_option("--drives", arguments->drives, "drives a scenario, of the five kinds in turn")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addSeed(app, arguments->seed, "of the instants and the evasions");
  addJobs(app, arguments->jobs, "scenarios at a time, in every rank of mpirun");
  addConfig(app, arguments->config);
}

}  // namespace forge
