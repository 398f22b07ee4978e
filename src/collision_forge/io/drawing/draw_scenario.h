#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// Draws the scenario as a PNG from above at ScenarioMotion::keyTime() (the contact), rotated by
/// ScenePainter::rightwards(). The picture has the width of the options and at most their height:
/// the map is cropped above and below the paths.
///
/// Both functions write to an AsideFile, so `path` never holds half a picture. The same input gives
/// the same bytes on the same machine. They throw std::runtime_error naming `path` if it cannot be
/// written, and if checkDrawable() refuses the view.
void drawScenarioPng(const std::string& path, const ScenarioView& view,
                     const DrawingOptions& options);

/// Animates the scenario as a GIF in a loop, from DrawingOptions::seconds_before_now before t0 (or
/// the ego's first state, if later) to ScenarioMotion::endTime(); frames are 1 /
/// gif_frames_per_second apart within that time; one is exactly at keyTime() and is held for
/// gif_contact_hold longer. After the contact ego and attacker follow the view's PostCrashMotion
/// while the other agents continue as recorded.
void drawScenarioGif(const std::string& path, const ScenarioView& view,
                     const DrawingOptions& options);

}  // namespace forge
