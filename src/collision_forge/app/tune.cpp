#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/evaluation.h"
#include "collision_forge/app/options.h"
#include "collision_forge/batch/dispatch.h"
#include "collision_forge/batch/progress_line.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/files/resumable_file.h"
#include "collision_forge/planners/planner_factory.h"
#include "collision_forge/settings/config_fingerprint.h"
#include "collision_forge/trials/planner_cases.h"
#include "collision_forge/trials/planner_report.h"
#include "collision_forge/trials/planner_result_lines.h"
#include "collision_forge/trials/planner_tuning.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string planner = "pdm";
  std::string grid;
  std::vector<std::string> train;
  std::vector<std::string> test;
  std::string dataroot;
  std::string version;
  Background background = Background::kReplay;
  std::string out;
  std::string config;
  int jobs = defaultJobs();
};

/// The planners.yaml that is tuned.
struct PlannersFile {
  std::string path;
  std::string text;
};

PlannersFile readPlannersFile(const std::string& config) {
  PlannersFile file{config + "/planners.yaml", ""};
  std::ifstream stream(file.path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) throw std::runtime_error(file.path + ": cannot be read");
  file.text = content.str();
  return file;
}

/// One of the two lists of scenarios, with its results on the master.
class Part {
 public:
  Part(const std::string& name, const std::vector<std::string>& paths, const Arguments& arguments,
       const Config& config)
      : name_(name),
        cases_(openScenarioCases(paths, arguments.dataroot, arguments.version,
                                 static_cast<std::size_t>(arguments.jobs) + 1, config)) {}

  void open(const std::string& folder, ResumableFile::Options options) {
    options[name_] = cases_->fingerprint();
    lines_ = std::make_unique<PlannerResultLines>((fs::path(folder) / (name_ + ".jsonl")).string(),
                                                  options, cases_->names());
  }

  const PlannerCases& cases() const { return *cases_; }
  std::string fingerprint() const { return cases_->fingerprint(); }
  std::size_t size() const { return cases_->names().size(); }
  std::size_t first() const { return lines_->first(); }
  const std::vector<PlannerTestResult>& results() const { return lines_->results(); }
  void complete() { lines_->complete(); }

  void take(const std::string& line) {
    lines_->take(line);
    const auto done = static_cast<double>(lines_->results().size());
    if (!progress_) progress_.emplace(name_);  // its clock starts with the part
    progress_->show(done / static_cast<double>(size()));
  }

 private:
  std::string name_;
  std::unique_ptr<PlannerCases> cases_;
  std::unique_ptr<PlannerResultLines> lines_;
  std::optional<ProgressLine> progress_;
};

/// Everything that every rank works with.
struct Tuning {
  const Arguments& arguments;
  const Config& config;
  const PlannersFile file;
  const std::vector<PlannerVariant> variants;
  Part train;
  Part test;
};

Tuning openTuning(const Arguments& arguments, const Config& config) {
  const PlannersFile file = readPlannersFile(arguments.config);
  const PlannerGrid grid = readPlannerGrid(arguments.grid, arguments.planner);
  checkHeldOut(readScenes(arguments.train), readScenes(arguments.test));
  return {arguments,
          config,
          file,
          variantsOf(grid, file.path, file.text, config.attack.verification.limits),
          {"train", arguments.train, arguments, config},
          {"test", arguments.test, arguments, config}};
}

/// What the results depend on, for the resumption of the run.
ResumableFile::Options runOptions(const Tuning& tuning) {
  const Arguments& arguments = tuning.arguments;
  ResumableFile::Options options = fingerprintsOf(tuning.config, arguments.config);
  options["dataroot"] = fs::canonical(arguments.dataroot).string();
  options["version"] = arguments.version;
  options["planner"] = arguments.planner;
  options["background"] = arguments.background == Background::kIdm ? "idm" : "replay";
  std::string found;
  for (const PlannerVariant& variant : tuning.variants) {
    for (const auto& [key, value] : variant.values) {
      found = fingerprint(key + "=" + shortestText(value) + ";", found);
    }
  }
  options["grid"] = std::to_string(tuning.variants.size()) + " variants, fingerprint " + found;
  options["train"] = tuning.train.fingerprint();
  return options;
}

/// Drives every variant through the training cases; on the master the index of the best.
std::size_t tune(Tuning& tuning) {
  const Arguments& arguments = tuning.arguments;
  const auto work = [&](std::size_t index) {
    return plannerResultLine(testCase(tuning.train.cases(), index, [&](const PlannerCase& one) {
      return testVariants(one, arguments.planner, tuning.variants, true, arguments.background,
                          tuning.config, tuning.config.planners);
    }));
  };
  dispatch(tuning.train.size(), work,
           [&](std::size_t, const std::string& line) { tuning.train.take(line); },
           {arguments.jobs, isMaster() ? tuning.train.first() : 0});
  if (!isMaster()) return 0;
  tuning.train.complete();
  const auto scores =
      scoreVariants(tuning.train.results(), tuning.variants, tuning.config.evaluation.statistics);
  const auto best = bestVariant(scores);
  if (!best) throw std::runtime_error("--train has no avoidable crash");
  writeText(arguments.out + "/variants.csv", scoresCsv(tuning.variants, scores, *best));
  return *best;
}

/// Drives default and tuned planner through `count` held-out cases. An item is a case of a variant,
/// so that the other ranks learn from its index which variant the master found best.
void compare(Tuning& tuning, std::size_t best, std::size_t count) {
  const Arguments& arguments = tuning.arguments;
  const std::size_t cases = tuning.test.size();
  const auto work = [&](std::size_t item) {
    std::vector<PlannerVariant> pair = {tuning.variants.front(), tuning.variants[item / cases]};
    pair.back().name = "tuned";
    return plannerResultLine(
        testCase(tuning.test.cases(), item % cases, [&](const PlannerCase& one) {
          return testVariants(one, arguments.planner, pair, false, arguments.background,
                              tuning.config, tuning.config.planners);
        }));
  };
  const std::size_t done = isMaster() && count > 0 ? tuning.test.first() : 0;
  dispatch(best * cases + count, work,
           [&](std::size_t, const std::string& line) { tuning.test.take(line); },
           {arguments.jobs, best * cases + done});
  if (isMaster() && count > 0) tuning.test.complete();
}

/// Default beside tuned; their difference, which may be negative, is no bar.
void drawComparison(RateTable comparison, const Tuning& tuning) {
  comparison.methods.pop_back();
  comparison.rates.pop_back();
  comparison.measure.title = "Collisions in avoidable crashes";
  drawTable(comparison, tuning.arguments.planner + " before and after tuning", tuning.arguments.out,
            tuning.config.drawing);
}

void report(const Tuning& tuning, std::size_t best) {
  const Arguments& arguments = tuning.arguments;
  const StatisticsOptions& statistics = tuning.config.evaluation.statistics;
  const PlannerValues& before = tuning.variants.front().values;
  const PlannerValues& after = tuning.variants[best].values;
  const RateTable comparison = comparisonTable(tuning.test.results(), statistics);
  std::string text =
      reportTitle("Tuning of " + arguments.planner, statistics) + "\nBest of " +
      std::to_string(tuning.variants.size()) + " variants on the training scenarios (" +
      tuning.variants[best].name + " of variants.csv):\n\n" + describeValues(before, after) +
      "\nTraining: " + describeCases(tuning.train.results()) +
      "\nTest: " + describeCases(tuning.test.results()) + "\n" + toMarkdown(comparison);
  std::string csv = rateCsvHeader() + "\n" + toCsv(comparison);
  for (const PlannerTable& entry :
       plannerTables(tuning.test.results(), {"default", "tuned"}, statistics)) {
    text += "\n" + toMarkdown(entry.table, entry.unit);
    csv += toCsv(entry.table);
  }
  writeText(arguments.out + "/planners.yaml",
            withPlannerValues(tuning.file.path, tuning.file.text, after));
  writeText(arguments.out + "/table.csv", csv);
  writeText(arguments.out + "/table.md", text);
  drawComparison(comparison, tuning);
  std::cout << text;
}

int run(const Arguments& arguments) {
  const bool is_master = isMaster();
  const Config config = loadConfig(arguments.config);
  Tuning tuning = openTuning(arguments, config);
  if (is_master) {
    fs::create_directories(arguments.out);
    tuning.train.open(arguments.out, runOptions(tuning));
    tuning.test.open(arguments.out, runOptions(tuning));
  }
  std::size_t best = 0;
  std::exception_ptr error;
  try {
    best = tune(tuning);
  } catch (...) {
    error = std::current_exception();  // the other ranks wait for the second part
  }
  compare(tuning, best, error ? 0 : tuning.test.size());
  if (error) std::rethrow_exception(error);
  if (is_master) report(tuning, best);
  return kExitOk;
}

}  // namespace

void addTune(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app =
      line.add(kPlanners, "tune",
               "Finds the best numbers for a planner; goes on where a run stopped.", [arguments] {
                 if (arguments->grid.empty()) arguments->grid = arguments->config + "/tuning.yaml";
                 return run(*arguments);
               });
  app.add_option("--planner", arguments->planner, "name")
      ->check(CLI::IsMember(plannerNames()))
      ->capture_default_str();
  app.add_option("--grid", arguments->grid, "values to try (default: tuning.yaml of --config)")
      ->check(CLI::ExistingFile);
  app.add_option("--train", arguments->train, "scenario files of forge generate that are tuned on")
      ->required();
  app.add_option("--test", arguments->test, "scenario files of other scenes, to compare on")
      ->required();
  addLogs(app, arguments->dataroot, arguments->version);
  addBackground(app, arguments->background);
  addOut(app, arguments->out, "folder to write; see docs/planners.md");
  addJobs(app, arguments->jobs, "cases at a time, in every rank of mpirun");
  addConfig(app, arguments->config);
}

}  // namespace forge
