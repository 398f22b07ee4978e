#pragma once

#include <memory>
#include <string>

#include "collision_forge/forecast/ego_futures.h"
#include "collision_forge/network/pattern_network.h"

namespace forge {

/// The ego's futures as the network foretells them: ways as likely as it says, distances driven
/// that are spread at every instant as it says. How a driver's speed goes on from one instant to
/// the next is as SpeedForecaster knows it: each of its profiles is stretched to the distance that
/// as large a share of drivers stays below in the network's eyes. As KinematicEgoFutures without a
/// network, or with one whose anchors lie on no ways.
class NetworkEgoFutures : public EgoFutureSampler {
 public:
  /// `networks` may be null. `known_type`: see Foresight. Neither a network nor a forecast that
  /// knows `left_out_scene` is used.
  NetworkEgoFutures(const EgoFutureOptions& options,
                    std::shared_ptr<const PatternNetworks> networks,
                    std::shared_ptr<const SpeedForecaster> speeds, std::string left_out_scene = "",
                    std::optional<CollisionType> known_type = std::nullopt);

  std::vector<Track> sample(const Snapshot& snapshot, const LaneIndex& lanes, double horizon,
                            int count, std::uint64_t seed) const override;

 private:
  EgoFutureOptions options_;
  std::shared_ptr<const PatternNetworks> networks_;
  std::shared_ptr<const SpeedForecaster> speeds_;
  std::string left_out_scene_;
  std::optional<CollisionType> known_type_;
  KinematicEgoFutures kinematic_;
};

}  // namespace forge
