#pragma once

#include <vector>

#include "collision_forge/io/drawing/canvas.h"
#include "collision_forge/io/drawing/scenario_motion.h"

namespace forge {

/// Returns the four corners of the box (map frame) in pixels, in the order of corners().
std::vector<Vector2> boxPixels(const Viewport& viewport, const OrientedBox& box);

// Boxes are in the map frame, m; line widths are in pixels.

/// Paints a filled body with a dark rim and a light wedge that points ahead.
void paintVehicle(Canvas& canvas, const Viewport& viewport, const OrientedBox& box,
                  const Color& color, double line_width);

/// Paints an agent by class: vehicles as paintVehicle(), people on foot and animals as dots, static
/// objects without a wedge.
void paintAgent(Canvas& canvas, const Viewport& viewport, const AgentBox& agent, const Color& color,
                double line_width);

/// Paints a translucent body; `opacity` 0..1, twice as much for its outline.
void paintGhost(Canvas& canvas, const Viewport& viewport, const OrientedBox& box,
                const Color& color, double opacity, double line_width);

/// Paints an outline in `color` with a wider halo in the light colour `halo`, visible on any body.
void paintOutline(Canvas& canvas, const Viewport& viewport, const OrientedBox& box,
                  const Color& color, const Color& halo, double line_width);

/// Paints a star of eight rays around `pixel`; `radius` in pixels, `rim`: colour of its outline.
void paintStar(Canvas& canvas, const Vector2& pixel, double radius, const Color& color,
               const Color& rim, double line_width);

}  // namespace forge
