#pragma once

#include <collision_forge/Agent.h>

#include <cstdint>

#include "collision_forge/io/lidar/cloud_injection.h"

namespace forge {

/// An agent at the begin and the end of a sweep, s after the cloud's stamp.
struct AgentInSweep {
  collision_forge::Agent begin, end;
  double begin_time = 0.0;
  double end_time = 0.0;
};

/// Returns an agent that moves at its velocity from `begin_time` (s after the stamp, <= 0) to where
/// it is at the stamp.
AgentInSweep movingAgent(const collision_forge::Agent& agent, double begin_time);

/// Poses of a cloud's frame in the map frame at the begin and the end of a sweep; equal for clouds
/// whose points all refer to one pose.
struct SensorInSweep {
  Eigen::Isometry3d begin, end;
};

/// Returns the pose of an agent, the origin at the bottom of its box. Frame: as the agent's.
Eigen::Isometry3d bottomOf(const collision_forge::Agent& agent);

/// Returns the body of an agent in a cloud's frame. It stands on the ground of the sweep below it
/// (groundBelow()), else on the bottom of its box. Throws std::invalid_argument unless all numbers
/// are finite and the sizes positive. `seed`: of brightnessOf().
PosedBody bodyInCloud(const AgentInSweep& agent, const SensorInSweep& sensor,
                      const SweepRays& sweep, std::uint64_t seed = 0);

}  // namespace forge
