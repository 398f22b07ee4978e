#include "collision_forge/io/drawing/label_placer.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

const PixelRect kArea{0, 0, 400, 300};

bool overlap(const PixelRect& a, const PixelRect& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

TEST(LabelPlacer, AvoidsObstacles) {
  LabelPlacer free_placer(kArea);
  const PixelRect taken = free_placer.place({200, 150}, 80, 20);
  LabelPlacer placer(kArea);
  placer.avoid(taken.center());
  EXPECT_FALSE(placer.place({200, 150}, 80, 20).contains(taken.center()));
}

TEST(LabelPlacer, LabelsOfOneAnchorDoNotOverlap) {
  LabelPlacer placer(kArea);
  const PixelRect first = placer.place({200, 150}, 80, 20);
  const PixelRect second = placer.place({200, 150}, 80, 20);
  EXPECT_FALSE(overlap(first, second));
}

}  // namespace
}  // namespace forge
