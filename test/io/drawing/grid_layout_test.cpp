#include "collision_forge/io/drawing/grid_layout.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace forge
