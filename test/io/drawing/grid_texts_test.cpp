#include "collision_forge/io/drawing/grid_texts.h"

#include <gtest/gtest.h>

#include "io/drawing/sample_view.h"

namespace forge {
namespace {

TEST(GridTexts, RowLabelsShowTheRequest) {
  GridCell cell{sampleView(), ""};
  cell.view.pattern.type = CollisionType::kLtap;
  cell.view.tta = 4.5;
  const GridRowTexts texts = gridRowTexts({cell});
  EXPECT_EQ(texts.title, (std::vector<std::string>{"Left turn", "across path"}));
  EXPECT_EQ(texts.time, "after 4.5 s");
  EXPECT_EQ(texts.scene, "scene-0001");
}

TEST(GridTexts, CaptionsShowTheOutcomeOrTheReason) {
  GridCell missed{sampleView(), ""};
  missed.view.report.contact = false;
  const GridRowTexts texts =
      gridRowTexts({{sampleView(), ""}, missed, {sampleView(), "no answer: low confidence"}});
  ASSERT_EQ(texts.outcomes.size(), 3u);
  EXPECT_EQ(texts.outcomes[0].contact, "contact after 2.0 s, 0°");
  EXPECT_EQ(texts.outcomes[0].verdict, "as requested");
  EXPECT_EQ(texts.outcomes[1].contact, "no contact");
  EXPECT_EQ(texts.outcomes[1].verdict, "");
  EXPECT_EQ(texts.outcomes[2].contact, "no answer: low confidence");
  EXPECT_EQ(texts.outcomes[2].verdict, "");
}

TEST(GridTexts, LinesHoldWholeWords) {
  EXPECT_EQ(inLines("Rear end", 11), (std::vector<std::string>{"Rear end"}));
  EXPECT_EQ(inLines("Rear end", 7), (std::vector<std::string>{"Rear", "end"}));
  EXPECT_EQ(inLines("unbreakable a", 3), (std::vector<std::string>{"unbreakable", "a"}));
  EXPECT_TRUE(inLines("", 3).empty());
}

}  // namespace
}  // namespace forge
