#include "collision_forge/study/evaluation/row_rates.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

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

TEST(RowRates, RateCountsAllRowsOrRowsThatMeetTheGivenMeasure) {
  const auto tables = tabulate(sampleRows(), Protocol::kPublished, {"a", "b"});
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

TEST(RowRates, RowsCountInTheColumnsOfTheirTypeAndTta) {
  const auto tables = tabulate(sampleRows(), Protocol::kPublished, {"a"});
  for (std::size_t i = 0; i < tables[0].groups.size(); ++i) {
    const std::string& group = tables[0].groups[i];
    const bool expected = group == "RE" || group == "1.5-2.5 s" || group == "all";
    EXPECT_EQ(tables[0].rates[0][i].trials, expected ? 4 : 0) << group;
  }
}

TEST(RowRates, OtherMethodsAreIgnored) {
  const auto tables = tabulate(sampleRows(), Protocol::kPublished, {"b"});
  ASSERT_EQ(tables[0].rates.size(), 1u);
  EXPECT_EQ(tables[0].rates[0].back().trials, 1);
}

}  // namespace
}  // namespace forge
