#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "attack/options.h"
#include "attack/speed_profiles.h"
#include "map/lane_queries.h"
#include "scene/scene.h"

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

/// Lanes and speed profiles: each sample takes a way (egoPaths()) and drives it at the speeds that
/// a recorded driver chose in a similar situation (SpeedProfiles), fitted to the ego's. Its offset
/// from the way returns to near zero. Samples are spread evenly over ways, speeds and offsets, not
/// drawn independently. A reversing ego stops.
class KinematicEgoFutures : public EgoFutureSampler {
 public:
  /// Null or too few profiles: the present acceleration, with a spread, fades instead. Profiles of
  /// `left_out_scene` are not used.
  KinematicEgoFutures(const EgoFutureOptions& options,
                      std::shared_ptr<const SpeedProfiles> profiles,
                      std::string left_out_scene = "");

  std::vector<Track> sample(const Snapshot& snapshot, const LaneIndex& lanes, double horizon,
                            int count, std::uint64_t seed) const override;

 private:
  SpeedForecast forecastFor(const DrivingSituation& situation, double horizon) const;

  EgoFutureOptions options_;
  std::shared_ptr<const SpeedProfiles> profiles_;
  std::string left_out_scene_;
};

}  // namespace forge
