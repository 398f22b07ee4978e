#include "collision_forge/base/files/resumable_file.h"
#include "collision_forge/planner_test/report/weakness_files.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"
#include "collision_forge/study/evaluation/result_row.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

void readPlannerResult(const std::string& where, const std::string& line) {
  const std::string written = plannerResultLine(readPlannerResultLine(where, line));
  requireSame(written, plannerResultLine(readPlannerResultLine(where, written)));
}

void readRow(const std::string& line) {
  for (const Protocol protocol : {Protocol::kStrict, Protocol::kPublished}) {
    const auto row = rowFromCsv(line, protocol);
    if (!row) continue;
    const std::string written = toCsv(*row);
    const auto again = rowFromCsv(written, protocol);
    require(again.has_value(), "written it is no row any more: " + written);
    requireSame(written, toCsv(*again));
  }
}

/// Resumes an interrupted run with the parts "part", "options" and "sums", for items of two lines.
void resumeRun(const std::string& path) {
  ResumableFile file(path, {{"seed", "1"}}, {"header", 2});
  std::string items;
  file.resume([&](const std::string& where, const std::string& lines) {
    require(where.rfind(path, 0) == 0, "an item stands nowhere");
    items += lines + "\n";
  });
  file.append("one\ntwo");
  file.complete();
  requireSame("header\n" + items + "one\ntwo\n", bytesOf(path));
}

}  // namespace

/// Input: files of runs that are read again: a line of planner results, lines of witnesses, a row
/// of results.csv, or the files of an interrupted run.
bool fuzzRuns(const std::string& input) {
  const InputFolder folder;
  const std::string path = folder.path() + "/results";
  if (!input.empty() && input.front() == '{') {
    const bool is_result =
        isTaken("line 1", [&] { readPlannerResult("results.jsonl: line 1", input); });
    const std::string witnesses = folder.write("witnesses.jsonl", input);
    const bool is_witness =
        isTaken(witnesses, [&] { readWitnessedHits(folder.path(), configuration().input_limits); });
    return is_result || is_witness;
  }
  Parts parts = partsOf(input);
  if (parts.empty()) return isTaken("", [&] { readRow(input); });
  folder.write("results.part", parts["part"]);
  folder.write("results.options", parts["options"]);
  folder.write("results.part.sums", parts["sums"]);
  return isTaken(path, [&] { resumeRun(path); });
}

}  // namespace forge
