#include "collision_forge/study/dataset/dataset_statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

using testing::HasSubstr;

constexpr double kDegree = M_PI / 180.0;

std::vector<DatasetClip> clips() {
  return {{"train", "scene-1", "town", CollisionType::kLtap, 9, -90.0 * kDegree, 0.0},
          {"train", "scene-1", "town", CollisionType::kLtap, 18, 84.0 * kDegree, 0.1},
          {"test", "scene-2", "city", CollisionType::kRearEnd, 9, 5.0 * kDegree, 0.0},
          {"train", "scene-3", "town", CollisionType::kLtap, 9, 90.0 * kDegree, 0.05}};
}

TEST(DatasetStatistics, CsvCountsTypesTimesPlacesAndScenes) {
  EXPECT_EQ(datasetCsv(clips()),
            "group,value,train,val,test,all,share\n"
            "type,rear_end,0,0,1,1,0.2500\n"
            "type,ltap,3,0,0,3,0.7500\n"
            "tta,1.0,2,0,1,3,0.7500\n"
            "tta,5.5,1,0,0,1,0.2500\n"
            "location,city,0,0,1,1,0.2500\n"
            "location,town,3,0,0,3,0.7500\n"
            "all,scenes,2,0,1,3,\n");
}

TEST(DatasetStatistics, MarkdownHasTheSameAndWhatWasTried) {
  const std::string text = datasetMarkdown(
      clips(), {{CollisionType::kLtap, {40, 4}}, {CollisionType::kLaneChange, {7, 0}}});
  EXPECT_THAT(text, HasSubstr("4 clips of 3 scenes."));
  EXPECT_THAT(text, HasSubstr("| ltap | 3 | 0 | 0 | 3 | 75.0 |"));
  EXPECT_THAT(text, HasSubstr("| 5.5 | 1 | 0 | 0 | 1 | 25.0 |"));
  EXPECT_THAT(text, HasSubstr("| scenes | 2 | 0 | 1 | 3 |"));
  EXPECT_THAT(text, HasSubstr("| ltap | 40 | 4 | 3 | 88.0 | 5.0 |"));
  EXPECT_THAT(text, HasSubstr("| lane_change | 7 | 0 | 0 | 0.0 | 0.0 |"));
}

}  // namespace
}  // namespace forge
