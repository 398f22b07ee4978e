#pragma once

#include "collision_forge/io/drawing/canvas.h"
#include "collision_forge/io/drawing/caption_text.h"
#include "collision_forge/io/drawing/figure_layout.h"
#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// The one colour of a verdict.
Color colorOf(Verdict verdict, const DrawingOptions& options);

/// titleText(), detailsText(), and on the right verdictText().
void paintHeader(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                 const ScenarioView& view, const DrawingOptions& options);

/// The time since now, in the header's right corner. `time` in seconds on the scene's clock.
void paintClock(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                const ScenarioView& view, const DrawingOptions& options, double time);

/// What the colours and marks mean, of a picture that stands still or of an animation.
enum class PictureKind { kStill, kAnimation };
void paintLegend(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                 const ScenarioView& view, PictureKind kind, const DrawingOptions& options);

/// The figures of the report that are known.
void paintReport(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                 const ScenarioView& view, const DrawingOptions& options);

/// Metres of the scale bar: those of the options, or 2, 5 or 10 times as many where that would be
/// shorter than its text.
double scaleBarLength(const Viewport& viewport, double font, const DrawingOptions& options);

/// Scale bar and north arrow in the lower corners of the map.
void paintScale(Canvas& canvas, const Viewport& viewport, const FigureSize& size,
                const DrawingOptions& options);

}  // namespace forge
