#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

/// Placement of texts beside boxes in a top view that looks along -z with y up. Metres.
namespace forge {

/// Returns the approximate size of a text: length along x, width along y, m.
BoxSize textSize(const std::string& text, double letter_height);

// Numbers of rings of text places around a box.
inline constexpr int kNearRings = 3;  ///< for a text that names the box
inline constexpr int kFarRings =
    8;  ///< for a single text, such as a verdict; reaches beyond most roads

/// One of eight places of a text around a box, on one of several rings.
struct LabelSide {
  Vector2 direction{0.0, 1.0};  ///< -1, 0 or 1 along x and y
  int ring = 0;                 ///< 0: next to the box; each further ring is half a text farther
  std::size_t covered = 0;      ///< number of obstacles that the text covers there
};

/// Returns the place around `box`, within `rings` rings, at which a text of size `text` covers the
/// fewest obstacles; of several the nearest. Deterministic: static obstacles keep the text in
/// place.
LabelSide freestSide(const OrientedBox& box, const BoxSize& text,
                     const std::vector<OrientedBox>& obstacles, int rings = kNearRings);

/// Returns the rectangle, along `velocity` (m/s), that a box covers in `duration` seconds.
OrientedBox sweptBox(const OrientedBox& box, const Vector2& velocity, double duration);

/// Returns the middle of a text at the place `side` of `box`.
Vector2 placeBeside(const OrientedBox& box, const BoxSize& text, const LabelSide& side);

}  // namespace forge
