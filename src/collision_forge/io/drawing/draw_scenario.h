#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// Draws the scenario from above at ScenarioMotion::keyTime(), turned so that a straight road is
/// level (ScenePainter::rightwards()). The picture is as wide as the options say, and at most as
/// high: the map ends above and below what the drives need.
///
/// Both functions write beside `path` and rename at the end, so `path` never holds half a picture.
/// The same input gives the same bytes on the same machine. They throw std::runtime_error naming
/// `path` when it cannot be written, when the attacker's trajectory or the ego's future is empty,
/// or when the trajectory does not span now to contact.
void drawScenarioPng(const std::string& path, const ScenarioView& view,
                     const DrawingOptions& options);

/// Animates the scenario in a loop, from before now to ScenarioMotion::endTime(); one frame falls
/// exactly on the contact and is held. From the contact on ego and attacker move as the view's
/// PostCrashMotion, while the others go on as recorded.
void drawScenarioGif(const std::string& path, const ScenarioView& view,
                     const DrawingOptions& options);

/// Pictures as of drawScenarioPng(), each as wide as an animation, `columns` a row, in the order of
/// `views`, row by row; all rows are as high as the highest picture. Throws as the others, and
/// std::invalid_argument for no views or no columns.
void drawScenarioSheet(const std::string& path, const std::vector<ScenarioView>& views, int columns,
                       const DrawingOptions& options);

}  // namespace forge
