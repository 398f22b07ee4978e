#include "collision_forge/io/drawing/label_placer.h"

#include <cmath>
#include <limits>

namespace forge {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kDirections = 16;
constexpr int kRings = 4;
constexpr double kOutsideCost = 1000.0;

}  // namespace

PixelRect LabelPlacer::place(const Vector2& anchor, double width, double height) {
  PixelRect best;
  double lowest = std::numeric_limits<double>::infinity();
  for (int ring = 0; ring < kRings; ++ring) {
    for (int direction = 0; direction < kDirections; ++direction) {
      const double angle = kPi / 4 + 2 * kPi * direction / kDirections;
      const double gap = height * (1.2 + 0.8 * ring);
      const Vector2 center = anchor + Vector2(std::cos(angle) * (gap + width / 2),
                                              -std::sin(angle) * (gap + height / 2));
      const PixelRect rect{center.x() - width / 2, center.y() - height / 2, width, height};
      const double rect_cost = cost(rect) + 0.5 * ring;
      if (rect_cost < lowest) {
        lowest = rect_cost;
        best = rect;
      }
    }
  }
  avoid(best);
  return best;
}

double LabelPlacer::cost(const PixelRect& rect) const {
  const bool inside = area_.contains({rect.x, rect.y}) &&
                      area_.contains({rect.x + rect.width, rect.y + rect.height});
  double sum = inside ? 0.0 : kOutsideCost;
  const double clear = 0.3 * rect.height;
  const PixelRect surroundings{rect.x - clear, rect.y - clear, rect.width + 2 * clear,
                               rect.height + 2 * clear};
  for (const Vector2& obstacle : obstacles_) {
    if (surroundings.contains(obstacle)) sum += 1.0;
  }
  return sum;
}

void LabelPlacer::avoid(const PixelRect& rect) {
  constexpr int kSteps = 8;
  for (int i = 0; i <= kSteps; ++i) {
    for (const double share : {0.0, 0.5, 1.0}) {
      avoid(Vector2(rect.x + rect.width * i / kSteps, rect.y + rect.height * share));
    }
  }
}

}  // namespace forge
