#include "collision_forge/study/evaluation/report_rows.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(RowOfResult, MeetsTheRequestByFullDefinitions) {
  ResultRow result;
  result.status = "OK";
  result.meets = {true, false};
  result.contact_after = 1.0;
  EXPECT_EQ(rowOfResult(result).outcome, "otherwise");
  result.meets = {true, true};
  EXPECT_EQ(rowOfResult(result).outcome, "as_asked");
  result.status = "NO_CANDIDATE";
  EXPECT_EQ(rowOfResult(result).outcome, "declined");
}

TEST(EvaluationFormats, CoverRequestsAndClipsOfTheStrictProtocol) {
  const std::vector<RowFormat> formats = evaluationFormats();
  ASSERT_EQ(formats.size(), 2u);
  EXPECT_EQ(formats[0].header, csvHeader(Protocol::kStrict, RowsOf::kRequests));
  EXPECT_EQ(formats[1].header, csvHeader(Protocol::kStrict, RowsOf::kClips));
}

TEST(EvaluationFormats, ConvertALineToARow) {
  ResultRow result;
  result.name = "clip";
  result.scene = "scene-0001";
  result.method = "search";
  result.status = "OK";
  result.meets.resize(measuresOf(Protocol::kStrict).size(), true);
  for (const RowFormat& format : evaluationFormats()) {
    const auto row = format.rowOf(toCsv(result));
    ASSERT_TRUE(row);
    EXPECT_EQ(row->scene, "scene-0001");
    EXPECT_EQ(row->planner, "search");
    EXPECT_EQ(row->outcome, "as_asked");
    EXPECT_FALSE(format.rowOf("clip,scene"));
  }
}

}  // namespace
}  // namespace forge
