#pragma once

#include "collision_forge/attack/forecast/ego_futures.h"
#include "collision_forge/attack/network/prediction_models.h"

namespace forge {

/// Samples ego futures from the network: path probabilities (at 4 s after t0, or at the end of a
/// shorter horizon) and the distribution of driven distance at up to nine times, 0.5 to 9 s, are
/// the network's. Speed changes over time are the SpeedForecaster's: each of its profiles is
/// rescaled to the distance at the same quantile of the network's distribution; between the times
/// the change of distance is interpolated, after the last it grows with time. Without a network,
/// with a network of another head than EgoHead::kRegionProposal, and for a reversing ego, samples
/// as KinematicEgoFutures. States are kPredictionStep apart, as there.
class NetworkEgoFutures : public EgoFutureSampler {
 public:
  /// `models` may lack the network (then samples as KinematicEgoFutures) and the SpeedForecaster
  /// (then the profiles are the ones of forecastSpeeds() for null: the acceleration at t0 decays).
  /// The network is conditioned on PredictionModels::known_type, if set.
  NetworkEgoFutures(const EgoFutureOptions& options, PredictionModels models);

  std::vector<Track> sample(const Snapshot& snapshot, const LaneIndex& lanes, double horizon,
                            int count, std::uint64_t seed) const override;

 private:
  EgoFutureOptions options_;
  PredictionModels models_;
  KinematicEgoFutures kinematic_;
};

}  // namespace forge
