#include "collision_forge/training/run_folder.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "collision_forge/data/log_fingerprints.h"
#include "collision_forge/drawing/line_chart.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/files/file_fingerprint.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> cellsOf(const std::string& row) {
  std::istringstream text(row);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

double lastNumber(const std::string& row) { return std::stod(row.substr(row.rfind(',') + 1)); }

}  // namespace

std::string readText(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string statePath(const TrainingRun& run) { return run.out + "/state.pt"; }

std::string describeRun(const TrainingRun& run, int ranks, const std::string& config) {
  std::ostringstream text;
  text << "collide = " << run.sources.collide << "\nsplits =";
  for (const std::string& split : run.sources.splits) text << ' ' << split;
  const auto logs = run.sources.hasLogs() ? fingerprintsOf(run.sources.logs)
                                          : logFingerprints(run.sources.logs.path, "");
  for (const auto& [name, found] : logs) text << '\n' << name << " = " << found;
  if (!run.sources.collide.empty()) {
    text << "\nclips = " << fingerprintOfTree(run.sources.collide + "/trajectory", ".csv");
  }
  text << "\nfold = " << run.fold << "\nfolds = " << run.folds << "\nseed = " << run.seed
       << "\ndevice = " << run.device << "\nranks = " << ranks << "\n\n";
  text << readText(run.config + "/" + config);
  return text.str();
}

OutputLock openRunFolder(const TrainingRun& run, const std::string& description) {
  OutputLock lock = OutputLock::ofFolder(run.out);
  const std::string path = run.out + "/run.txt";
  if (!fs::exists(path)) {
    if (fs::exists(statePath(run))) {
      throw std::runtime_error(statePath(run) + ": is there, but not " + path +
                               ", which says what it was made with; remove it, or write elsewhere");
    }
    writeText(path, description);
    return lock;
  }
  std::istringstream known(readText(path));
  std::istringstream wanted(description);
  std::string was;
  std::string is;
  while (std::getline(wanted, is)) {
    if (!std::getline(known, was) || was != is) {
      throw std::runtime_error(path + ": the run was started with \"" + was + "\", not \"" + is +
                               "\"");
    }
  }
  return lock;
}

SampleSplit splitByScene(const std::vector<std::string>& scenes, double validation_share,
                         std::uint64_t seed) {
  std::set<std::string> held_out;
  if (validation_share > 0.0) {
    const std::set<std::string> names(scenes.begin(), scenes.end());
    const int parts = std::max(2, static_cast<int>(std::lround(1.0 / validation_share)));
    held_out = scenesOfFold({names.begin(), names.end()}, 1, parts, seed + 1);
  }
  SampleSplit split;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    (held_out.count(scenes[i]) > 0 ? split.validation : split.training).push_back(i);
  }
  return split;
}

EpochTable::EpochTable(std::string path, const std::vector<std::string>& columns, int epochs)
    : path_(std::move(path)), columns_(columns), best_(std::numeric_limits<double>::infinity()) {
  if (epochs == 0) return;
  std::ifstream file(path_);
  std::string row;
  std::getline(file, row);
  while (static_cast<int>(rows_.size()) < epochs && std::getline(file, row)) {
    best_ = std::min(best_, lastNumber(row));
    rows_.push_back(row);
  }
}

bool EpochTable::add(const std::vector<double>& numbers) {
  std::string row = std::to_string(rows_.size() + 1);
  for (const double number : numbers) {
    char cell[32];
    std::snprintf(cell, sizeof(cell), ",%.6f", number);
    row += cell;
  }
  rows_.push_back(row);
  std::string text = "epoch";
  for (const std::string& column : columns_) text += "," + column;
  for (const std::string& known : rows_) text += "\n" + known;
  writeText(path_, text + "\n");
  const bool is_best = lastNumber(row) < best_;
  best_ = std::min(best_, lastNumber(row));
  return is_best;
}

std::vector<double> EpochTable::column(const std::string& name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  const auto index = static_cast<std::size_t>(found - columns_.begin()) + 1;
  std::vector<double> values;
  for (const std::string& row : rows_) values.push_back(std::stod(cellsOf(row).at(index)));
  return values;
}

void EpochTable::drawCurves(const std::string& path, const std::string& title,
                            const std::vector<std::pair<std::string, std::string>>& columns,
                            const DrawingOptions& options) const {
  LineChart chart{title, "epoch", {}};
  for (const auto& [name, label] : columns) {
    const Color color = chart.series.empty() ? options.attacker_color : options.ego_color;
    chart.series.push_back({label, color, column(name)});
  }
  drawLineChart(path, chart, options);
}

}  // namespace forge
