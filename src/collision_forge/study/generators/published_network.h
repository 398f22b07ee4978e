#pragma once

#include <memory>

#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

/// Creates the collision-pattern network as published (arXiv 2510.12206, Sec. 3, and its released
/// code): VectorNet over the ego's history and the lanes, joined with type and time; heads for the
/// ego's position, the attacker's offset and the choice of the attacker. Its attack methods drive
/// one quintic to the predicted box. The model is on `device`; the .cpp lists deviations.
std::shared_ptr<TrafficModel> makePublishedNetwork(const PublishedNetworkOptions& options,
                                                   const TrafficOptions& traffic,
                                                   torch::Device device);

}  // namespace forge
