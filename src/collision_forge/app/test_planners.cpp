#include <algorithm>
#include <boost/timer/progress_display.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "collision_forge/app/evaluation.h"
#include "collision_forge/app/tool_support.h"
#include "collision_forge/batch/dispatch.h"
#include "collision_forge/data/collide_set.h"
#include "collision_forge/drawing/draw_scenario.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/planners/planner_factory.h"
#include "collision_forge/settings/config_fingerprint.h"
#include "collision_forge/trials/planner_cases.h"
#include "collision_forge/trials/planner_report.h"
#include "collision_forge/trials/planner_result_lines.h"

namespace {

using namespace forge;

namespace fs = std::filesystem;

struct Arguments {
  std::string dataroot;
  std::string version;
  std::vector<std::string> scenarios;
  std::string collide;
  std::string split = "val";
  ClipAttacker attacker = ClipAttacker::kRecorded;
  std::size_t limit = 0;
  std::vector<std::string> planners = {"idm", "rule_based", "pdm"};
  Background background = Background::kReplay;
  std::size_t worst = 3;
  std::string out;
  std::string config;
  int jobs = defaultJobs();
};

std::unique_ptr<PlannerCases> openCases(const Arguments& arguments, const Config& config) {
  if (arguments.collide.empty()) {
    return openScenarioCases(arguments.scenarios, arguments.dataroot, arguments.version,
                             static_cast<std::size_t>(arguments.jobs) + 1, config);
  }
  std::vector<std::string> paths = listCollideClips(arguments.collide, arguments.split);
  if (arguments.limit > 0 && arguments.limit < paths.size()) paths.resize(arguments.limit);
  return openClipCases(paths, arguments.dataroot, arguments.attacker, config);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

/// What the results depend on, for the resumption of the run.
ResumableFile::Options runOptions(const Arguments& arguments, const PlannerCases& cases,
                                  const Config& config) {
  ResumableFile::Options options = fingerprintsOf(config, arguments.config);
  options["dataroot"] = fs::canonical(arguments.dataroot).string();
  options["version"] = arguments.version;
  options["cases"] = cases.fingerprint();
  options["planners"] = joined(arguments.planners);
  options["background"] = arguments.background == Background::kIdm ? "idm" : "replay";
  return options;
}

/// How long the planners computed in this process.
class PlanningTimes {
 public:
  void add(const PlannerTestResult& result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const PlannerRow& row : result.rows) {
      Sum& sum = sums_[row.planner];
      sum.seconds += row.outcome.planning_seconds;
      sum.calls += row.outcome.plans;
    }
  }

  void print() const {
    for (const auto& [planner, sum] : sums_) {
      if (sum.calls == 0) continue;
      std::printf("%s: %.3f ms a call, mean of %ld calls in this process\n", planner.c_str(),
                  1e3 * sum.seconds / static_cast<double>(sum.calls), sum.calls);
    }
  }

 private:
  struct Sum {
    double seconds = 0.0;
    long calls = 0;
  };
  std::mutex mutex_;
  std::map<std::string, Sum> sums_;
};

std::string csvOf(const std::vector<PlannerTestResult>& results) {
  std::string text = plannerResultCsvHeader() + "\n";
  for (const PlannerTestResult& result : results) {
    for (const std::string& row : plannerResultCsvRows(result)) text += row + "\n";
  }
  return text;
}

void report(const std::vector<PlannerTestResult>& results, const Arguments& arguments,
            const Config& config) {
  const StatisticsOptions& statistics = config.evaluation.statistics;
  std::string text =
      reportTitle("Planners in closed loop", statistics) + "\n" + describeCases(results);
  std::string csv = rateCsvHeader() + "\n";
  for (const PlannerTable& entry : plannerTables(results, arguments.planners, statistics)) {
    text += "\n" + toMarkdown(entry.table, entry.unit);
    csv += toCsv(entry.table);
    if (entry.table.measure.is_headline) {
      drawTable(entry.table, "closed loop", arguments.out, config.drawing);
    }
  }
  writeText(arguments.out + "/results.csv", csvOf(results));
  writeText(arguments.out + "/table.csv", csv);
  writeText(arguments.out + "/table.md", text);
  std::cout << text;
}

/// The rollout again, as a picture: the ego is the planner's.
ScenarioView viewOf(const PlannerCase& one, const RolloutOutcome& outcome,
                    const VerificationOptions& verification) {
  const CrashScenario& scenario = one.scenario;
  const PlannerContact& contact = *outcome.contact;
  ScenarioView view{one.scene,         one.request.tta, one.request.mode,  scenario.snapshot,
                    scenario.recorded, one.pattern,     scenario.attacker, {}};
  view.contact_alone = true;
  view.future.ego.states.clear();
  for (const TrajectoryPoint& point : outcome.driven) {
    view.future.ego.states.push_back({point.time, point.pose, point.speed * point.pose.heading()});
  }
  CollisionReport& report = view.report;
  report.contact = true;
  report.contact_time = contact.time;
  report.relative_heading = contact.relative_heading;
  report.ego_at_contact = outcome.driven.back().pose;
  report.attacker_at_contact = stateAt(attackerTrack(scenario), contact.time)->pose;
  report.ego_side = contact.ego_side;
  report.attacker_side = contact.other_side;
  report.impact_speed = contact.impact_speed;
  report.type_kept = contact.type == one.request.type;
  report.on_time = std::abs(contact.time - scenario.snapshot.now - one.request.tta) <=
                   verification.time_tolerance;
  return view;
}

void drawWorst(const PlannerCases& cases, const std::vector<PlannerTestResult>& results,
               const Arguments& arguments, const Config& config) {
  const fs::path folder = fs::path(arguments.out) / "worst";
  fs::create_directories(folder);
  std::map<std::string, int> ranks;
  for (const WorstCase& worst : worstCases(results, arguments.planners, arguments.worst)) {
    const PlannerCase one = cases.at(worst.result);
    const PlannerUnderTest made =
        makePlanner(worst.planner, config.planners, one.scenario.attacker.attacker_id);
    const RolloutOutcome outcome = rollout(*made.planner, made.driving, one.scenario,
                                           {config.planners, config.attack, arguments.background});
    const ScenarioView view = viewOf(one, outcome, config.attack.verification);
    const std::string name =
        (folder / (worst.planner + "_" + std::to_string(++ranks[worst.planner]))).string();
    drawScenarioPng(name + ".png", view, config.drawing);
    drawScenarioGif(name + ".gif", view, config.drawing);
  }
}

/// Throws where there is nothing to report on.
void checkTested(const std::vector<PlannerTestResult>& results, const std::string& path) {
  const auto isTested = [](const PlannerTestResult& result) { return result.isTested(); };
  if (std::any_of(results.begin(), results.end(), isTested)) return;
  const PlannerTestResult& first = results.front();
  throw std::runtime_error(path + ": none of the cases could be tested (" +
                           std::to_string(results.size()) + "); the first, " + first.name + ": " +
                           first.status + ": " + first.message);
}

int run(const Arguments& arguments) {
  const bool is_master = isMaster();
  const Config config = loadConfig(arguments.config);
  const auto cases = openCases(arguments, config);
  const std::string results = (fs::path(arguments.out) / "results.jsonl").string();
  std::unique_ptr<PlannerResultLines> lines;
  if (is_master) {
    fs::create_directories(arguments.out);
    lines = std::make_unique<PlannerResultLines>(results, runOptions(arguments, *cases, config),
                                                 cases->names());
  }
  PlanningTimes times;
  const auto work = [&](std::size_t index) {
    const PlannerTestResult result = testCase(*cases, index, [&](const PlannerCase& one) {
      return testPlanners(one, arguments.planners, arguments.background, config);
    });
    times.add(result);
    return plannerResultLine(result);
  };
  std::unique_ptr<boost::timer::progress_display> bar;
  if (is_master) {
    bar = std::make_unique<boost::timer::progress_display>(cases->names().size(), std::cerr);
    *bar += lines->first();
  }
  const auto take = [&](std::size_t, const std::string& line) {
    lines->take(line);
    ++*bar;
  };
  dispatch(cases->names().size(), work, take, {arguments.jobs, is_master ? lines->first() : 0});
  if (!is_master) return kExitOk;
  lines->complete();
  checkTested(lines->results(), results);
  report(lines->results(), arguments, config);
  times.print();
  drawWorst(*cases, lines->results(), arguments, config);
  return kExitOk;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Drives planners through generated crashes; goes on where a run stopped.",
               "test_planners");
  app.add_option("--dataroot", arguments.dataroot, "folder with the version and maps/expansion")
      ->required()
      ->check(CLI::ExistingDirectory);
  CLI::Option* version =
      app.add_option("--version", arguments.version, "folder of the tables, as v1.0-mini");
  CLI::Option* scenarios =
      app.add_option("--scenarios", arguments.scenarios, "scenario files of generate")
          ->needs(version);
  CLI::Option* collide =
      app.add_option("--collide", arguments.collide, "folder of COLLIDE, instead of scenarios")
          ->excludes(scenarios);
  app.add_option("--split", arguments.split, "of COLLIDE: train or val")
      ->capture_default_str()
      ->needs(collide);
  app.add_option("--attacker", arguments.attacker,
                 "in COLLIDE's clips: recorded (the set's), or ours in history or replay mode")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, ClipAttacker>{{"recorded", ClipAttacker::kRecorded},
                                              {"history", ClipAttacker::kHistory},
                                              {"replay", ClipAttacker::kReplay}}))
      ->default_str("recorded")
      ->needs(collide);
  app.add_option("--limit", arguments.limit, "of COLLIDE: the first clips alone")->needs(collide);
  app.add_option("--planners", arguments.planners, "names, separated by commas")
      ->delimiter(',')
      ->check(CLI::IsMember(plannerNames()))
      ->capture_default_str();
  app.add_option("--background", arguments.background,
                 "the others: replay, or idm (they brake for who is in their way)")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Background>{
          {"replay", Background::kReplay}, {"idm", Background::kIdm}}))
      ->default_str("replay");
  app.add_option("--worst", arguments.worst, "pictures a planner, of the hardest impacts")
      ->capture_default_str();
  app.add_option("--out", arguments.out, "folder to write; see docs/planners.md")->required();
  app.add_option("--jobs", arguments.jobs, "cases at a time, in every rank of mpirun")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  addConfigOption(app, arguments.config);
  app.callback([&] {
    if (scenarios->count() + collide->count() == 0) {
      throw CLI::RequiredError("--scenarios or --collide");
    }
  });
  return runTool(app, argc, argv, [&] { return run(arguments); });
}
