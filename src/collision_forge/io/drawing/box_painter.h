#pragma once

#include <vector>

#include "collision_forge/io/drawing/canvas.h"
#include "collision_forge/io/drawing/scenario_motion.h"

namespace forge {

/// The box's corners in pixels.
std::vector<Vector2> boxPixels(const Viewport& viewport, const OrientedBox& box);

/// A filled body with a dark rim and a light wedge that points ahead.
void paintVehicle(Canvas& canvas, const Viewport& viewport, const OrientedBox& box,
                  const Color& color, double line_width);

/// Like a vehicle; pedestrians and animals are dots, static objects have no wedge.
void paintAgent(Canvas& canvas, const Viewport& viewport, const AgentBox& agent, const Color& color,
                double line_width);

/// A see-through body.
void paintGhost(Canvas& canvas, const Viewport& viewport, const OrientedBox& box,
                const Color& color, double opacity, double line_width);

/// An outline on a light halo, so that it shows on any body.
void paintOutline(Canvas& canvas, const Viewport& viewport, const OrientedBox& box,
                  const Color& color, const Color& halo, double line_width);

/// A star of eight rays; `radius` in pixels.
void paintStar(Canvas& canvas, const Vector2& pixel, double radius, const Color& color,
               const Color& rim, double line_width);

}  // namespace forge
