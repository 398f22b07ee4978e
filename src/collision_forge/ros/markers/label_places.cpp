#include "collision_forge/ros/markers/label_places.h"

#include <algorithm>

namespace forge {
namespace {

constexpr double kLetterWidth = 0.55;  // of its height
constexpr double kLineHeight = 1.25;   // of a letter's height
constexpr double kMargin = 0.4;        // m between a text and a box
constexpr int kRings = 3;              // of places around a box, each further by half a text

/// Half of what a box covers along x and y.
Vector2 halfExtent(const OrientedBox& box) {
  Vector2 half(0.0, 0.0);
  for (const Vector2& corner : corners(box)) {
    half = half.cwiseMax((corner - box.center.position()).cwiseAbs());
  }
  return half;
}

std::size_t countCovered(const OrientedBox& place, const std::vector<OrientedBox>& obstacles) {
  return static_cast<std::size_t>(
      std::count_if(obstacles.begin(), obstacles.end(),
                    [&](const OrientedBox& box) { return overlaps(place, box); }));
}

}  // namespace

BoxSize textSize(const std::string& text, double letter_height) {
  std::size_t longest = 0;
  std::size_t lines = 0;
  for (std::size_t begin = 0; begin <= text.size(); ++lines) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    longest = std::max(longest, end - begin);
    begin = end + 1;
  }
  return {kLetterWidth * letter_height * static_cast<double>(longest),
          kLineHeight * letter_height * static_cast<double>(lines)};
}

LabelSide freestSide(const OrientedBox& box, const BoxSize& text,
                     const std::vector<OrientedBox>& obstacles) {
  const BoxSize needed{text.length + 2 * kMargin, text.width + 2 * kMargin};
  LabelSide best;
  best.covered = obstacles.size() + 1;
  for (int ring = 0; ring < kRings; ++ring) {
    for (const Vector2& direction :
         {Vector2(0, 1), Vector2(0, -1), Vector2(1, 0), Vector2(-1, 0), Vector2(1, 1),
          Vector2(-1, 1), Vector2(1, -1), Vector2(-1, -1)}) {
      LabelSide side{direction, ring, 0};
      const Vector2 place = placeBeside(box, text, side);
      side.covered = countCovered({{place.x(), place.y(), 0.0}, needed}, obstacles);
      if (side.covered < best.covered) best = side;
    }
  }
  return best;
}

Vector2 placeBeside(const OrientedBox& box, const BoxSize& text, const LabelSide& side) {
  const Vector2 half_text(text.length / 2, text.width / 2);
  const Vector2 away =
      halfExtent(box) + (1 + side.ring) * half_text + Vector2(kMargin, kMargin) * 1.5;
  return box.center.position() + side.direction.cwiseProduct(away);
}

}  // namespace forge
