#include "collision_forge/planner_test/report/weakness_files.h"

#include <gmock/gmock.h>

#include "base/scene/shipped_limits.h"
#include "collision_forge/io/json/json_line.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string line(const std::string& name, const std::string& planner, const std::string& policy) {
  return R"({"name":")" + name + R"(","planner":")" + planner + R"(","policy":")" + policy +
         "\",\"background\":\"replay\"}\n";
}

TEST(WeaknessFiles, ACaseThatHitsTwoPlannersIsOneScenario) {
  const TemporaryFolder folder;
  folder.write("witnesses.jsonl", line("b", "idm", "fixed") + line("a", "idm", "fixed") +
                                      line("b", "pdm", "adaptive"));
  EXPECT_THAT(weaknessCases(folder.path(), shippedLimits()), ElementsAre("b", "a"));
  const auto hits = readWitnessedHits(folder.path(), shippedLimits());
  ASSERT_EQ(hits.size(), 3u);
  EXPECT_EQ(hits[2].name, "b");
  EXPECT_EQ(hits[2].row, "pdm against adaptive");
}

TEST(WeaknessFiles, NamesTheInvalidLine) {
  const TemporaryFolder folder;
  folder.write("witnesses.jsonl", line("a", "idm", "fixed") + line("a", "idm", "kind"));
  try {
    readWitnessedHits(folder.path(), shippedLimits());
    FAIL();
  } catch (const JsonLineError& error) {
    EXPECT_THAT(error.what(), HasSubstr("witnesses.jsonl: line 2"));
  }
}

}  // namespace
}  // namespace forge
