#include "collision_forge/app/report.h"

#include <iostream>
#include <memory>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/batch/dispatch.h"
#include "collision_forge/files/output_lock.h"
#include "collision_forge/scene/number_words.h"
#include "collision_forge/study/report_rows.h"

namespace forge {
namespace {

struct Arguments {
  ReportInputs inputs;
  std::string out;
  std::string config;
  std::string planner_file;
};

int report(const Arguments& arguments) {
  Config config = loadConfig(arguments.config);
  usePlannerFile(arguments.planner_file, {}, config.planners);
  const OutputLock lock = OutputLock::ofFolder(arguments.out);
  writeReport(arguments.inputs, arguments.out, config);
  return kExitOk;
}

}  // namespace

void writeReport(const ReportInputs& inputs, const std::string& folder, const Config& config) {
  const std::size_t rows =
      writeReportPage(inputs, folder,
                      {config.report, config.drawing, config, config.planners,
                       config.attacked_bag.seconds_after_stand, evaluationFormats()});
  std::cout << counted(rows, "row") << " in " << folder << "/index.html\n";
}

CLI::Option* addReportOption(CLI::App& app, std::string& folder) {
  return app.add_option("--report", folder,
                        "folder to write a page of the results to, as forge report does");
}

void addReport(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  arguments->inputs.jobs = defaultJobs();
  CLI::App& app = line.add(kMeasuring, "report", "Shows results on a page for the browser.",
                           [arguments] { return report(*arguments); });
  app.add_option("results", arguments->inputs.files,
                 "scenario files, results.jsonl of forge test or tune, attempts.jsonl of forge "
                 "dataset, results.csv of forge evaluate")
      ->required()
      ->check(CLI::ExistingFile);
  addOut(app, arguments->out, "folder to write; the page is index.html in it");
  addSource(app, arguments->inputs.logs,
            "scenes that the results are of, so that the page shows map and traffic, too");
  addBackground(app, arguments->inputs.background);
  addPlannerFile(app, arguments->planner_file);
  addJobs(app, arguments->inputs.jobs, "planner tests driven again at a time");
  addConfig(app, arguments->config);
}

}  // namespace forge
