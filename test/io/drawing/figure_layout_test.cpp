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

INSTANTIATE_TEST_SUITE_P(Sizes, LayoutFigure,
                         testing::Values(FigureSize{900, 960, 14.0}, FigureSize{600, 640, 10.5},
                                         FigureSize{1600, 700, 14.0}));

TEST(LayoutFigureLimits, RefusesAFontTooBigForThePicture) {
  EXPECT_THROW(layoutFigure({400, 300, 20.0}), std::invalid_argument);
  EXPECT_THROW(layoutFigure({400, 300, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace forge
