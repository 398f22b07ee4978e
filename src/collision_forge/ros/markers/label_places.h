#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

/// Positions of texts in a top view that looks along -z with y up: beside boxes. Metres.
namespace forge {

/// Returns the approximate size of a text, m: length along x, width along y.
BoxSize textSize(const std::string& text, double letter_height);

// Rings of places around a box.
inline constexpr int kNearRings = 3;  ///< of a text that names the box
inline constexpr int kFarRings = 8;   ///< of a text that is alone, as a verdict: beside most roads

/// One of the eight places of a text around a box, or of the eight places farther off.
struct LabelSide {
  Vector2 direction{0.0, 1.0};  ///< -1, 0 or 1 along x and y
  int ring = 0;                 ///< 0: next to the box; each further ring is half a text farther
  std::size_t covered = 0;      ///< number of obstacles that the text covers there
};

/// Returns the nearest side of `box`, of that many rings, on which a text covers the fewest
/// obstacles. The same arguments give the same side: for a text that keeps its place, pass
/// obstacles that stand still.
LabelSide freestSide(const OrientedBox& box, const BoxSize& text,
                     const std::vector<OrientedBox>& obstacles, int rings = kNearRings);

/// Returns the area covered by a box that moves with `velocity`, m/s, for `duration` seconds: a
/// rectangle along the velocity.
OrientedBox sweptBox(const OrientedBox& box, const Vector2& velocity, double duration);

/// Returns the middle of a text on that side of `box`.
Vector2 placeBeside(const OrientedBox& box, const BoxSize& text, const LabelSide& side);

}  // namespace forge
