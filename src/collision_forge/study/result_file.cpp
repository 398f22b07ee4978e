#include "collision_forge/study/result_file.h"

#include <filesystem>
#include <stdexcept>

#include "collision_forge/files/aside_file.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

const char* const kFinished = "results.csv";
const char* const kPart = "results.csv.part";
const char* const kDescription = "run.txt";

/// The lines that end in a line end; the rest of the last one was cut off.
std::vector<std::string> wholeLines(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line) && !file.eof();) lines.push_back(line);
  return lines;
}

void writeLines(const std::string& path, const std::vector<std::string>& lines) {
  AsideFile file(path);
  for (const std::string& line : lines) file.stream() << line << '\n';
  file.commit();
}

}  // namespace

ResultFile::ResultFile(const std::string& folder, Run run) : folder_(folder), run_(std::move(run)) {
  is_finished_ = fs::exists(path(kFinished));
  if (!is_finished_ && !fs::exists(path(kPart))) return;
  compareDescription();
  readRows(path(is_finished_ ? kFinished : kPart));
}

void ResultFile::compareDescription() const {
  const std::string file = path(kDescription);
  if (!fs::exists(file)) {
    throw std::runtime_error(file + " is missing: nobody knows what the results beside it are of");
  }
  const std::vector<std::string> found = wholeLines(file);
  for (std::size_t i = 0; i < std::max(found.size(), run_.description.size()); ++i) {
    const std::string there = i < found.size() ? found[i] : "";
    const std::string wanted = i < run_.description.size() ? run_.description[i] : "";
    if (there == wanted) continue;
    throw std::runtime_error(folder_ + " holds the results of another run: \"" + there +
                             "\" there, \"" + wanted + "\" now; give another --out");
  }
}

void ResultFile::readRows(const std::string& file) {
  const std::vector<std::string> lines = wholeLines(file);
  if (lines.empty()) return;
  if (lines.front() != csvHeader(run_.protocol)) {
    throw std::runtime_error(file + ": line 1: \"" + lines.front() + "\" is another header");
  }
  const std::size_t rows = (lines.size() - 1) / run_.rows_per_item * run_.rows_per_item;
  for (std::size_t i = 0; i < rows; ++i) {
    const auto row = rowFromCsv(lines[i + 1], run_.protocol);
    const std::size_t item = i / run_.rows_per_item;
    if (!row || item >= run_.items.size() || row->name != run_.items[item]) {
      throw std::runtime_error(file + ": line " + std::to_string(i + 2) + ": \"" + lines[i + 1] +
                               "\" is not the row expected there");
    }
    rows_.push_back(*row);
  }
  items_done_ = rows / run_.rows_per_item;
  if (is_finished_ && items_done_ < run_.items.size()) {
    throw std::runtime_error(file + ": ends before " + run_.items[items_done_]);
  }
}

void ResultFile::open() {
  if (is_finished_) return;
  fs::create_directories(folder_);
  writeLines(path(kDescription), run_.description);
  std::vector<std::string> lines = {csvHeader(run_.protocol)};
  for (const ResultRow& row : rows_) lines.push_back(toCsv(row));
  writeLines(path(kPart), lines);
  part_.open(path(kPart), std::ios::binary | std::ios::app);
}

void ResultFile::add(const std::vector<ResultRow>& rows) {
  for (const ResultRow& row : rows) part_ << toCsv(row) << '\n';
  part_.flush();
  if (!part_) throw std::runtime_error(path(kPart) + ": cannot be written");
  rows_.insert(rows_.end(), rows.begin(), rows.end());
  ++items_done_;
}

void ResultFile::finish() {
  if (is_finished_) return;
  if (items_done_ != run_.items.size()) {
    throw std::logic_error(std::to_string(items_done_) + " of " +
                           std::to_string(run_.items.size()) + " are done");
  }
  part_.close();
  if (!part_) throw std::runtime_error(path(kPart) + ": cannot be completed");
  fs::rename(path(kPart), path(kFinished));
  is_finished_ = true;
}

}  // namespace forge
