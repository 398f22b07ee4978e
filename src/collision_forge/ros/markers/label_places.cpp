#include "collision_forge/ros/markers/label_places.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

constexpr double kLetterWidth = 0.55;   // of its height
constexpr double kLineHeight = 1.25;    // of a letter's height
constexpr double kMargin = 0.4;         // m between a text and a box
constexpr double kSameDistance = 1e-6;  // m; of places that are as near the first one is taken

/// Returns half the extent of a box along x and y.
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
                     const std::vector<OrientedBox>& obstacles, int rings) {
  const BoxSize needed{text.length + 2 * kMargin, text.width + 2 * kMargin};
  LabelSide best;
  best.covered = obstacles.size() + 1;
  double best_distance = 0.0;
  for (int ring = 0; ring < rings; ++ring) {
    for (const Vector2& direction :
         {Vector2(0, 1), Vector2(0, -1), Vector2(1, 0), Vector2(-1, 0), Vector2(1, 1),
          Vector2(-1, 1), Vector2(1, -1), Vector2(-1, -1)}) {
      LabelSide side{direction, ring, 0};
      const Vector2 place = placeBeside(box, text, side);
      side.covered = countCovered({{place.x(), place.y(), 0.0}, needed}, obstacles);
      const double distance = (place - box.center.position()).norm();
      const bool is_nearer = distance < best_distance - kSameDistance;
      if (side.covered > best.covered || (side.covered == best.covered && !is_nearer)) continue;
      best = side;
      best_distance = distance;
    }
  }
  return best;
}

OrientedBox sweptBox(const OrientedBox& box, const Vector2& velocity, double duration) {
  const Vector2 way = velocity * duration;
  const Vector2 middle = box.center.position() + way / 2.0;
  const double yaw = way.norm() > box.size.width ? std::atan2(way.y(), way.x()) : box.center.yaw;
  return {{middle.x(), middle.y(), yaw}, {box.size.length + way.norm(), box.size.width}};
}

Vector2 placeBeside(const OrientedBox& box, const BoxSize& text, const LabelSide& side) {
  const Vector2 half_text(text.length / 2, text.width / 2);
  const Vector2 away =
      halfExtent(box) + (1 + side.ring) * half_text + Vector2(kMargin, kMargin) * 1.5;
  return box.center.position() + side.direction.cwiseProduct(away);
}

}  // namespace forge
