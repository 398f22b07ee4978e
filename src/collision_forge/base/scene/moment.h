#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// A recording and the spatial index of its map.
struct IndexedScene {
  Scene scene;
  std::shared_ptr<const LaneIndex> lanes;
};

/// The input of a method: one time t0 of a recorded or live scene.
struct Moment {
  Snapshot snapshot;               ///< frames up to t0
  std::optional<Future> recorded;  ///< the recording from t0 on; empty in live scenes
  std::shared_ptr<const LaneIndex> lanes;
  /// As `snapshot`, with all frames from the recording's first on: the past in which a vehicle can
  /// be added. Null in live scenes, where the past cannot be changed.
  std::shared_ptr<const Snapshot> past = nullptr;
};

/// Returns Moment::past for t0 = `now`: every frame of the recording up to it.
std::shared_ptr<const Snapshot> completePast(const Scene& scene, double now);

/// Returns the input for a request at the frame at `now` (to 1 us); `history_frames` as in
/// snapshotAt(). Returns kNoScene, whose message gives the nearest frame, if no frame is at `now`.
/// The recording must have a frame.
std::variant<Moment, Status> momentAt(const IndexedScene& recording, double now,
                                      int history_frames);

}  // namespace forge
