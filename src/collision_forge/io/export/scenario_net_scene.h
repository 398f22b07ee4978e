#pragma once

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/export/options.h"
#include "collision_forge/io/logs/pickle_workers.h"

namespace forge {

/// The times of the rows of an exported recording.
enum class RowTimes {
  kEveryStep,  ///< every ExportOptions::step from the first frame with the ego to the last step
               ///< that is not after the last such frame: what MetaDrive replays
  /// At the frames and at the ego's poses, agents only where annotated: lossless.
  kAsRecorded,
};

/// Returns a recording, without an attack, as a ScenarioNet scenario description named after the
/// scene (scenarioNetFile()). Covers the first to the last frame at which the ego is known; leaves
/// out frames without it, and agents that have a state at no row. States are from stateAt(); the
/// map is complete, with the boundary lines of the drivable area within `options.radius` of the
/// ego's path.
///
/// The metadata has under "collision_forge": "scene", "start" (s on the scene's clock at ts = 0),
/// "frame_times" (as ts) and the fields of writeGround(). With kAsRecorded, start + ts is exactly
/// the recorded time.
///
/// Throws std::runtime_error for a scene without such a frame, and if the ego is missing at a row
/// between them.
PickleContent scenarioNetOf(const Scene& scene, RowTimes rows, const ExportOptions& options);

}  // namespace forge
