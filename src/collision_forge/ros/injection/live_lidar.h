#pragma once

#include <collision_forge/AgentArray.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "collision_forge/io/lidar/options.h"
#include "collision_forge/io/lidar/surface_returns.h"
#include "collision_forge/ros/injection/agent_body.h"

namespace forge {

/// Puts the attacker of a live system into its lidar clouds: the agent of injected_agents with the
/// attacker's id. Takes out the points at the attacker's place in the recorded agents, if the
/// attacker is put in. Poses between frames are interpolated; after the newest frame they are
/// extrapolated by the agent's velocity, for at most kReach; before the first kept frame an agent
/// is not shown. Returns of vehicles follow the model `materials` of SurfaceReturns. Not
/// thread-safe.
class LiveLidar {
 public:
  static constexpr double kReach = 0.5;  ///< s after the newest frame

  /// `shows_all`: puts all agents of the newest frame of addInjected() into the clouds, for frames
  /// from another list of objects than injected_agents.
  LiveLidar(const LidarOptions& options, bool shows_all)
      : options_(options), shows_all_(shows_all) {}

  /// Sets the attacker's id; empty: no attack.
  void setAttacker(const std::string& id) { attacker_ = id; }
  /// Adds a frame of injected_agents (map frame, not null). The newest 20 frames are kept; a frame
  /// older than its predecessor drops all before it.
  void addInjected(const collision_forge::AgentArray::ConstPtr& frame) { keep(frame, injected_); }
  /// Adds a frame of the recorded agents, as addInjected().
  void addRecorded(const collision_forge::AgentArray::ConstPtr& frame) { keep(frame, recorded_); }

  /// Changes the cloud, whose frame has the poses `sensor`, and returns true, also if no ray meets
  /// an agent. Returns false if no agent is to be shown at its stamp; `message` is then as before.
  /// Throws CloudError for a cloud that cannot be read, and std::invalid_argument as bodyInCloud(),
  /// with `message` as before.
  bool edit(const SensorInSweep& sensor, sensor_msgs::PointCloud2& message) const;

 private:
  using Frames = std::deque<collision_forge::AgentArray::ConstPtr>;
  static void keep(const collision_forge::AgentArray::ConstPtr& frame, Frames& frames);
  /// Returns the agent `id` at `stamp`, interpolated or extrapolated; nullopt if `frames` do not
  /// have it there.
  static std::optional<collision_forge::Agent> agentAt(const Frames& frames, const std::string& id,
                                                       const ros::Time& stamp);

  LidarOptions options_;
  bool shows_all_;
  SurfaceReturns surfaces_;
  std::string attacker_;  ///< id; empty: no attack
  Frames injected_;       ///< sorted by stamp
  Frames recorded_;       ///< sorted by stamp
};

}  // namespace forge
