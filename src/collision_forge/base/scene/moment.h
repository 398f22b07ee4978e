#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// A recording with the index of its map.
struct IndexedScene {
  Scene scene;
  std::shared_ptr<const LaneIndex> lanes;
};

/// An instant of a recorded or running scene: all that a method is given.
struct Moment {
  Snapshot snapshot;               ///< known at now
  std::optional<Future> recorded;  ///< what came from now on; empty where nobody knows
  std::shared_ptr<const LaneIndex> lanes;
  /// The same as `snapshot` from the recording's first frame on; empty live, where the past cannot
  /// be changed.
  std::shared_ptr<const Snapshot> past = nullptr;
};

/// Moment::past of a recording.
std::shared_ptr<const Snapshot> pastOf(const Scene& scene, double now);

/// The instant of the frame at `now` (to a microsecond) of a recording, with `history_frames` as of
/// snapshotAt(); kNoScene, with the nearest frame in the message, for the time of no frame.
std::variant<Moment, Status> momentAt(const IndexedScene& recording, double now,
                                      int history_frames);

}  // namespace forge
