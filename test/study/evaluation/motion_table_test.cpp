#include "collision_forge/study/evaluation/motion_table.h"

#include <gtest/gtest.h>

#include <sstream>

#include "attack/search/test_scenes.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

/// Returns the cells of each line of the table; the header is first.
std::vector<std::vector<std::string>> cellsOf(const std::string& table) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream text(table);
  for (std::string line; std::getline(text, line);) {
    lines.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) lines.back().push_back(cell);
  }
  return lines;
}

TEST(MotionTable, HasARowPerAttackOfTheMethodsAndPerRecordedWindow) {
  const StudyConfig config = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  ResultRow row;
  row.scene = "scene";
  row.tta = 3.0;
  row.method = "search";
  row.request.emplace().attack.emplace().size = kCarSize;
  ResultRow other = row;
  other.method = "replay";
  RecordedMotion recorded;
  recorded.window = {"another", "bus", AgentClass::kBus, {12.0, 2.9}, {}, 0};
  const auto lines =
      cellsOf(motionTable({row, other, ResultRow()}, {"replay", "search"}, {recorded}, config));
  ASSERT_EQ(lines.size(), 4u);
  for (const auto& line : lines) EXPECT_EQ(line.size(), lines.front().size());
  EXPECT_EQ(lines[1][0], "replay");
  EXPECT_EQ(lines[2][0], "search");
  EXPECT_EQ(lines[3][0], "recorded");
  EXPECT_EQ(lines[3][1], "another");
  const DriveLimits limits =
      driveLimitsOf(AgentClass::kBus, {12.0, 2.9}, config.attack.verification.drivable);
  EXPECT_NEAR(std::stod(lines[3].back()), limits.max_lateral_acceleration, 1e-6);
}

}  // namespace
}  // namespace forge
