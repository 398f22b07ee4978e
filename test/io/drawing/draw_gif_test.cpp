#include <gif_lib.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "collision_forge/io/drawing/draw_clouds.h"
#include "collision_forge/io/drawing/draw_scenario.h"
#include "collision_forge/io/drawing/scenario_painter.h"
#include "io/drawing/sample_view.h"

namespace forge {
namespace {

/// A GIF file read back, with frames composed as in a viewer.
struct Animation {
  int width = 0;
  int height = 0;
  bool loops = false;
  std::vector<int> delays;                         ///< hundredths of a second
  std::vector<std::vector<std::uint32_t>> frames;  ///< 0x00RRGGBB, row by row

  std::uint32_t at(std::size_t frame, const Vector2& pixel) const {
    return frames[frame][static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(pixel.x())];
  }
};

void overlay(const GifFileType& file, const SavedImage& image, int transparent,
             std::vector<std::uint32_t>& pixels) {
  const GifImageDesc& area = image.ImageDesc;
  for (int y = 0; y < area.Height; ++y) {
    for (int x = 0; x < area.Width; ++x) {
      const int index = image.RasterBits[y * area.Width + x];
      if (index == transparent) continue;
      const GifColorType& color = file.SColorMap->Colors[index];
      pixels[static_cast<std::size_t>((area.Top + y) * file.SWidth + area.Left + x)] =
          static_cast<std::uint32_t>(color.Red << 16 | color.Green << 8 | color.Blue);
    }
  }
}

Animation readGif(const std::string& path) {
  Animation animation;
  GifFileType* file = DGifOpenFileName(path.c_str(), nullptr);
  if (file == nullptr) return animation;
  if (DGifSlurp(file) == GIF_OK) {
    animation.width = file->SWidth;
    animation.height = file->SHeight;
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(file->SWidth * file->SHeight));
    for (int i = 0; i < file->ImageCount; ++i) {
      GraphicsControlBlock control;
      DGifSavedExtensionToGCB(file, i, &control);
      overlay(*file, file->SavedImages[i], control.TransparentColor, pixels);
      animation.delays.push_back(control.DelayTime);
      animation.frames.push_back(pixels);
    }
  }
  DGifCloseFile(file, nullptr);
  animation.loops = readBytes(path).find("NETSCAPE2.0") != std::string::npos;
  return animation;
}

/// Allows the palette to shift a channel slightly.
bool looksLike(std::uint32_t pixel, const Color& color) {
  const std::uint32_t wanted = packedColor(color);
  for (const unsigned shift : {16U, 8U, 0U}) {
    const int difference =
        static_cast<int>((pixel >> shift) & 0xFFU) - static_cast<int>((wanted >> shift) & 0xFFU);
    if (std::abs(difference) > 8) return false;
  }
  return true;
}

/// Frames lie at 102.04 s + k / 10 s, k from -40 (98.04 s, the first within the past) to 5.
constexpr std::size_t kContactFrame = 40;
constexpr std::size_t kFrames = 46;

class DrawGif : public testing::Test {
 protected:
  void TearDown() override { std::remove(path_.c_str()); }

  Animation draw() {
    drawScenarioGif(path_, view_, options_);
    return readGif(path_);
  }
  Vector2 pixelOf(const Vector2& world) const {
    return ScenarioPainter(view_, options_, gifSize(options_)).mapViewport().toPixel(world);
  }

  ScenarioView view_ = sampleView();
  DrawingOptions options_ = sampleOptions();
  std::string path_ = temporaryPath("scenario.gif");
};

TEST_F(DrawGif, HasTheConfiguredWidthFramesAndDelays) {
  const Animation animation = draw();
  EXPECT_EQ(animation.width, options_.gif_width);
  EXPECT_LE(animation.height, options_.gif_height);
  EXPECT_TRUE(animation.loops);
  ASSERT_EQ(animation.delays.size(), kFrames);
  for (std::size_t i = 0; i < kFrames; ++i) {
    EXPECT_EQ(animation.delays[i], i == kContactFrame ? 80 : 10) << "frame " << i;
  }
}

TEST_F(DrawGif, EgoAndAttackerMoveUpToTheContact) {
  const Animation animation = draw();
  ASSERT_EQ(animation.frames.size(), kFrames);
  const Color& ego = options_.ego_color;
  const Color& attacker = options_.attacker_color;
  EXPECT_TRUE(looksLike(animation.at(0, pixelOf({-10, -0.6})), ego));
  EXPECT_TRUE(looksLike(animation.at(0, pixelOf({-34.5, -0.6})), attacker));
  EXPECT_FALSE(looksLike(animation.at(kContactFrame, pixelOf({-10, -0.6})), ego));
  for (const std::size_t frame : {kContactFrame, kFrames - 1}) {
    EXPECT_TRUE(looksLike(animation.at(frame, pixelOf({10, 0})), ego));
    EXPECT_TRUE(looksLike(animation.at(frame, pixelOf({5.5, 0})), attacker));
  }
}

TEST_F(DrawGif, EgoAndAttackerComeToRestAfterTheContact) {
  view_ = sampleCrash();
  const Animation animation = draw();
  ASSERT_EQ(animation.frames.size(), kContactFrame + 1 + 15) << "1 s to the stand and 0.5 s more";
  const Color& ego = options_.ego_color;
  const Color& attacker = options_.attacker_color;
  for (const std::size_t frame : {kContactFrame + 10, kContactFrame + 15}) {
    EXPECT_TRUE(looksLike(animation.at(frame, pixelOf({13.7, -0.6})), ego));
    EXPECT_TRUE(looksLike(animation.at(frame, pixelOf({9.375, -0.6})), attacker));
  }
  EXPECT_TRUE(looksLike(animation.at(kContactFrame, pixelOf({10.0, -0.6})), ego));
}

TEST_F(DrawGif, SameInputGivesTheSameBytes) {
  draw();
  const std::string first = readBytes(path_);
  draw();
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(first, readBytes(path_));
}

TEST_F(DrawGif, CloudsShowTheNewPointsInTheAttackersColour) {
  const Eigen::Vector3f ground(10.0F, 5.0F, 0.0F);
  const Eigen::Vector3f wall(25.0F, 8.0F, 2.0F);
  const Eigen::Vector3f attacker(20.0F, -3.0F, 1.0F);
  const std::vector<CloudPair> pairs = {{7.0, {ground, wall}, {ground, wall}},
                                        {7.25, {ground, wall}, {wall, attacker}}};
  drawCloudsGif(path_, pairs, {{1.0, 0.0, 0.0}, {4.0, 1.8}}, options_);
  const Animation animation = readGif(path_);
  ASSERT_EQ(animation.frames.size(), 2u);
  EXPECT_EQ(animation.delays.front(), 25);
  EXPECT_EQ(animation.width, options_.gif_width);
  // From 15 m behind to 45 m ahead of base_link, the recorded cloud over the attacked one.
  const double scale = animation.width / 60.0;
  const auto colorAt = [&](std::size_t frame, bool is_lower, double x, double y) {
    const double top = 2.0 * options_.gif_font_size + (is_lower ? animation.height / 2 : 0);
    return animation.at(frame, {(x + 15.0) * scale, top + (10.0 - y) * scale});
  };
  for (const bool is_lower : {false, true}) {
    EXPECT_TRUE(looksLike(colorAt(0, is_lower, 1.0, 0.0), options_.ego_color));
    EXPECT_TRUE(looksLike(colorAt(0, is_lower, 10.0, 5.0), options_.lane_color));
    EXPECT_TRUE(looksLike(colorAt(0, is_lower, 25.0, 8.0), options_.text_color));
    EXPECT_EQ(looksLike(colorAt(1, is_lower, 10.0, 5.0), options_.lane_color), !is_lower);
    EXPECT_EQ(looksLike(colorAt(1, is_lower, 20.0, -3.0), options_.attacker_color), is_lower);
  }
}

}  // namespace
}  // namespace forge
