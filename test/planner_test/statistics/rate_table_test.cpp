#include "collision_forge/planner_test/statistics/rate_table.h"

#include <gtest/gtest.h>
#include <algorithm>

namespace forge {
namespace {

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

TEST(RateTable, MethodsWithoutTrialsOfATypeHaveAnEmptyCellInItsColumn) {
  const Trial rear_end{"s", CollisionType::kRearEnd, 4.0, 1.0};
  const Trial sideswipe{"s", CollisionType::kSideswipeSameDirection, 4.0, 0.0};
  for (const MethodTrials& trials :
       {MethodTrials{{"a", {rear_end}}, {"b", {rear_end, sideswipe}}},
        MethodTrials{{"b", {rear_end, sideswipe}}, {"a", {rear_end}}}, MethodTrials{}}) {
    const RateTable table = tabulateTrials({"hits", "Hits", {}}, trials);
    const auto count = [&](const std::string& method, const std::string& group) {
      const auto place = [](const std::vector<std::string>& names, const std::string& name) {
        return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                        names.begin());
      };
      return table.rates.at(place(table.methods, method)).at(place(table.groups, group)).trials;
    };
    EXPECT_NE(toMarkdown(table).find("| method | LC |"), std::string::npos);
    if (trials.empty()) continue;
    const std::string sideswipe_title = "sideswipe same direction";
    EXPECT_EQ(count("a", "RE"), 1);
    EXPECT_EQ(count("b", "RE"), 1);
    EXPECT_EQ(count("a", sideswipe_title), 0);
    EXPECT_EQ(count("b", sideswipe_title), 1);
    EXPECT_EQ(count("a", "all"), 1);
    EXPECT_EQ(count("b", "all"), 2);
  }
}

TEST(RateTable, CsvHasALinePerMethodAndGroup) {
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
