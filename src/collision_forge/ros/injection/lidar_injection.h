#pragma once

#include <collision_forge/AgentArray.h>
#include <rosbag/bag.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/io/lidar/background_map.h"
#include "collision_forge/io/lidar/cloud_injection.h"
#include "collision_forge/io/lidar/options.h"
#include "collision_forge/ros/bags/bag_frames.h"
#include "collision_forge/ros/injection/agent_body.h"

namespace forge {

/// The word for all lidar clouds of a bag whose frame is known. Clouds with a field `rcs` or
/// `doppler...` are of radars.
inline constexpr char kAllClouds[] = "auto";

/// Puts the vehicles of an attack into the lidar clouds of a bag, and takes them out of their
/// recorded places.
class LidarInjection {
 public:
  /// Returns the agents that are there at a time.
  using Agents = std::vector<collision_forge::Agent>;
  using AgentsAt = std::function<Agents(const ros::Time&)>;

  struct Setup {
    std::vector<std::string> topics;  ///< or kAllClouds
    LidarOptions options;
    std::uint64_t seed = 0;
    AgentsAt placed;  ///< the attacker and its supports, in the map frame
    AgentsAt
        vacated;  ///< the same as recorded, while they drive elsewhere; empty: none is recorded
    /// Recorded frames of agents, sorted by stamp: the vehicles whose returns are learnt.
    const std::vector<collision_forge::AgentArray>* recorded = nullptr;
    /// Changes the transforms that clouds refer to; empty: as recorded.
    std::function<tf2_msgs::TFMessage(const tf2_msgs::TFMessage&)> moved;
  };

  /// Reads all transforms of the bag, and learns from some of its clouds. Throws BagError for a
  /// topic without clouds, and without any cloud if kAllClouds was asked for.
  LidarInjection(const rosbag::Bag& source, Setup setup);

  /// Returns true for the topics whose clouds are changed.
  bool has(const std::string& topic) const { return counts_.count(topic) > 0; }

  /// Changes a cloud of `topic`. Returns false, and leaves `message` unspecified, if it stays as it
  /// is: none of the agents is in it, its frame has no transform at its stamp, or it cannot be
  /// read, which summary() counts.
  bool edit(const std::string& topic, sensor_msgs::PointCloud2& message);

  /// Returns one line per topic on what was changed, and one on the model of returns.
  std::vector<std::string> summary() const;
  /// Returns one line per topic and kind of problem.
  std::vector<std::string> warnings() const;

 private:
  struct Counts {
    std::size_t clouds = 0;
    std::size_t changed = 0;
    CloudChange points;
    std::map<std::string, std::size_t> problems;
  };

  void chooseTopics(const rosbag::Bag& source);
  void learn(const rosbag::Bag& source);
  void learnFrom(sensor_msgs::PointCloud2& message);
  void addToBackground(const PointCloud& cloud, const CloudLayout& layout, const SweepRays& sweep,
                       const Eigen::Isometry3d& sensor,
                       const std::vector<collision_forge::Agent>& agents);
  /// Returns the poses of the frame at the begin and the end of a sweep; nullopt without transform.
  std::optional<SensorInSweep> sensorOf(const std_msgs::Header& header, double begin_time) const;
  bool editCounted(sensor_msgs::PointCloud2& message, Counts& counts);

  Setup setup_;
  BagFrames frames_;
  SurfaceReturns surfaces_;
  BackgroundMap background_;              ///< empty unless a place is vacated
  std::map<std::string, Counts> counts_;  ///< by topic
};

}  // namespace forge
