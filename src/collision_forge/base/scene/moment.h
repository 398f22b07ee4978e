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
  std::shared_ptr<const LaneIndex> lanes;  ///< index of scene.map, not null
};

/// The input of a method: one time t0 of a recorded or live scene.
struct Moment {
  Snapshot snapshot;  ///< frames up to t0
  /// The recording from t0 on, recordedFuture(); empty in live scenes.
  std::optional<Future> recorded;
  std::shared_ptr<const LaneIndex> lanes;  ///< index of snapshot.map, not null
  /// As `snapshot`, with frames (historyTimes()) back to the begin of the recording: the past in
  /// which a vehicle can be added. Null in live scenes, where the past cannot be changed.
  std::shared_ptr<const Snapshot> past = nullptr;
};

/// Returns Moment::past for t0 = `now` (s, scene clock): the frames of all historyTimes() up to it,
/// back to the begin of the recording.
std::shared_ptr<const Snapshot> completePast(const Scene& scene, double now);

/// Returns the input for a request at the frame at `now` (s, scene clock, to 1 us);
/// `history_frames` as in snapshotAt(). Returns kNoScene, whose message gives the nearest frame, if
/// no frame is at `now`. The recording must have a frame.
std::variant<Moment, Status> momentAt(const IndexedScene& recording, double now,
                                      int history_frames);

}  // namespace forge
