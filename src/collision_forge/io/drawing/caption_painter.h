#pragma once

#include "collision_forge/io/drawing/canvas.h"
#include "collision_forge/io/drawing/caption_text.h"
#include "collision_forge/io/drawing/figure_layout.h"
#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// Returns the colour of a verdict.
Color colorOf(Verdict verdict, const DrawingOptions& options);

// Positions come from `layout`, font sizes from `size`, texts from caption_text.h.

/// Paints titleText(), detailsText() and, on the right, verdictText().
void paintHeader(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                 const ScenarioView& view, const DrawingOptions& options);

/// Paints the time since t0 in the header's right corner. `time`: s on the scene's clock.
void paintClock(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                const ScenarioView& view, const DrawingOptions& options, double time);

/// A picture file or a frame of an animation.
enum class PictureKind { kStill, kAnimation };
/// Paints the legend of the colours and marks that a picture of this kind shows.
void paintLegend(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                 const ScenarioView& view, PictureKind kind, const DrawingOptions& options);

/// Paints the known values of the report, reportRows().
void paintReport(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                 const ScenarioView& view, const DrawingOptions& options);

/// Returns the length of the scale bar in m: the smallest of 1, 2 and 5 times `options.scale_bar`
/// with which the bar is at least 3 `font` (pixels) wide, as its text, else 10 times.
double scaleBarLength(const Viewport& viewport, double font, const DrawingOptions& options);

/// Paints the scale bar and the north arrow in the lower corners of the viewport's area.
void paintScale(Canvas& canvas, const Viewport& viewport, const FigureSize& size,
                const DrawingOptions& options);

}  // namespace forge
