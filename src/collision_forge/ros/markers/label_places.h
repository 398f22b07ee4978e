#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

/// Placement of texts beside boxes in a top view that looks along -z with y up. Positions are in
/// the map frame, m. The box of a text is not turned: its length is along x, its width along y.
namespace forge {

/// Returns the approximate size, m, of a text, which may have several lines ('\n'): 0.55
/// `letter_height` (m) per character of the longest line, and 1.25 `letter_height` per line (own
/// choice). The empty text is one line of length 0.
BoxSize textSize(const std::string& text, double letter_height);

// Numbers of rings of text places around a box.
inline constexpr int kNearRings = 3;  ///< for a text that names the box
inline constexpr int kFarRings =
    8;  ///< for a single text, such as a verdict; reaches beyond most roads

/// Place of a text around a box: in one of eight directions, on one of several rings.
struct LabelSide {
  Vector2 direction{0.0, 1.0};  ///< from the box to the text: -1, 0 or 1 along x and along y
  int ring = 0;                 ///< 0: next to the box; each further ring is half a text farther
  std::size_t covered = 0;      ///< number of obstacles that the text, with a margin, covers there
};

/// Returns the place around `box`, on the first `rings` rings (at least 1), at which a text of size
/// `text` (m) with a margin of 0.4 m overlaps the fewest `obstacles`; of several the one whose
/// middle is nearest to the middle of `box`, then the first in a fixed order that begins above the
/// box. `box` itself need not be an obstacle. Deterministic: static obstacles keep the text in
/// place.
LabelSide freestSide(const OrientedBox& box, const BoxSize& text,
                     const std::vector<OrientedBox>& obstacles, int rings = kNearRings);

/// Returns about the rectangle that a box covers when it moves with `velocity` (m/s) for `duration`
/// seconds: as wide as the box, as long as the box and the way together, centred on the middle of
/// the way, and turned along the velocity, or along the box if it moves its width or less.
OrientedBox sweptBox(const OrientedBox& box, const Vector2& velocity, double duration);

/// Returns the middle of a text of size `text` at the place `side` of `box` (ring and direction;
/// `covered` is not used); on ring 0 the text is 0.6 m from the bounding rectangle of the box.
Vector2 placeBeside(const OrientedBox& box, const BoxSize& text, const LabelSide& side);

}  // namespace forge
