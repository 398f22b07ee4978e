#include "collision_forge/study/evaluation/outcome_row.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

constexpr double kNow = 10.0;  // s

TEST(OutcomeRow, CopiesTheOutcome) {
  StrictOutcome outcome;
  outcome.report.contact = true;
  outcome.report.contact_time = kNow + 4.0;
  outcome.report.relative_heading = 1.5;
  outcome.report.type_kept = true;
  outcome.report.on_time = true;
  outcome.report.broken_limit = "max_total_acceleration 21.000 > 8.000";
  outcome.report.first_other_id = "wall";
  outcome.report.off_road_share = 0.25;
  ResultRow row;
  describeOutcome(outcome, kNow, row);
  EXPECT_EQ(row.meets, (std::vector<bool>{false, false, true, true, false, true, false, false}));
  EXPECT_EQ(row.contact_after, 4.0);
  EXPECT_EQ(row.relative_heading, 1.5);
  EXPECT_EQ(row.off_road_share, 0.25);
  EXPECT_EQ(row.note, "max_total_acceleration 21.000 > 8.000; touches wall");
}

TEST(OutcomeRow, WithoutContactHasNoFigures) {
  ResultRow row;
  describeOutcome({}, kNow, row);
  EXPECT_FALSE(row.contact_after);
  EXPECT_FALSE(row.off_road_share);
  EXPECT_EQ(row.meets, (std::vector<bool>{false, false, false, false, false, false, false, true}));
}

TEST(OutcomeRow, NotesTheReasonOfImplausibility) {
  StrictOutcome outcome;
  outcome.is_believed = false;
  outcome.report.unbelievable = "drives across the road";
  ResultRow row;
  describeOutcome(outcome, kNow, row);
  EXPECT_EQ(row.note, "drives across the road");
}

}  // namespace
}  // namespace forge
