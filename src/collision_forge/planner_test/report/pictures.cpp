#include "collision_forge/planner_test/report/pictures.h"

#include <filesystem>
#include <map>

#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/planner_test/report/weakness_files.h"
#include "collision_forge/planner_test/trials/planner_report.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// Returns the animation or the figure of that name, if either exists.
void add(std::vector<Picture>& pictures, const std::string& name, const std::string& path) {
  for (const char* ending : {".gif", ".png"}) {
    if (!fs::exists(path + ending)) continue;
    pictures.push_back({name, path + ending});
    return;
  }
}

/// Figures are numbered in the order of worstCases().
void addWorst(TestPictures& pictures, const std::string& folder,
              const std::vector<PlannerTestResult>& results) {
  if (!fs::is_directory(folder)) return;
  std::map<std::string, RowKey> tested;
  for (const PlannerTestResult& result : results) {
    for (const PlannerRow& row : result.rows) tested.emplace(rowName(row), keyOf(row));
  }
  for (const auto& [row, key] : tested) {
    if (!nameFault(key.planner).empty()) continue;  // the file may have been edited by hand
    int rank = 0;
    for (const WorstCase& worst : worstCases(results, {row}, results.size())) {
      add(pictures[{results[worst.result].name, row}], "The hit as driven",
          folder + "/" + pictureName(key, ++rank));
    }
  }
}

}  // namespace

TestPictures picturesBeside(const std::string& results_path,
                            const std::vector<PlannerTestResult>& results,
                            const InputLimits& limits) {
  const std::string folder = fs::absolute(results_path).parent_path().string();
  TestPictures pictures;
  addWorst(pictures, folder + "/worst", results);
  int rank = 0;
  for (const WitnessedHit& hit : readWitnessedHits(folder, limits)) {
    const std::string path = folder + "/weaknesses/" + std::to_string(++rank);
    std::vector<Picture>& of = pictures[{hit.name, hit.row}];
    add(of, "Weakness " + std::to_string(rank), path);
    add(of, "Its evasive manoeuvre", path + "_escape");
  }
  return pictures;
}

}  // namespace forge
