#include <boost/timer/progress_display.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>

#include "batch/dispatch.h"
#include "drawing/bar_chart.h"
#include "formats/collide_clip.h"
#include "formats/collide_set.h"
#include "formats/config.h"
#include "formats/nuscenes_map.h"
#include "protocols/clip_evaluation.h"
#include "protocols/config_digest.h"
#include "protocols/rate_table.h"
#include "protocols/result_file.h"
#include "tools/tool_support.h"

namespace {

using namespace forge;

struct Arguments {
  std::string collide;
  std::string dataroot;
  std::string split = "val";
  std::string protocol = "strict";
  std::string mode = "history";
  std::string out;
  std::string config;
  EvaluationPlan plan;
  int jobs = 1;
  std::size_t limit = 0;
  bool by_scene = false;
};

struct CityMap {
  std::shared_ptr<const LaneMap> map;
  std::unique_ptr<const LaneIndex> lanes;
};

/// The maps of the clips' cities, each read once. Thread-safe.
class CityMaps {
 public:
  CityMaps(const Arguments& arguments, const Config& config)
      : arguments_(arguments), config_(config) {}

  const CityMap& at(const std::string& city) {
    const std::lock_guard<std::mutex> lock(mutex_);
    CityMap& entry = maps_[city];
    if (!entry.lanes) {
      entry.map = std::make_shared<const LaneMap>(
          readNuScenesMap(arguments_.dataroot, city, drivingSide(config_, city),
                          {config_.conversion.centerline_resolution}));
      entry.lanes = std::make_unique<const LaneIndex>(entry.map);
    }
    return entry;
  }

 private:
  const Arguments& arguments_;
  const Config& config_;
  std::mutex mutex_;
  std::map<std::string, CityMap> maps_;
};

std::vector<std::string> listClips(const Arguments& arguments, const Config& config) {
  std::vector<std::string> paths =
      arguments.by_scene ? listCollideClipsByScene(arguments.collide, arguments.split,
                                                   config.evaluation.collide.held_out_share)
                         : listCollideClips(arguments.collide, arguments.split);
  if (arguments.limit > 0 && arguments.limit < paths.size()) paths.resize(arguments.limit);
  return paths;
}

std::vector<std::string> describe(const Arguments& arguments) {
  std::vector<std::string> lines = digestConfig(arguments.config);
  const auto add = [&lines](const char* key, const auto& value) {
    std::ostringstream line;
    line << key << " = " << value;
    lines.push_back(line.str());
  };
  add("collide", arguments.collide);
  add("dataroot", arguments.dataroot);
  add("split", arguments.split);
  add("by-scene", arguments.by_scene ? "yes" : "no");
  add("protocol", toString(arguments.plan.protocol));
  add("method", arguments.plan.method);
  add("mode", toString(arguments.plan.mode));
  add("seeds", arguments.plan.seeds);
  add("limit", arguments.limit);
  return lines;
}

ResultFile::Run describeRun(const Arguments& arguments, const std::vector<std::string>& paths) {
  ResultFile::Run run{
      arguments.plan.protocol, {}, rowsPerClip(arguments.plan), describe(arguments)};
  for (const std::string& path : paths) {
    run.clips.push_back(std::filesystem::path(path).stem().string());
  }
  return run;
}

/// Between processes a clip's rows travel as lines.
std::string toBytes(const std::vector<ResultRow>& rows) {
  std::string bytes;
  for (const ResultRow& row : rows) bytes += toCsv(row) + "\n";
  return bytes;
}

std::vector<ResultRow> fromBytes(const std::string& bytes, Protocol protocol) {
  std::vector<ResultRow> rows;
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);) {
    rows.push_back(rowFromCsv(line, protocol).value());
  }
  return rows;
}

/// Evaluates the clips that have no rows yet. Every process numbers all clips alike, done or not,
/// so it does not matter when each of them looked at the file.
void evaluateClips(const Arguments& arguments, const Config& config,
                   const std::vector<std::string>& paths, ResultFile& file) {
  CityMaps maps(arguments, config);
  const auto speeds = loadSpeedForecaster(config);
  const std::size_t done = file.clipsDone();
  const auto work = [&](std::size_t index) -> std::string {
    if (index < done) return {};
    const CollideClip clip = readCollideClip(paths[index]);
    const CityMap& city = maps.at(clip.city);
    return toBytes(evaluateClip(clip, *city.lanes, city.map, speeds, config, arguments.plan));
  };
  std::unique_ptr<boost::timer::progress_display> progress;
  if (isMaster()) {
    file.open();
    progress = std::make_unique<boost::timer::progress_display>(paths.size(), std::cerr);
  }
  const auto take = [&](std::size_t index, const std::string& bytes) {
    if (index >= done) file.add(fromBytes(bytes, arguments.plan.protocol));
    ++*progress;
  };
  dispatch(paths.size(), work, take, {arguments.jobs});
}

BarChart chartOf(const RateTable& table, const std::string& title, const DrawingOptions& drawing) {
  const std::vector<Color> colors = {drawing.agent_color, drawing.pattern_ego_color,
                                     drawing.pattern_attacker_color, drawing.ego_color};
  BarChart chart{title, table.groups, {}};
  for (std::size_t i = 0; i < table.methods.size(); ++i) {
    BarSeries series{table.methods[i], colors[i % colors.size()], {}};
    for (const Rate& rate : table.rates[i]) {
      series.bars.push_back(rate.trials > 0 ? std::optional<Bar>({rate.value, rate.low, rate.high})
                                            : std::nullopt);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

/// What is measured, on one line.
std::string headline(const Arguments& arguments, std::size_t clips) {
  return "COLLIDE " + arguments.split + (arguments.by_scene ? " by scene" : "") + ", " +
         arguments.protocol + " protocol, " + arguments.mode + " mode, " + std::to_string(clips) +
         " clips";
}

void writeText(const std::string& path, const std::string& text) {
  std::ofstream file(path + ".part", std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
  std::filesystem::rename(path + ".part", path);
}

void report(const Arguments& arguments, const Config& config, const ResultFile& file) {
  const std::string title = headline(arguments, file.clipsDone());
  std::string text = title + "; rates with " +
                     std::to_string(std::lround(100.0 * config.evaluation.statistics.confidence)) +
                     " % intervals over scenes\n";
  for (const RateTable& table : tabulate(file.rows(), arguments.plan.protocol,
                                         methodsOf(arguments.plan), config.evaluation.statistics)) {
    text += "\n" + toMarkdown(table);
    if (!table.measure.is_headline) continue;
    drawBarChart(arguments.out + "/" + table.measure.name + ".png",
                 chartOf(table, table.measure.title + ": " + title, config.drawing),
                 config.drawing);
  }
  writeText(arguments.out + "/table.md", text);
  std::cout << text;
}

int evaluate(Arguments arguments) {
  arguments.plan.protocol = protocolFromString(arguments.protocol).value();
  arguments.plan.mode = modeFromString(arguments.mode).value();
  const Config config = loadConfig(arguments.config);
  const std::vector<std::string> paths = listClips(arguments, config);
  ResultFile file(arguments.out, describeRun(arguments, paths));
  evaluateClips(arguments, config, paths, file);
  if (!isMaster()) return kExitOk;
  file.finish();
  report(arguments, config, file);
  return kExitOk;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Measures a method on the clips of COLLIDE, and baselines beside it.", "evaluate");
  app.add_option("--collide", arguments.collide, "COLLIDE, with trajectory/SPLIT in it")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--dataroot", arguments.dataroot, "nuScenes root with maps/expansion in it")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--out", arguments.out,
                 "folder for results.csv, table.md and charts; a run that "
                 "was interrupted goes on there")
      ->required();
  app.add_option("--split", arguments.split, "which clips")
      ->check(CLI::IsMember({"train", "val", "test"}))
      ->capture_default_str();
  app.add_flag("--by-scene", arguments.by_scene,
               "deal published train and val anew, so that no scene is in both");
  app.add_option("--protocol", arguments.protocol, "how crashes are judged")
      ->check(CLI::IsMember({"published", "strict"}))
      ->capture_default_str();
  app.add_option("--method", arguments.plan.method, "measured beside the baselines")
      ->check(CLI::IsMember(evaluationMethods()))
      ->capture_default_str();
  app.add_option("--mode", arguments.mode,
                 "history: use only what was seen up to now; replay: use the recorded future")
      ->check(CLI::IsMember({"history", "replay"}))
      ->capture_default_str();
  app.add_option("--seeds", arguments.plan.seeds, "of a search: 0 to this minus one, all pooled")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--jobs", arguments.jobs, "clips at a time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--limit", arguments.limit, "the first clips only; 0 takes all")
      ->capture_default_str();
  addConfigOption(app, arguments.config);
  return runTool(app, argc, argv, [&] { return evaluate(arguments); });
}
