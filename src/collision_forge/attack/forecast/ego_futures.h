#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Draws motions of the ego from now on as likely as they are. Implementations are immutable and
/// may be used from many threads.
class EgoFutureSampler {
 public:
  virtual ~EgoFutureSampler() = default;

  /// `count` equally likely tracks of the ego, states evenly from now to at least `horizon` seconds
  /// later; the first is now's. The same arguments give the same tracks. Throws
  /// std::invalid_argument for an ego without states, a horizon that is not positive and finite,
  /// or a negative count.
  virtual std::vector<Track> sample(const Snapshot& snapshot, const LaneIndex& lanes,
                                    double horizon, int count, std::uint64_t seed) const = 0;
};

/// Lanes and speeds: each sample takes a way (egoPaths()) and drives it at speeds that drivers
/// choose in the ego's situation (SpeedForecaster). Its offset from the way returns to near zero.
/// Samples are spread evenly over ways, speeds and offsets, not drawn independently. A reversing
/// ego stops.
class KinematicEgoFutures : public EgoFutureSampler {
 public:
  /// Null, or a forecast without columns: the present acceleration, with a spread, fades instead.
  KinematicEgoFutures(const EgoFutureOptions& options,
                      std::shared_ptr<const SpeedForecaster> speeds);

  std::vector<Track> sample(const Snapshot& snapshot, const LaneIndex& lanes, double horizon,
                            int count, std::uint64_t seed) const override;

 private:
  EgoFutureOptions options_;
  std::shared_ptr<const SpeedForecaster> speeds_;
};

}  // namespace forge
