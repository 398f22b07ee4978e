#include "collision_forge/study/training/run_folder.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <system_error>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/file_fingerprint.h"
#include "collision_forge/base/files/fingerprint.h"
#include "collision_forge/io/logs/log_fingerprints.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> cellsOf(const std::string& row) {
  std::istringstream text(row);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Returns nullopt unless the whole text is a number.
std::optional<double> numberOf(const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [read_to, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || read_to != end) return std::nullopt;
  return number;
}

std::string inQuotes(const std::string& text) { return '"' + text + '"'; }

std::string sumsPath(const std::string& state_path) { return state_path + ".sums"; }

/// Reads the checksums, one line per epoch, up to the first damaged line.
std::vector<EpochSums> readSums(const std::string& path) {
  std::ifstream file(path);
  std::vector<EpochSums> sums;
  for (EpochSums of_epoch; file >> of_epoch.state >> of_epoch.rows;) sums.push_back(of_epoch);
  return sums;
}

/// Throws std::runtime_error if the file at `path` differs from `description`.
void checkDescription(const std::string& path, const std::string& description) {
  const std::string end = "the end of the file";
  std::istringstream known(readText(path));
  std::istringstream wanted(description);
  for (int line = 1;; ++line) {
    std::string was;
    std::string is;
    const bool has_been = static_cast<bool>(std::getline(known, was));
    const bool has_now = static_cast<bool>(std::getline(wanted, is));
    if (!has_been && !has_now) return;
    if (has_been && has_now && was == is) continue;
    throw std::runtime_error(path + ": line " + std::to_string(line) +
                             ": the run was started with " + (has_been ? inQuotes(was) : end) +
                             ", not " + (has_now ? inQuotes(is) : end) +
                             "; use the same options or choose another --out");
  }
}

}  // namespace

std::string readText(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string statePath(const TrainingRun& run) { return run.out + "/state.pt"; }

bool hasState(const TrainingRun& run) {
  const std::string path = statePath(run);
  if (!fs::exists(path)) return false;
  const std::string sum = fingerprint(readText(path));
  for (const EpochSums& of_epoch : readSums(sumsPath(path))) {
    if (of_epoch.state == sum) return true;
  }
  throw std::runtime_error(path + ": the file was changed: its checksum is not in " +
                           sumsPath(path) + "; delete " + path + " to start over");
}

std::string describeRun(const TrainingRun& run, const std::string& config) {
  std::ostringstream text;
  text << "program = collision_forge " COLLISION_FORGE_VERSION << '\n';
  text << "collide = " << run.sources.collide << "\nsplits =";
  for (const std::string& split : run.sources.splits) text << ' ' << split;
  const auto logs = run.sources.hasLogs() ? fingerprintsOf(run.sources.logs)
                                          : logFingerprints(run.sources.logs.path, "");
  for (const auto& [name, found] : logs) text << '\n' << name << " = " << found;
  if (!run.sources.collide.empty()) {
    text << "\nclips = " << fingerprintOfTree(run.sources.collide + "/trajectory", ".csv");
  }
  text << "\nfold = " << run.fold << "\nfolds = " << run.folds << "\nseed = " << run.seed
       << "\ndevice = " << run.device << '\n';
  for (const auto& [name, found] : run.config_files) text << name << " = " << found << '\n';
  text << '\n';
  text << run.config.text(config);
  return text.str();
}

OutputLock openRunFolder(const TrainingRun& run, const std::string& description) {
  OutputLock lock = OutputLock::ofFolder(run.out);
  const std::string path = run.out + "/run.txt";
  if (!fs::exists(path)) {
    if (fs::exists(statePath(run))) {
      throw std::runtime_error(statePath(run) + ": exists without its description " + path +
                               "; delete it or choose another --out");
    }
    writeText(path, description);
    return lock;
  }
  checkDescription(path, description);
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

EpochTable::EpochTable(const TrainingRun& run, const std::vector<std::string>& columns, int epochs)
    : path_(run.out + "/metrics.csv"),
      state_path_(statePath(run)),
      columns_(columns),
      best_(std::numeric_limits<double>::infinity()) {
  if (epochs == 0) return;
  sums_ = readSums(sumsPath(state_path_));
  sums_.resize(static_cast<std::size_t>(epochs));  // drops epochs without a saved state
  std::ifstream file(path_);
  std::string line;
  if (std::getline(file, line) && line != header()) {
    throw std::runtime_error(path_ + ": line 1: the header is " + inQuotes(line) + " instead of " +
                             inQuotes(header()));
  }
  for (const EpochSums& of_epoch : sums_) {
    if (!std::getline(file, line)) {
      throw std::runtime_error(path_ + ": has " + std::to_string(rows_.size()) + " rows, but " +
                               state_path_ + " has " + std::to_string(epochs) + " epochs");
    }
    append(line);
    if (rows_sum_ == of_epoch.rows) continue;
    throw std::runtime_error(path_ + ": line " + std::to_string(rows_.size() + 1) + ": " +
                             inQuotes(line) + " was changed: the checksum in " +
                             sumsPath(state_path_) + " differs; delete " + state_path_ +
                             " to start over");
  }
}

std::string EpochTable::header() const {
  std::string text = "epoch";
  for (const std::string& column : columns_) text += "," + column;
  return text;
}

void EpochTable::append(const std::string& row) {
  const std::string where = path_ + ": line " + std::to_string(rows_.size() + 2) + ": ";
  const std::vector<std::string> cells = cellsOf(row);
  if (cells.size() != columns_.size() + 1) {
    throw std::runtime_error(where + inQuotes(row) + " has " + std::to_string(cells.size()) +
                             " columns, not " + std::to_string(columns_.size() + 1));
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::optional<double> number = numberOf(cells[i + 1]);
    if (!number) {
      throw std::runtime_error(where + columns_[i] + " is " + inQuotes(cells[i + 1]) +
                               ", not a number");
    }
    numbers.push_back(*number);
  }
  best_ = std::min(best_, numbers.back());
  rows_.push_back(row);
  rows_sum_ = fingerprint(row + "\n", rows_sum_);
}

bool EpochTable::add(const std::vector<double>& numbers) {
  std::string row = std::to_string(rows_.size() + 1);
  for (const double number : numbers) {
    char cell[32];
    std::snprintf(cell, sizeof(cell), ",%.6f", number);
    row += cell;
  }
  const double best_before = best_;
  append(row);
  std::string text = header();
  for (const std::string& known : rows_) text += "\n" + known;
  writeText(path_, text + "\n");
  return best_ < best_before;
}

void EpochTable::keep(const std::string& state) {
  sums_.push_back({fingerprint(state), rows_sum_});
  std::string text;
  for (const EpochSums& of_epoch : sums_) text += of_epoch.state + " " + of_epoch.rows + "\n";
  writeText(sumsPath(state_path_), text);
  writeText(state_path_, state);
}

std::set<std::string> leftOutScenes(const TrainingRun& run) {
  if (run.fold == 0) return {};
  const std::vector<std::string> names = sceneNames(run.sources);
  if (static_cast<int>(names.size()) < run.fold) {
    throw std::runtime_error("--fold: fold " + std::to_string(run.fold) +
                             " is empty: there are only " + std::to_string(names.size()) +
                             " scenes");
  }
  return scenesOfFold(names, run.fold, run.folds, run.seed);
}

}  // namespace forge
