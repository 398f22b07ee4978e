#include <gif_lib.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

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

}  // namespace
}  // namespace forge
