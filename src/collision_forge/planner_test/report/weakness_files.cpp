#include "collision_forge/planner_test/report/weakness_files.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "collision_forge/io/json/input_line.h"
#include "collision_forge/io/json/json_line.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

std::vector<WitnessedHit> readWitnessedHits(const std::string& folder, const InputLimits& limits) {
  const std::string path = folder + "/witnesses.jsonl";
  std::ifstream file(path, std::ios::binary);
  std::vector<WitnessedHit> hits;
  const auto where = [&] { return path + ": line " + std::to_string(hits.size() + 1); };
  for (std::string text; readInputLine(file, text, where(), limits);) {
    const JsonLine line(where(), text);
    JsonObject object = line.root();
    const auto policy = policyKindFromString(object.text("policy"));
    if (!policy) object.fail("policy", "is not an attacker policy");
    const auto background = backgroundFromString(object.text("background"));
    if (!background) object.fail("background", "is not a kind of background traffic");
    hits.push_back(
        {object.text("name"), rowName(RowKey{object.text("planner"), *policy, *background})});
  }
  return hits;
}

std::vector<std::string> weaknessCases(const std::string& folder, const InputLimits& limits) {
  std::vector<std::string> names;
  for (const WitnessedHit& hit : readWitnessedHits(folder, limits)) {
    if (std::find(names.begin(), names.end(), hit.name) == names.end()) names.push_back(hit.name);
  }
  return names;
}

}  // namespace forge
