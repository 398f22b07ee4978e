#include "collision_forge/io/drawing/figure_layout.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace forge {
namespace {

double right(const PixelRect& rect) { return rect.x + rect.width; }
double bottom(const PixelRect& rect) { return rect.y + rect.height; }

class LayoutFigure : public testing::TestWithParam<FigureSize> {};

TEST_P(LayoutFigure, PartsDoNotOverlapAndStayInside) {
  const FigureSize size = GetParam();
  const FigureLayout layout = layoutFigure(size);
  EXPECT_DOUBLE_EQ(bottom(layout.header), layout.map.y);
  EXPECT_LE(bottom(layout.map), layout.legend.y);
  EXPECT_LT(right(layout.legend), layout.report.x);
  EXPECT_LT(right(layout.report), layout.close_up.x);
  EXPECT_LE(right(layout.close_up), size.width);
  EXPECT_LE(bottom(layout.close_up), size.height);
  EXPECT_DOUBLE_EQ(layout.close_up.width, layout.close_up.height);
}

TEST_P(LayoutFigure, HasRoomForEveryCaptionRow) {
  const FigureLayout layout = layoutFigure(GetParam());
  const double last_baseline =
      layout.legend.y + GetParam().font_size + kCaptionRows * layout.line_height;
  EXPECT_LE(last_baseline + 0.25 * GetParam().font_size, GetParam().height);
}

TEST_P(LayoutFigure, WithALowerMapWhatIsBelowMovesUp) {
  const FigureLayout whole = layoutFigure(GetParam());
  const FigureLayout low = withMapHeight(whole, whole.map.height - 90);
  EXPECT_DOUBLE_EQ(low.map.height, whole.map.height - 90);
  EXPECT_DOUBLE_EQ(low.legend.y, whole.legend.y - 90);
  EXPECT_DOUBLE_EQ(low.report.y, whole.report.y - 90);
  EXPECT_DOUBLE_EQ(low.close_up.y, whole.close_up.y - 90);
}

INSTANTIATE_TEST_SUITE_P(Sizes, LayoutFigure,
                         testing::Values(FigureSize{900, 960, 14.0}, FigureSize{600, 640, 10.5},
                                         FigureSize{1600, 700, 14.0}));

TEST(LayoutFigureLimits, RefusesAFontTooBigForThePicture) {
  EXPECT_THROW(layoutFigure({400, 300, 20.0}), std::invalid_argument);
  EXPECT_THROW(layoutFigure({400, 300, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace forge
