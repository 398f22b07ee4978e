#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

/// Placement of texts beside boxes in a top view that looks along -z with y up. Positions are in
/// the map frame, m. The box of a text is not turned: its length is along x, its width along y.
namespace forge {

/// Returns the approximate size, m, of a text, which may have several lines ('\n').
/// `letter_height`: m.
BoxSize textSize(const std::string& text, double letter_height);

// Numbers of rings of text places around a box.
inline constexpr int kNearRings = 3;  ///< for a text that names the box
inline constexpr int kFarRings =
    8;  ///< for a single text, such as a verdict; reaches beyond most roads

/// Place of a text around a box: in one of eight directions, on one of several rings.
struct LabelSide {
  Vector2 direction{0.0, 1.0};  ///< from the box to the text: -1, 0 or 1 along x and along y
  int ring = 0;                 ///< 0: next to the box; each further ring is half a text farther
  std::size_t covered = 0;      ///< number of obstacles that the text covers there
};

/// Returns the place around `box`, on the first `rings` rings (at least 1), at which a text of size
/// `text` covers the fewest obstacles; of several the nearest, then the first in a fixed order that
/// begins above the box. Deterministic: static obstacles keep the text in place.
LabelSide freestSide(const OrientedBox& box, const BoxSize& text,
                     const std::vector<OrientedBox>& obstacles, int rings = kNearRings);

/// Returns the rectangle that a box covers when it moves with `velocity` (m/s) for `duration`
/// seconds: along the velocity, or along the box if it moves less than its width.
OrientedBox sweptBox(const OrientedBox& box, const Vector2& velocity, double duration);

/// Returns the middle of a text of size `text` at the place `side` of `box`.
Vector2 placeBeside(const OrientedBox& box, const BoxSize& text, const LabelSide& side);

}  // namespace forge
