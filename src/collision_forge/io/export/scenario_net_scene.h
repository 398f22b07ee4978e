#pragma once

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/export/options.h"
#include "collision_forge/io/logs/pickle_workers.h"

namespace forge {

/// At which times a recording is told.
enum class RowTimes {
  kEveryStep,  ///< of the options, from the first frame on: what MetaDrive replays
  /// At the frames and at the ego's poses, agents where they were annotated: all comes back
  /// exactly.
  kAsRecorded,
};

/// A recording, without an attack, as a scenario description of ScenarioNet; its name
/// is the scene's (scenarioNetFile()). It goes from the first to the last frame at which the ego is
/// known; frames without it are left out. States are those of stateAt(), the map is whole, and
/// lines where drivable ground ends are told within `options.radius` of the ego's way.
///
/// The metadata have below "collision_forge": "scene", "start" (s, the scene's clock at ts 0),
/// "frame_times" (of ts), and those of writeGround(). At rows as recorded start + ts is the time to
/// the last bit.
///
/// Throws std::runtime_error for a scene without such a frame, and where the ego is lost for a time
/// that has steps.
PickleContent scenarioNetOf(const Scene& scene, RowTimes rows, const ExportOptions& options);

}  // namespace forge
