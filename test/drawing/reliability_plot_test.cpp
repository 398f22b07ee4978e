#include "collision_forge/drawing/reliability_plot.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "drawing/sample_view.h"

namespace forge {
namespace {

constexpr int kSize = 400;
const Color kRed{1.0, 0.0, 0.0};
const Color kBlue{0.0, 0.0, 1.0};

DrawingOptions plotOptions() {
  DrawingOptions options = sampleOptions();
  options.plot_size = kSize;
  return options;
}

/// Where the pixels of a colour are below the legend of a plot that is drawn and read back.
struct Extent {
  int count = 0;
  int left = kSize, right = 0, top = kSize, bottom = 0;

  Extent(const ReliabilityPlot& plot, const Color& color) {
    const std::string path = temporaryPath("plot.png");
    drawReliabilityPlot(path, plot, plotOptions());
    const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
        cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy);
    std::remove(path.c_str());
    EXPECT_EQ(cairo_image_surface_get_width(surface.get()), kSize);
    EXPECT_EQ(cairo_image_surface_get_height(surface.get()), kSize);
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (int y = static_cast<int>(4.0 * plotOptions().png_font_size); y < kSize; ++y) {
      const auto* row = cairo_image_surface_get_data(surface.get()) + y * stride;
      for (int x = 0; x < kSize; ++x) {
        const auto pixel = reinterpret_cast<const std::uint32_t*>(row)[x] & 0xFFFFFFU;
        if (pixel == packedColor(color)) add(x, y);
      }
    }
  }

  double middleX() const { return 0.5 * (left + right); }
  double middleY() const { return 0.5 * (top + bottom); }

 private:
  void add(int x, int y) {
    ++count;
    left = std::min(left, x);
    right = std::max(right, x);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  }
};

Extent pointAt(double promised, double kept) {
  return {{"Title", {{"red", kRed, {{promised, {kept, kept, kept}}}}}}, kRed};
}

TEST(ReliabilityPlotTest, PromisedIsToTheRightAndKeptUpwards) {
  const Extent middle = pointAt(0.5, 0.5);
  EXPECT_GT(middle.count, 10);
  const Extent right = pointAt(0.75, 0.5);
  EXPECT_NEAR(right.middleY(), middle.middleY(), 1.0);
  const Extent up = pointAt(0.5, 0.75);
  EXPECT_NEAR(up.middleX(), middle.middleX(), 1.0);
  EXPECT_GT(right.middleX(), middle.middleX() + 20.0);
  EXPECT_NEAR(middle.middleY() - up.middleY(), right.middleX() - middle.middleX(), 1.5);
}

TEST(ReliabilityPlotTest, WhiskersSpanTheInterval) {
  const double up = pointAt(0.5, 0.9).middleY();
  const double down = pointAt(0.5, 0.1).middleY();
  const Extent extent({"Title", {{"red", kRed, {{0.5, {0.3, 0.1, 0.9}}}}}}, kRed);
  EXPECT_NEAR(extent.top, up, 2.0);
  EXPECT_NEAR(extent.bottom, down, 2.0);
}

TEST(ReliabilityPlotTest, PointsAreJoinedAndSeriesHaveTheirColors) {
  const ReliabilityPlot plot{"Title",
                             {{"red", kRed, {{0.2, {0.2, 0.2, 0.2}}, {0.8, {0.2, 0.2, 0.2}}}},
                              {"blue", kBlue, {{0.5, {0.9, 0.9, 0.9}}}}}};
  const Extent red(plot, kRed);
  EXPECT_GT(red.count, 2 * pointAt(0.2, 0.2).count + 100);
  EXPECT_LT(Extent(plot, kBlue).bottom, red.top);
}

TEST(ReliabilityPlotTest, EmptyPlotsAreRefusedAndUnwritablePathsNamed) {
  EXPECT_THROW(drawReliabilityPlot(temporaryPath("plot.png"), {}, plotOptions()),
               std::invalid_argument);
  try {
    drawReliabilityPlot("/nowhere/plot.png", {"Title", {{"red", kRed, {}}}}, plotOptions());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/plot.png"), std::string::npos);
  }
}

}  // namespace
}  // namespace forge
