#include "collision_forge/study/rate_table.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

const StatisticsOptions kOptions{100, 0.95, 1};

ResultRow row(const std::string& method, const std::string& scene, bool collision, bool similar) {
  ResultRow row;
  row.method = method;
  row.scene = scene;
  row.type = CollisionType::kRearEnd;
  row.tta = 2.0;
  row.meets = {collision, similar};
  return row;
}

std::vector<ResultRow> sampleRows() {
  return {row("a", "s", true, true), row("a", "s", true, false), row("a", "s", false, false),
          row("a", "s", false, false), row("b", "s", false, false)};
}

TEST(RateTable, RateIsOfAllRowsOrOfThoseThatMeetTheGivenMeasure) {
  const auto tables = tabulate(sampleRows(), Protocol::kPublished, {"a", "b"}, kOptions);
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[0].measure.name, "collision");
  EXPECT_EQ(tables[0].groups.back(), "all");
  EXPECT_EQ(tables[0].rates[0].back().trials, 4);
  EXPECT_EQ(tables[0].rates[0].back().value, 0.5);
  EXPECT_EQ(tables[0].rates[1].back().value, 0.0);
  EXPECT_EQ(tables[1].rates[0].back().trials, 2);
  EXPECT_EQ(tables[1].rates[0].back().value, 0.5);
  EXPECT_EQ(tables[1].rates[1].back().trials, 0);
}

TEST(RateTable, RowsStandInTheirTypesAndTtasColumns) {
  const auto tables = tabulate(sampleRows(), Protocol::kPublished, {"a"}, kOptions);
  for (std::size_t i = 0; i < tables[0].groups.size(); ++i) {
    const std::string& group = tables[0].groups[i];
    const bool expected = group == "RE" || group == "1.5-2.5 s" || group == "all";
    EXPECT_EQ(tables[0].rates[0][i].trials, expected ? 4 : 0) << group;
  }
}

TEST(RateTable, MethodsNotAskedForAreLeftOut) {
  const auto tables = tabulate(sampleRows(), Protocol::kPublished, {"b"}, kOptions);
  ASSERT_EQ(tables[0].rates.size(), 1u);
  EXPECT_EQ(tables[0].rates[0].back().trials, 1);
}

TEST(RateTable, MarkdownHasPercentIntervalsAndTrials) {
  RateTable table;
  table.measure.title = "Title";
  table.methods = {"a", "b"};
  table.groups = {"RE", "all"};
  table.rates = {{{0, 0.0, {}}, {200, 0.8125, Interval{0.776, 0.844}}},
                 {{0, 0.0, {}}, {200, 1.0, Interval{1.0, 1.0}}}};
  EXPECT_EQ(toMarkdown(table),
            "Title, %\n\n| method | RE | all |\n|---|---|---|\n| a | - | 81.2 [78, 84] |\n"
            "| b | - | 100.0 [100, 100] |\n| of | 0 | 200 |\n");
  table.rates[1][1].trials = 150;
  const std::string text = toMarkdown(table);
  EXPECT_NE(text.find("| of, a | 0 | 200 |\n| of, b | 0 | 150 |\n"), std::string::npos) << text;
}

TEST(RateTable, AnotherUnitHasItsNameAndScale) {
  RateTable table;
  table.measure.title = "Speed";
  table.methods = {"a"};
  table.groups = {"all"};
  table.rates = {{{3, 7.25, Interval{5.0, 9.0}}}};
  EXPECT_EQ(toMarkdown(table, {"m/s", 1.0}),
            "Speed, m/s\n\n| method | all |\n|---|---|\n| a | 7.2 [5, 9] |\n| of | 3 |\n");
}

TEST(RateTable, OneSceneIsShownWithoutAnInterval) {
  RateTable table;
  table.measure.name = "hits";
  table.methods = {"a"};
  table.groups = {"all"};
  table.rates = {{{20, 0.85, {}}}};
  EXPECT_NE(toMarkdown(table).find("| a | 85.0 |\n"), std::string::npos);
  EXPECT_EQ(toCsv(table), "hits,a,all,20,0.8500,,\n");
}

TEST(RateTable, CsvHasALineAMethodAndGroup) {
  RateTable table;
  table.measure.name = "hits";
  table.methods = {"a"};
  table.groups = {"RE", "all"};
  table.rates = {{{0, 0.0, {}}, {200, 0.8125, Interval{0.776, 0.844}}}};
  EXPECT_EQ(rateCsvHeader(), "measure,method,group,trials,value,low,high");
  EXPECT_EQ(toCsv(table), "hits,a,RE,0,,,\nhits,a,all,200,0.8125,0.7760,0.8440\n");
}

}  // namespace
}  // namespace forge
