#pragma once

#include <memory>

#include "collision_forge/study/generators/published_head.h"
#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

/// The collision-pattern network as published (arXiv 2510.12206, Sec. 3, and its released code):
/// VectorNet over the ego's history and the lanes, joined with the type and the time; heads for the
/// ego's place, the attacker's offset and who attacks. Its methods drive one quintic to the
/// predicted box. What is otherwise than published is named in the source.
std::shared_ptr<TrafficModel> makePublishedNetwork(PublishedHead head,
                                                   const PublishedNetworkOptions& options,
                                                   const TrafficOptions& traffic,
                                                   torch::Device device);

}  // namespace forge
