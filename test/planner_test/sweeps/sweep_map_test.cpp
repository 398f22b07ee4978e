#include "collision_forge/planner_test/sweeps/sweep_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "collision_forge/planner_test/sweeps/draw_sweep_map.h"
#include "io/logs/nuscenes_fixture.h"
#include "planner_test/trials/made_results.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const SweepLayout kLayout{{"tta", "impact_speed", "class"}, true, "tta", "impact_speed"};

/// A cell in which idm is hit at a speed (m/s), or avoids the crash as rss does.
SweepCell cell(double tta, double impact_speed, double agent_class, std::optional<double> hit) {
  SweepCell made{{tta, impact_speed, agent_class}, result("s:1", "a", {row("idm", hit)})};
  made.result.careful_drivers = {{"rss", true, {}}};
  return made;
}

SweepCell rejected(double tta, double impact_speed, double agent_class) {
  SweepCell made{{tta, impact_speed, agent_class}, result("s:1", "a", {})};
  made.result.status = "NO_CANDIDATE";
  return made;
}

/// idm is hit at the short TTAs; at 2 m/s one cell is rejected.
std::vector<SweepCell> cells() {
  return {cell(3, 1, 0, 5.04), cell(4, 1, 0, 4.0), cell(5, 1, 0, {}),
          cell(5, 2, 0, {}),   cell(3, 2, 0, 3.0), rejected(4, 2, 0)};
}

const MapTile& tileAt(const MapPanel& panel, double x, double y) {
  for (const MapTile& tile : panel.tiles) {
    if (tile.x == x && tile.y == y) return tile;
  }
  throw std::out_of_range("no such tile");
}

TEST(SweepCell, HasAnOutcomeForEveryPlannerAndDriver) {
  SweepCell one = cell(3, 1, 0, 5.0);
  one.result.rows = {row("hit", 5.0), row("other", 6.0), row("failed", 7.0), row("avoided", {})};
  one.result.rows[1].outcome.contact->is_attacker = false;
  one.result.rows[2].outcome.failure = PlannerFailure::kError;
  one.result.careful_drivers.push_back({"fsm", false, {}});
  std::vector<SweepVerdict> verdicts;
  for (const SweepOutcome& outcome : outcomesOf(one)) verdicts.push_back(outcome.verdict);
  EXPECT_THAT(verdicts,
              ElementsAre(SweepVerdict::kHit, SweepVerdict::kHitOther, SweepVerdict::kFailed,
                          SweepVerdict::kAvoided, SweepVerdict::kAvoided, SweepVerdict::kHit));
  EXPECT_TRUE(outcomesOf(rejected(3, 1, 0)).empty());
  EXPECT_EQ(statusCounts(cells()), "5 OK, 1 NO_CANDIDATE");
}

TEST(SweepLine, HasTheValuesAndTheResult) {
  const std::string line = sweepLine(kLayout, cell(3.5, 1, 1, 5.0), 4);
  EXPECT_THAT(line, HasSubstr(R"("cell":5,"grid":true,"parameters":["tta",)"));
  EXPECT_THAT(line, HasSubstr(R"("values":{"tta":3.5,"impact_speed":1,"class":"truck"})"));
  EXPECT_THAT(line, HasSubstr(R"("planner":"idm")"));
}

TEST(SweepCsv, EveryRowHasTheColumnsOfTheHeader) {
  std::istringstream text(sweepCsv(kLayout, {cell(3.5, 1, 1, 5.0), rejected(3, 2, 0)}));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 3u);
  for (const std::string& line : lines) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','),
              std::count(lines[0].begin(), lines[0].end(), ','))
        << line;
  }
  EXPECT_THAT(lines[1], HasSubstr("1,3.5,1,truck,rss,s:1,"));
  EXPECT_THAT(lines[2], HasSubstr("NO_CANDIDATE"));
}

TEST(SweepMap, HasAPanelForEachPlannerAndDriver) {
  const SweepMap map = sweepMap(kLayout, cells());
  ASSERT_EQ(map.panels.size(), 2u);
  EXPECT_EQ(map.panels[0].name, "idm");
  EXPECT_EQ(map.panels[1].name, "rss");
  EXPECT_TRUE(map.panels[1].is_driver);
  EXPECT_THAT(map.x.labels, ElementsAre("3", "4", "5"));
  EXPECT_THAT(map.y.labels, ElementsAre("1", "2"));
  const MapPanel& panel = map.panels[0];
  EXPECT_EQ(panel.tiles.size(), 6u);
  EXPECT_EQ(tileAt(panel, 0, 0).text, "5.0");
  EXPECT_EQ(tileAt(panel, 2, 0).verdict, SweepVerdict::kAvoided);
  EXPECT_EQ(tileAt(panel, 1, 1).verdict, SweepVerdict::kRejected);
  EXPECT_EQ(tileAt(panel, 1, 1).cell, 5u);
}

TEST(SweepMap, CellsThatDifferOffTheMapShareATile) {
  const auto panel =
      sweepMap(kLayout, {cell(3, 1, 0, {}), cell(3, 1, 1, 5.0), rejected(3, 1, 2)}).panels[0];
  ASSERT_EQ(panel.tiles.size(), 1u);
  EXPECT_EQ(panel.tiles[0].verdict, SweepVerdict::kMixed);
  EXPECT_EQ(panel.tiles[0].text, "1/2");
}

TEST(SweepMap, ABoundaryIsTheMidpointBetweenNeighboursOfARow) {
  SweepMap map = sweepMap(kLayout, cells());
  ASSERT_EQ(map.panels[0].boundaries.size(), 1u) << "the rejected cell at 2 m/s is no neighbour";
  EXPECT_EQ(boundaryCsv(kLayout, map),
            "name,tta,impact_speed,class,verdict_below,verdict_above\n"
            "idm,4.5,1,car,hit,avoided\n");
  SweepLayout samples = kLayout;
  samples.is_grid = false;
  EXPECT_TRUE(sweepMap(samples, cells()).panels[0].boundaries.empty());
}

TEST(DrawSweepMap, WritesAPngOfEveryLayout) {
  const TemporaryFolder folder;
  DrawingOptions options;
  options.png_width = 600;
  SweepLayout samples = kLayout;
  samples.is_grid = false;
  SweepLayout alone = kLayout;
  alone.y.clear();
  const auto drawn = [&](const SweepLayout& layout, const std::vector<SweepCell>& some) {
    const std::string path = folder.path() + "/map.png";
    drawSweepMap(path, sweepMap(layout, some), "title", "note", options);
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  std::set<std::string> pictures = {drawn(kLayout, cells()), drawn(samples, cells()),
                                    drawn(alone, cells()), drawn(kLayout, {rejected(3, 1, 0)})};
  EXPECT_EQ(pictures.size(), 4u);
  for (const std::string& picture : pictures) EXPECT_EQ(picture.substr(1, 3), "PNG");
  EXPECT_EQ(pictures.count(drawn(kLayout, cells())), 1u) << "the same bytes";
}

}  // namespace
}  // namespace forge
