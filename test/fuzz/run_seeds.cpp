#include "collision_forge/base/files/resumable_file.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"
#include "collision_forge/study/evaluation/result_row.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"
#include "planner_test/trials/rear_end_case.h"

namespace forge {
namespace {

ResultRow row() {
  ResultRow row;
  row.name = "requests:1";
  row.scene = "scene-0001";
  row.tta = 4.0;
  row.method = "search";
  row.status = "OK";
  row.meets.resize(measuresOf(Protocol::kStrict).size(), true);
  row.contact_after = 3.875;
  row.relative_heading = 0.25;
  row.confidence = 0.5;
  row.note = "max_jerk 9 > 8";
  return row;
}

/// Returns the files of a run that is stopped after its second item.
std::string stoppedRun() {
  const InputFolder folder;
  const std::string path = folder.path() + "/results";
  {
    ResumableFile file(path, {{"seed", "1"}}, {"header", 2});
    file.resume([](const std::string&, const std::string&) {});
    file.append("a\nb");
    file.append("c\nd");
  }
  return joined({{"part", bytesOf(path + ".part")},
                 {"options", bytesOf(path + ".options")},
                 {"sums", bytesOf(path + ".part.sums")}});
}

}  // namespace

std::vector<std::string> runSeeds() {
  ResultRow published = row();
  published.meets.resize(measuresOf(Protocol::kPublished).size());
  const std::string witness =
      R"({"name":"requests:1","planner":"idm","policy":"adaptive","background":"replay"})";
  return {plannerResultLine(tested()), witness + "\n" + witness, toCsv(row()), toCsv(published),
          stoppedRun()};
}

}  // namespace forge
