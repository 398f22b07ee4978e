#include "collision_forge/drawing/line_chart.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <stdexcept>

#include "drawing/sample_view.h"

namespace forge {
namespace {

constexpr int kWidth = 500;
constexpr int kHeight = 300;
const Color kRed{1.0, 0.0, 0.0};
const Color kBlue{0.0, 0.0, 1.0};

DrawingOptions chartOptions() {
  DrawingOptions options = sampleOptions();
  options.chart_width = kWidth;
  options.chart_height = kHeight;
  return options;
}

/// Where the pixels of a colour are below the legend of a chart that is drawn and read back.
struct Extent {
  int count = 0;
  int left = kWidth, right = 0, top = kHeight, bottom = 0;

  Extent(const std::vector<LineSeries>& series, const Color& color) {
    const std::string path = temporaryPath("chart.png");
    drawLineChart(path, {"Title", "epochs", series}, chartOptions());
    const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
        cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy);
    std::remove(path.c_str());
    EXPECT_EQ(cairo_image_surface_get_width(surface.get()), kWidth);
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (int y = static_cast<int>(4.0 * chartOptions().png_font_size); y < kHeight; ++y) {
      const auto* row = cairo_image_surface_get_data(surface.get()) + y * stride;
      for (int x = 0; x < kWidth; ++x) {
        if ((reinterpret_cast<const std::uint32_t*>(row)[x] & 0xFFFFFFU) != packedColor(color)) {
          continue;
        }
        ++count;
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
    }
  }
};

TEST(LineChartTest, CountsToTheRightAndValuesUpwards) {
  const std::vector<LineSeries> series = {{"red", kRed, {1.0, 1.0}}, {"blue", kBlue, {3.0, 3.0}}};
  const Extent red(series, kRed);
  const Extent blue(series, kBlue);
  EXPECT_GT(red.right - red.left, kWidth / 2);
  EXPECT_LT(blue.bottom, red.top - kHeight / 3);
}

TEST(LineChartTest, LinesEndWhereTheirValuesDo) {
  const std::vector<LineSeries> series = {{"red", kRed, {1.0, 2.0, 3.0}},
                                          {"blue", kBlue, {2.0, 2.0}}};
  const Extent red(series, kRed);
  const Extent blue(series, kBlue);
  EXPECT_NEAR(blue.right, 0.5 * (red.left + red.right), 6.0);
}

TEST(LineChartTest, ValuesThatAreNotFiniteAreLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Extent with({{"red", kRed, {1.0, nan, 1.0}}, {"blue", kBlue, {2.0, 2.0, 2.0}}}, kRed);
  const Extent without({{"red", kRed, {1.0, 1.0, 1.0}}, {"blue", kBlue, {2.0, 2.0, 2.0}}}, kRed);
  EXPECT_EQ(with.top, without.top);
  EXPECT_EQ(with.right, without.right);
  EXPECT_LT(with.count, without.count);  // one dot less
}

TEST(LineChartTest, EmptyChartsAreRefusedAndUnwritablePathsNamed) {
  EXPECT_THROW(drawLineChart(temporaryPath("chart.png"), {"Title", "", {}}, chartOptions()),
               std::invalid_argument);
  try {
    drawLineChart("/nowhere/chart.png", {"Title", "", {{"red", kRed, {1.0}}}}, chartOptions());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/chart.png"), std::string::npos);
  }
}

}  // namespace
}  // namespace forge
