#pragma once

#include "collision_forge/attack/pattern_predictor.h"
#include "collision_forge/data/scenario_file.h"
#include "collision_forge/data/scene_source.h"
#include "collision_forge/network/foresight.h"
#include "collision_forge/settings/config.h"

namespace forge {

/// A frame of a recording: what is known at it, and what came.
struct RecordedMoment {
  Status status;      ///< kNoScene for a time that is no frame of the scene, to a microsecond, with
                      ///< the nearest frame in the message
  Snapshot snapshot;  ///< these two with kOk only
  Future recorded;
};

/// `history_frames` as of snapshotAt().
RecordedMoment momentAt(const Scene& scene, double now, int history_frames);

/// Answers requests over recorded scenes. Thread-safe; the same request gives the same answer in
/// every process. What was learned from the scene itself is not used.
class RequestAnswerer {
 public:
  /// `scenes` and `config` must outlive it.
  RequestAnswerer(SceneSource& scenes, const Config& config, Foresight foresight);

  /// generateCollision() at the frame of the request; the status of momentAt() where there is none.
  /// Throws as SceneSource::at() does.
  Scenario answer(const SceneRequest& asked) const;
  /// The same over the scene that the request names.
  Scenario answer(const SceneRequest& asked, const IndexedScene& indexed) const;

 private:
  SceneSource& scenes_;
  const Config& config_;
  Foresight foresight_;
};

}  // namespace forge
