#pragma once

#include "collision_forge/attack/forecast/ego_futures.h"
#include "collision_forge/attack/network/foresight.h"

namespace forge {

/// The ego's futures as the network foretells them: ways as likely as it says, distances driven
/// that are spread at every instant as it says. How a driver's speed goes on from one instant to
/// the next is as SpeedForecaster knows it: each of its profiles is stretched to the distance that
/// as large a share of drivers stays below in the network's eyes. As KinematicEgoFutures without a
/// network, or with one whose anchors lie on no ways.
class NetworkEgoFutures : public EgoFutureSampler {
 public:
  NetworkEgoFutures(const EgoFutureOptions& options, Foresight foresight);

  std::vector<Track> sample(const Snapshot& snapshot, const LaneIndex& lanes, double horizon,
                            int count, std::uint64_t seed) const override;

 private:
  EgoFutureOptions options_;
  Foresight foresight_;
  KinematicEgoFutures kinematic_;
};

}  // namespace forge
