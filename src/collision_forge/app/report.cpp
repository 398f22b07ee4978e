#include "collision_forge/app/report.h"

#include <iostream>
#include <memory>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/planner_test/trials/planner_comparison.h"

namespace forge {
namespace {

struct Arguments {
  ReportInputs inputs;
  std::string out;
  std::vector<std::string> compared;
  ConfigFolder config;
};

int compare(const std::vector<std::string>& paths) {
  std::cout << comparisonText(compareRuns(readResults(paths[0]), readResults(paths[1])));
  return kExitOk;
}

int report(const Arguments& arguments) {
  if (!arguments.compared.empty()) return compare(arguments.compared);
  const Config config = loadConfig(arguments.config);
  const OutputLock lock = OutputLock::ofFolder(arguments.out);
  writeReport(arguments.inputs, arguments.out, config);
  return kExitOk;
}

}  // namespace

void writeReport(const ReportInputs& inputs, const std::string& folder, const Config& config) {
  const std::size_t rows = writeReportPage(
      inputs, folder,
      {config.report, config.drawing, config, config.attacked_bag.seconds_after_stand,
       readCatalogue(config.folder, "all")});
  std::cout << counted(rows, "row") << " in " << folder << "/index.html\n";
}

CLI::Option* addReportOption(CLI::App& app, std::string& folder) {
  return app.add_option("--report", folder,
                        "folder for an HTML report of the results, as forge report writes it");
}

void addReport(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kPlanners, "report", "Writes an HTML report of results.",
                           [arguments] { return report(*arguments); });
  CLI::Option* results =
      app.add_option("results", arguments->inputs.files,
                     "scenario files, results.jsonl of forge test or tune, map.png of "
                     "forge sweep")
          ->check(CLI::ExistingFile);
  CLI::Option* out =
      app.add_option("--out", arguments->out, "output folder; open its index.html in a browser");
  CLI::Option* compared =
      app.add_option("--compare", arguments->compared,
                     "instead of a report, prints the cases that are newly hit or newly avoided in "
                     "run B of forge test compared with run A (folders or results.jsonl)")
          ->expected(2)
          ->type_name("A B")
          ->check(CLI::ExistingPath)
          ->excludes(results, out);
  app.final_callback([=] {
    if (compared->count() > 0) return;
    if (results->count() == 0) throw CLI::RequiredError("results");
    if (out->count() == 0) throw CLI::RequiredError("--out");
  });
  addSource(app, arguments->inputs.logs,
            "recorded scenes of the results, to show map and traffic in the report");
  addConfig(app, arguments->config);
}

}  // namespace forge
