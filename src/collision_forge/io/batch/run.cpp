#include "collision_forge/io/batch/run.h"

#include <stdexcept>

#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/interruption.h"
#include "collision_forge/io/batch/progress_line.h"

namespace forge {
namespace {

/// Adds the version of the program, from package.xml.
ResumableFile::Options withProgram(ResumableFile::Options options) {
  options["program"] = "collision_forge " COLLISION_FORGE_VERSION;
  return options;
}

/// The results file, and the messages about it.
class Results {
 public:
  explicit Results(const Run& run)
      : run_(run),
        file_(run.path, withProgram(run.options), run.layout),
        notice_("\ninterrupted; finished results are in " + run.path +
                ".part: run the same command again to continue\n"),
        done_(resume()),
        progress_(run.items, static_cast<double>(done_) / static_cast<double>(run.count)) {}

  std::size_t done() const { return done_; }

  void add(std::size_t index, const std::string& lines) {
    take(index, "the new result", lines);
    file_.append(lines);
    progress_.show(index + 1, run_.count);
  }

  void complete() {
    if (!file_.isComplete()) file_.complete();
  }

 private:
  /// Returns the number of items that an earlier run left.
  std::size_t resume() {
    std::size_t index = 0;
    const std::size_t done = file_.resume(
        [&](const std::string& where, const std::string& lines) { take(index++, where, lines); });
    if (file_.isComplete() && done < run_.count) {
      throw std::runtime_error(run_.path + ": has " + std::to_string(done) + " of " +
                               std::to_string(run_.count) + " " + run_.items);
    }
    if (done > 0) {
      printLine(std::to_string(done) + " of " + std::to_string(run_.count) + " " + run_.items +
                " were done in an earlier run");
    }
    return done;
  }

  void take(std::size_t index, const std::string& where, const std::string& lines) const {
    if (index >= run_.count) {
      throw std::runtime_error(where + ": there are only " + std::to_string(run_.count) + " " +
                               run_.items);
    }
    run_.take(index, where, lines);
  }

  const Run& run_;
  ResumableFile file_;
  InterruptionNotice notice_;
  std::size_t done_;
  ProgressLine progress_;
};

}  // namespace

void carryOut(const Run& run) {
  Results results(run);
  dispatch(run.count, run.work,
           [&](std::size_t index, const std::string& lines) { results.add(index, lines); },
           {run.jobs, results.done()});
  results.complete();
}

}  // namespace forge
