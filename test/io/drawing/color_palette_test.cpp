#include "collision_forge/io/drawing/color_palette.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

constexpr Color kWhite = {1.0, 1.0, 1.0};
constexpr Color kRed = {1.0, 0.0, 0.0};
constexpr Color kBlue = {0.0, 0.0, 1.0};

Image flag() {
  Image image(64, 64, kWhite);
  Canvas canvas(image);
  canvas.fillRect({0, 0, 3, 3}, kRed);
  canvas.fillRect({10, 10, 2, 2}, kBlue);
  return image;
}

TEST(ColorPalette, KeepsFewColorsExactly) {
  ColorHistogram histogram;
  histogram.add(flag());
  const ColorPalette palette(histogram, 255);
  ASSERT_EQ(palette.colors().size(), 3U);
  for (const std::uint32_t color : {0xFFFFFFU, 0xFF0000U, 0x0000FFU}) {
    EXPECT_EQ(palette.colors()[palette.indexOf(color)], color);
  }
}

TEST(ColorPalette, KeepsToItsSize) {
  Image image(256, 64, kWhite);
  Canvas canvas(image);
  for (int i = 0; i < 256; ++i) {
    canvas.fillRect({static_cast<double>(i), 0, 1, 60}, {i / 255.0, 1 - i / 255.0, 0.5});
  }
  ColorHistogram histogram;
  histogram.add(image);
  const ColorPalette palette(histogram, 16);
  EXPECT_EQ(palette.colors().size(), 16U);
  for (int x = 0; x < 256; ++x) {
    const std::uint32_t wanted = image.pixel(x, 10);
    const std::uint32_t got = palette.colors()[palette.indexOf(wanted)];
    EXPECT_NEAR(static_cast<int>(wanted >> 16U), static_cast<int>(got >> 16U), 24);
  }
}

}  // namespace
}  // namespace forge
