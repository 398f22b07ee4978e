#include "collision_forge/planner_test/trials/planner_grid.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "collision_forge/base/config/config_file.h"
#include "collision_forge/planner_test/settings/config.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

const std::string kShipped = COLLISION_FORGE_SOURCE_DIR "/config";

/// planners.yaml with this text.
TrialOptions parsed(const std::string& text) {
  TrialOptions options;
  readConfigFile(openConfigText("p.yaml", text), options,
                 loadConfig(kShipped).attack.verification.limits);
  return options;
}

const std::string kText =
    "# numbers\n"
    "a:  # of a\n"
    "  b: 1.0     # m\n"
    "  c: {d: 2, e: 3.5, list: [1.0]}\n"
    "f: \"4.0\"\n";

/// Returns the error of a call; empty if there is none.
template <typename Call>
std::string complaintOf(const Call& call) {
  try {
    call();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

bool hasAll(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (text.find(word) == std::string::npos) return false;
  }
  return true;
}

PlannerGrid gridOf(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("grid.yaml", text);
  return readPlannerGrid(folder.path() + "/grid.yaml", "pdm");
}

TEST(PlannerGrid, HasOnlyTheKeysOfItsPlanner) {
  const PlannerGrid grid = gridOf("pdm:\n  a.b: [1.0, 0.5]\n  a.c.d: [3]\nidm:\n  x.y: [7.0]\n");
  EXPECT_EQ(grid, (PlannerGrid{{"a.b", {1.0, 0.5}}, {"a.c.d", {3.0}}}));
}

TEST(PlannerGrid, BadFilesAreRejectedWithTheKey) {
  const auto complaint = [](const std::string& text) { return complaintOf([&] { gridOf(text); }); };
  EXPECT_PRED2(hasAll, complaint("idm:\n  a.b: [1.0]\n"),
               (std::vector<std::string>{"grid.yaml", "pdm is missing"}));
  EXPECT_PRED2(hasAll, complaint("pdm: {}\n"), (std::vector<std::string>{"pdm: has no keys"}));
  EXPECT_PRED2(hasAll, complaint("pdm:\n  a.b: []\n"),
               (std::vector<std::string>{"pdm.a.b", "is not a list of numbers"}));
  EXPECT_PRED2(hasAll, complaint("pdm:\n  a.b: [1.0, fast]\n"),
               (std::vector<std::string>{"pdm.a.b = fast", "is not a number"}));
  EXPECT_PRED2(hasAll, complaint("pdm:\n  a.b: [1.0, 2.0, 1]\n"),
               (std::vector<std::string>{"pdm.a.b", "lists a value twice"}));
  EXPECT_PRED2(hasAll, complaintOf([] { readPlannerGrid("nowhere/grid.yaml", "pdm"); }),
               (std::vector<std::string>{"nowhere/grid.yaml"}));
}

TEST(PlannerValues, AreFoundByTheirPaths) {
  const PlannerValues values =
      readPlannerValues("p.yaml", kText, {{"a.b", {5.0}}, {"a.c.e", {5.0}}});
  EXPECT_EQ(values, (PlannerValues{{"a.b", 1.0}, {"a.c.e", 3.5}}));
}

TEST(PlannerValues, AreReplacedWithoutOtherChanges) {
  EXPECT_EQ(
      withPlannerValues("p.yaml", kText, {{"a.b", 0.25}, {"a.c.d", 100000.0}, {"a.c.e", 7.0}}),
      "# numbers\n"
      "a:  # of a\n"
      "  b: 0.25     # m\n"
      "  c: {d: 100000, e: 7, list: [1.0]}\n"
      "f: \"4.0\"\n");
}

TEST(PlannerValues, RequireKeysWithNumbers) {
  const auto complaint = [](const std::string& key) {
    return complaintOf([&] { withPlannerValues("p.yaml", kText, {{key, 1.0}}); });
  };
  EXPECT_PRED2(hasAll, complaint("a.x"), (std::vector<std::string>{"p.yaml", "no key a.x"}));
  EXPECT_PRED2(hasAll, complaint("a.b.c"), (std::vector<std::string>{"no key a.b.c"}));
  EXPECT_PRED2(hasAll, complaint("a.c"), (std::vector<std::string>{"a.c is not a number"}));
  EXPECT_PRED2(hasAll, complaint("a.c.list"), (std::vector<std::string>{"not a number"}));
  EXPECT_PRED2(hasAll, complaint("f"), (std::vector<std::string>{"line 5", "4.0", "in quotes"}));
}

TEST(PlannerValues, OfTheShippedGridAreValid) {
  std::ifstream file(kShipped + "/planners.yaml");
  std::ostringstream text;
  text << file.rdbuf();
  for (const char* planner : {"pdm", "idm", "rule_based"}) {
    const PlannerGrid grid = readPlannerGrid(kShipped + "/tuning.yaml", planner);
    for (const auto& [key, values] : grid) {
      for (const double value : values) {
        const std::string changed = withPlannerValues("p.yaml", text.str(), {{key, value}});
        EXPECT_NO_THROW(parsed(changed)) << key;
        EXPECT_EQ(readPlannerValues("p.yaml", changed, {{key, {}}}).at(key), value);
      }
    }
  }
}

TEST(PlannerValues, AreUsedByThePlanner) {
  std::ifstream file(kShipped + "/planners.yaml");
  std::ostringstream text;
  text << file.rdbuf();
  const PlannerValues values = {{"pdm.idm.min_gap", 2.25}, {"rule_based.published.max_speed", 17}};
  const TrialOptions options = parsed(withPlannerValues("p.yaml", text.str(), values));
  EXPECT_EQ(options.pdm.idm.min_gap, 2.25);
  EXPECT_EQ(options.rule_based.max_speed, 17.0);
  EXPECT_EQ(options.idm.law.min_gap, 1.0);
  const std::string refused = withPlannerValues("p.yaml", text.str(), {{"pdm.idm.min_gap", -2.0}});
  EXPECT_PRED2(hasAll, complaintOf([&] { parsed(refused); }),
               (std::vector<std::string>{"p.yaml", "pdm.idm.min_gap = -2", "is not positive"}));
}

}  // namespace
}  // namespace forge
