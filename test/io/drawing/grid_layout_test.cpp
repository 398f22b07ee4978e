#include "collision_forge/io/drawing/grid_layout.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace forge {
namespace {

double right(const PixelRect& rect) { return rect.x + rect.width; }
double bottom(const PixelRect& rect) { return rect.y + rect.height; }

bool overlap(const PixelRect& a, const PixelRect& b) {
  return a.x < right(b) && b.x < right(a) && a.y < bottom(b) && b.y < bottom(a);
}

std::vector<PixelRect> partsOf(const GridLayout& layout) {
  std::vector<PixelRect> parts = layout.names;
  parts.push_back(layout.corner);
  parts.insert(parts.end(), layout.labels.begin(), layout.labels.end());
  for (const auto& rows : {layout.cells, layout.captions}) {
    for (const auto& row : rows) parts.insert(parts.end(), row.begin(), row.end());
  }
  return parts;
}

TEST(LayoutGrid, PartsDoNotOverlapAndLieAboveTheLegend) {
  const GridLayout layout = layoutGrid({3, 2, 14.0, 90.0, 200.0});
  const std::vector<PixelRect> parts = partsOf(layout);
  EXPECT_EQ(parts.size(), 2u + 1u + 3u + 2u * 6u);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_GE(parts[i].x, layout.legend.x);
    EXPECT_LE(right(parts[i]), right(layout.legend));
    EXPECT_LE(bottom(parts[i]), layout.legend.y);
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(parts[i], parts[j])) << i << " " << j;
  }
}

TEST(LayoutGrid, NamesLabelsAndCaptionsBelongToTheirCells) {
  const GridLayout layout = layoutGrid({3, 2, 14.0, 90.0, 200.0});
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 2; ++column) {
      const PixelRect& cell = layout.cells[row][column];
      EXPECT_EQ(cell.x, layout.names[column].x);
      EXPECT_EQ(cell.width, layout.names[column].width);
      EXPECT_EQ(cell.y, layout.labels[row].y);
      EXPECT_EQ(cell.height, layout.labels[row].height);
      EXPECT_EQ(layout.captions[row][column].x, cell.x);
      EXPECT_EQ(layout.captions[row][column].y, bottom(cell));
    }
  }
}

TEST(LayoutGrid, CellsAndLabelsAreAsWideAsTheirTexts) {
  const GridLayout narrow = layoutGrid({1, 1, 10.0, 50.0, 60.0});
  const GridLayout wide = layoutGrid({1, 1, 10.0, 150.0, 800.0});
  EXPECT_LT(narrow.cells[0][0].width, 800.0);
  EXPECT_GT(wide.cells[0][0].width, 800.0);
  EXPECT_GE(wide.cells[0][0].x - wide.labels[0].x, 150.0);
  EXPECT_EQ(wide.cells[0][0].height, narrow.cells[0][0].height);
}

TEST(LayoutGrid, CellsAreWholePixels) {
  const GridLayout layout = layoutGrid({2, 2, 10.3, 50.7, 60.2});
  for (const auto& row : layout.cells) {
    for (const PixelRect& cell : row) {
      for (const double value : {cell.x, cell.y, cell.width, cell.height}) {
        EXPECT_EQ(value, static_cast<int>(value));
      }
    }
  }
}

TEST(LayoutGrid, RefusesAFontWithoutSize) {
  EXPECT_THROW(layoutGrid({1, 1, 0.0, 50.0, 60.0}), std::invalid_argument);
}

}  // namespace
}  // namespace forge
