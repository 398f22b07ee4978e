#pragma once

#include <collision_forge/Agent.h>

#include <cstdint>

#include "collision_forge/io/lidar/cloud_injection.h"

namespace forge {

/// An agent at the begin and the end of a lidar sweep, in the map frame. Only the pose of `begin`
/// is used: all else is taken from `end`. Between the two times the pose is interpolated.
struct AgentInSweep {
  collision_forge::Agent begin, end;
  double begin_time = 0.0;  ///< s after the cloud's stamp, at most 0
  double end_time = 0.0;    ///< s after the cloud's stamp
};

/// Returns an agent that moves at its velocity from `begin_time` (s after the stamp, <= 0) to where
/// it is at the stamp.
AgentInSweep movingAgent(const collision_forge::Agent& agent, double begin_time);

/// Poses of a cloud's frame in the map frame at the begin and the end of a sweep; equal for clouds
/// whose points all refer to one pose.
struct SensorInSweep {
  Eigen::Isometry3d begin, end;  ///< at the begin of the sweep, and at the cloud's stamp
};

/// Returns the pose of the middle of the bottom face of an agent's box, with the orientation of the
/// box; in the frame of the agent's pose.
Eigen::Isometry3d bottomOf(const collision_forge::Agent& agent);

/// Returns length, width and height of the agent's box, m; for a height of 0 (unknown) the typical
/// one of its class, typicalHeight().
Eigen::Vector3d sizeOf(const collision_forge::Agent& agent);

/// Returns the body of an agent in the cloud's frame, at the begin and the end of the sweep;
/// `sweep`: the rays of the cloud (raysOf()). Its shape is lidarBodyOf() of its class and sizeOf(),
/// its brightness is brightnessOf() of its id and `seed`. The body stands on the ground of the
/// sweep below it (groundBelow()), or on the bottom of the agent's box if the sweep has no ground
/// there. Throws std::invalid_argument, naming the agent, unless all numbers are finite, length and
/// width positive, and the height not negative.
PosedBody bodyInCloud(const AgentInSweep& agent, const SensorInSweep& sensor,
                      const SweepRays& sweep, std::uint64_t seed = 0);

}  // namespace forge
