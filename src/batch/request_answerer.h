#pragma once

#include "attack/pattern_predictor.h"
#include "batch/scene_source.h"
#include "formats/scenario_file.h"

namespace forge {

/// Answers requests over recorded scenes. Thread-safe; the same request gives the same answer in
/// every process. The ego's futures are drawn without the recorded speeds of the scene itself.
class RequestAnswerer {
 public:
  /// `scenes` and `config` must outlive it.
  RequestAnswerer(SceneSource& scenes, const Config& config);

  /// generateCollision() at the frame of the request. A time that is no frame of the scene, to a
  /// microsecond, is answered with kNoScene and the nearest frame in the message. Throws as
  /// SceneSource::at() does.
  Scenario answer(const SceneRequest& asked) const;

 private:
  SceneSource& scenes_;
  const Config& config_;
  std::shared_ptr<const SpeedForecaster> speeds_;
};

}  // namespace forge
