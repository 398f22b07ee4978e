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

/// Word in a list of topics for all topics of a bag with sensor_msgs/PointCloud2 of lidars; ignored
/// beside names of topics. Clouds are of a radar if the first one of their topic has a field `rcs`
/// or a field whose name begins with `doppler`, in upper or lower case.
inline constexpr char kAllClouds[] = "auto";

/// Puts the vehicles of an attack into the lidar clouds of a bag, and takes them out of their
/// recorded places. Not thread-safe.
class LidarInjection {
 public:
  using Agents = std::vector<collision_forge::Agent>;
  /// Returns agents, with poses in the map frame, at a header stamp; empty if there are none.
  using AgentsAt = std::function<Agents(const ros::Time&)>;

  struct Setup {
    std::vector<std::string> topics;  ///< topics of the clouds with leading slash; or kAllClouds
    LidarOptions options;
    std::uint64_t seed = 0;  ///< of the noise, of lost returns and of the vehicles' brightness
    AgentsAt placed;         ///< the attacker and its supports as the attack moves them
    /// The same vehicles as recorded, at times at which the attack moves them elsewhere; an empty
    /// function if none of them was recorded.
    AgentsAt vacated;
    /// Recorded frames of agents, sorted by stamp: the vehicles whose returns are learnt. Not null;
    /// used only in the constructor.
    const std::vector<collision_forge::AgentArray>* recorded = nullptr;
    /// Returns a message of /tf (not /tf_static), changed, as in the new bag; called in the order
    /// of recording. An empty function leaves the transforms as recorded.
    std::function<tf2_msgs::TFMessage(const tf2_msgs::TFMessage&)> moved;
  };

  /// Reads all transforms of the bag, and learns from some of its clouds (40 to 79 per topic,
  /// evenly spaced, or all if there are fewer) how vehicles return rays (SurfaceReturns) and, with
  /// Setup::vacated, what is behind them (BackgroundMap). Learns no returns from recorded vehicles
  /// without positive size, finite pose and velocity, and an orientation that is not zero. `source`
  /// is used only here, `setup` is kept. Throws BagError for a topic without clouds, and, if
  /// kAllClouds was asked for, for a bag without clouds of a lidar.
  LidarInjection(const rosbag::Bag& source, Setup setup);

  /// Returns true for the topics whose clouds are changed.
  bool has(const std::string& topic) const { return counts_.count(topic) > 0; }

  /// Changes a cloud of `topic`, for which has() must be true. Returns true if points of `message`
  /// were changed. Returns false, and leaves `message` unspecified, if the recorded cloud is to be
  /// kept: none of the agents is in it, its frame has no transform at its stamp, or it cannot be
  /// read; warnings() counts the last two.
  bool edit(const std::string& topic, sensor_msgs::PointCloud2& message);

  /// Returns one line per topic with the numbers of clouds and points that edit() changed so far,
  /// and one line on the model of returns.
  std::vector<std::string> summary() const;
  /// Returns one line per topic and kind of problem, with the number of clouds that had it so far;
  /// none without problems.
  std::vector<std::string> warnings() const;

 private:
  /// The results of edit() for the clouds of a topic.
  struct Counts {
    std::size_t clouds = 0;                       ///< calls of edit()
    std::size_t changed = 0;                      ///< calls that returned true
    CloudChange points;                           ///< sum over all clouds
    std::map<std::string, std::size_t> problems;  ///< number of clouds, by text of the problem
  };

  /// Makes the topics in the setup the keys of `counts_`.
  void chooseTopics(const rosbag::Bag& source);
  /// Learns from evenly spaced clouds of each topic.
  void learn(const rosbag::Bag& source);
  /// Learns from one cloud, whose data are empty afterwards.
  void learnFrom(sensor_msgs::PointCloud2& message);
  /// Adds a cloud to `background_`, without the points on the recorded `agents`. `sensor`: pose of
  /// the cloud's frame in the map.
  void addToBackground(const PointCloud& cloud, const CloudLayout& layout, const SweepRays& sweep,
                       const Eigen::Isometry3d& sensor,
                       const std::vector<collision_forge::Agent>& agents);
  /// Returns the poses of the header's frame at the begin (`begin_time`, s after the stamp) and the
  /// end (stamp) of a sweep; nullopt without a transform at the stamp.
  std::optional<SensorInSweep> sensorOf(const std_msgs::Header& header, double begin_time) const;
  /// Does the work of edit(), and adds points and problems to `counts`.
  bool editCounted(sensor_msgs::PointCloud2& message, Counts& counts);

  Setup setup_;
  BagFrames frames_;
  SurfaceReturns surfaces_;
  BackgroundMap background_;              ///< empty without Setup::vacated
  std::map<std::string, Counts> counts_;  ///< by topic
};

}  // namespace forge
