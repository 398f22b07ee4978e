#include "collision_forge/io/drawing/caption_painter.h"

#include <gtest/gtest.h>

#include "io/drawing/sample_view.h"

namespace forge {
namespace {

TEST(ScaleBar, IsLongerWhereItWouldBeShorterThanItsText) {
  const DrawingOptions options = sampleOptions();
  const auto length = [&](double pixels_per_metre) {
    return scaleBarLength({{0, 0, 100, 100}, {0, 0}, pixels_per_metre}, 10.0, options);
  };
  EXPECT_EQ(length(3.0), 10.0) << "30 pixels, as its text";
  EXPECT_EQ(length(2.9), 20.0);
  EXPECT_EQ(length(1.0), 50.0);
  EXPECT_EQ(length(0.5), 100.0);
}

}  // namespace
}  // namespace forge
