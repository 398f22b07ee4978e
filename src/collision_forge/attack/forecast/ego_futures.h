#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Interface: samples motions of the ego after t0 in proportion to their probability.
/// Implementations must be immutable: one object is used from many threads at once.
class EgoFutureSampler {
 public:
  virtual ~EgoFutureSampler() = default;

  /// Returns `count` equally likely tracks of the ego (box centres, global map frame; times on the
  /// snapshot's clock), in no defined order; none if `count` is 0. The states are evenly spaced
  /// from t0 to at least t0 + `horizon` (s); the first is the state at t0. Each track has the id,
  /// class and size of `snapshot.ego`; `seed` starts its random draws. Called on the caller's
  /// thread, once per request by pattern predictors and at each update step by adaptive attackers,
  /// so it must be fast. Must be deterministic in its arguments and must use only `snapshot` and
  /// the map `lanes`, nothing later than t0. Throws std::invalid_argument if the ego has no states,
  /// `horizon` is not positive and finite, or `count` is negative.
  virtual std::vector<Track> sample(const Snapshot& snapshot, const LaneIndex& lanes,
                                    double horizon, int count, std::uint64_t seed) const = 0;
};

/// Samples per track a path (egoPaths()) and a speed profile typical of the ego's situation
/// (SpeedForecaster); the lateral offset decays towards the path. Samples are stratified over
/// paths, speeds and offsets, not independent. For a reversing ego: reversingFutures(). States are
/// kPredictionStep apart. The last state is at the first multiple of kPredictionStep at or after
/// `horizon`.
class KinematicEgoFutures : public EgoFutureSampler {
 public:
  /// If `speeds` is null or its forecast has no columns, the acceleration at t0, with the spread of
  /// `options`, decays instead.
  KinematicEgoFutures(const EgoFutureOptions& options,
                      std::shared_ptr<const SpeedForecaster> speeds);

  std::vector<Track> sample(const Snapshot& snapshot, const LaneIndex& lanes, double horizon,
                            int count, std::uint64_t seed) const override;

 private:
  EgoFutureOptions options_;
  std::shared_ptr<const SpeedForecaster> speeds_;
};

}  // namespace forge
