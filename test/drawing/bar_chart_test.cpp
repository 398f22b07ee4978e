#include "collision_forge/drawing/bar_chart.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

#include "drawing/sample_view.h"

namespace forge {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 320;

/// The pixels of a chart, drawn and read back.
class Chart {
 public:
  explicit Chart(const BarChart& chart) {
    DrawingOptions options = sampleOptions();
    options.chart_width = kWidth;
    options.chart_height = kHeight;
    const std::string path = temporaryPath("chart.png");
    drawBarChart(path, chart, options);
    surface_.reset(cairo_image_surface_create_from_png(path.c_str()));
    std::remove(path.c_str());
  }

  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }

  /// Pixels of a colour between two columns, above a row.
  int count(const Color& color, int from = 0, int to = kWidth) const {
    int found = 0;
    for (int y = kFirstRow; y < kHeight; ++y) {
      const auto* row = cairo_image_surface_get_data(surface_.get()) +
                        y * cairo_image_surface_get_stride(surface_.get());
      for (int x = from; x < to; ++x) {
        found += (reinterpret_cast<const std::uint32_t*>(row)[x] & 0xFFFFFFU) == packedColor(color);
      }
    }
    return found;
  }

 private:
  static constexpr int kFirstRow = 32;  // below the legend
  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
};

const Color kRed{1.0, 0.0, 0.0};
const Color kBlue{0.0, 0.0, 1.0};

BarChart sampleChart(double red, double blue) {
  return {"Title",
          {"first", "second"},
          {{"red", kRed, {Bar{red, red, red}, Bar{red, red, red}}},
           {"blue", kBlue, {Bar{blue, blue, blue}, std::nullopt}}}};
}

TEST(BarChartTest, HasTheSizeAskedFor) {
  const Chart chart(sampleChart(0.5, 0.5));
  EXPECT_EQ(chart.width(), kWidth);
  EXPECT_EQ(chart.height(), kHeight);
}

TEST(BarChartTest, BarsAreAsHighAsTheirValues) {
  const int quarter = Chart(sampleChart(0.25, 0.5)).count(kRed);
  const int half = Chart(sampleChart(0.5, 0.5)).count(kRed);
  EXPECT_GT(quarter, 1000);
  EXPECT_NEAR(half, 2.0 * quarter, 0.05 * half);
  EXPECT_EQ(Chart(sampleChart(0.0, 0.5)).count(kRed), 0);
}

TEST(BarChartTest, EmptyBarsLeaveTheirPlaceFree) {
  const Chart chart(sampleChart(0.5, 0.5));
  EXPECT_GT(chart.count(kBlue, 0, kWidth / 2), 1000);
  EXPECT_EQ(chart.count(kBlue, kWidth / 2 + 32), 0);
  EXPECT_GT(chart.count(kRed, kWidth / 2), 1000);
}

TEST(BarChartTest, WhiskersSpanTheInterval) {
  BarChart chart{"Title", {"only"}, {{"red", kRed, {Bar{0.3, 0.3, 0.3}}}}};
  const Color black{0.0, 0.0, 0.0};  // the text colour of the sample options
  const int narrow = Chart(chart).count(black);
  chart.series[0].bars[0] = Bar{0.3, 0.1, 0.9};
  EXPECT_GT(Chart(chart).count(black), narrow + 100);
}

TEST(BarChartTest, UnevenAndEmptyChartsAreRefused) {
  BarChart uneven = sampleChart(0.5, 0.5);
  uneven.series[1].bars.pop_back();
  EXPECT_THROW(Chart{uneven}, std::invalid_argument);
  EXPECT_THROW(Chart{BarChart{}}, std::invalid_argument);
}

TEST(BarChartTest, UnwritablePathIsNamed) {
  DrawingOptions options = sampleOptions();
  options.chart_width = kWidth;
  options.chart_height = kHeight;
  try {
    drawBarChart("/nowhere/chart.png", sampleChart(0.5, 0.5), options);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/chart.png"), std::string::npos);
  }
}

}  // namespace
}  // namespace forge
