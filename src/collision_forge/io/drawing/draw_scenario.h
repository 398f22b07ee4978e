#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// Draws the scenario from above at ScenarioMotion::keyTime(), rotated by
/// ScenePainter::rightwards(). The picture has the width of the options and at most their height:
/// the map is cropped above and below the paths.
///
/// Both functions write to an AsideFile, so `path` never holds half a picture. The same input gives
/// the same bytes on the same machine. They throw std::runtime_error naming `path` if it cannot be
/// written, if the attacker's trajectory or the ego's future is empty, or if the trajectory does
/// not cover t0 to contact.
void drawScenarioPng(const std::string& path, const ScenarioView& view,
                     const DrawingOptions& options);

/// Animates the scenario in a loop, from before t0 to ScenarioMotion::endTime(); one frame is
/// exactly at the contact and is held. After the contact ego and attacker follow the view's
/// PostCrashMotion while the other agents continue as recorded.
void drawScenarioGif(const std::string& path, const ScenarioView& view,
                     const DrawingOptions& options);

}  // namespace forge
