#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/bag_frames.h"
#include "collision_forge/ros/bags/older_message.h"
#include "collision_forge/ros/bags/read_opened.h"
#include "collision_forge/ros/injection/agent_body.h"
#include "collision_forge/ros/messages/cloud_message.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/evaluation/lidar_replacement.h"
#include "collision_forge/study/evaluation/two_samples.h"

namespace forge {
namespace {

struct Arguments {
  std::string bag;
  std::string topic;
  ReplacementOptions options;
  ConfigFolder config;
};

/// Returns the vehicles and pedestrians of a frame in the frame of a cloud.
std::vector<VehicleInCloud> vehiclesIn(const collision_forge::AgentArray& agents,
                                       const Eigen::Isometry3d& sensor) {
  std::vector<VehicleInCloud> vehicles;
  for (const collision_forge::Agent& agent : agents.agents) {
    const auto agent_class = static_cast<AgentClass>(agent.agent_class);
    if (!isVehicle(agent_class) && !isOnFoot(agent_class)) continue;
    vehicles.push_back({agent.id,
                        agent_class,
                        sensor.inverse() * bottomOf(agent),
                        {agent.size.x, agent.size.y, agent.size.z}});
  }
  return vehicles;
}

/// Returns the processor time, ms, that one car in a cloud takes, from the message's cloud to the
/// changed one.
double timeOfCar(PointCloud cloud, const SweepTiming& timing) {
  PosedBody car;
  car.body = lidarBodyOf(AgentClass::kCar, {4.6, 1.9, 1.5});
  car.end = Eigen::Isometry3d(Eigen::Translation3d(0.0, 12.0, -1.8));
  car.begin = car.end;
  const std::clock_t start = std::clock();
  const CloudLayout layout(cloud);
  editCloud(cloud, layout, raysOf(cloud, layout, timing), {{car}, {}, nullptr, 0.02, 0}, {});
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The outcome over a bag.
struct Measured {
  std::vector<ReplacedVehicle> vehicles;
  std::vector<double> milliseconds;  ///< of timeOfCar(), by cloud
  std::size_t points = 0;            ///< of all these clouds
};

/// Replaces the vehicles of all clouds that have the stamp of a frame of agents.
Measured measureIn(const rosbag::Bag& bag, const Arguments& arguments,
                   const LidarOptions& options) {
  BagFrames frames(names::kMapFrame, names::kBaseFrame, kLongestBag);
  addTransforms(bag, frames);
  std::map<ros::Time, collision_forge::AgentArray> agents;
  for (const auto& instance : rosbag::View(bag, rosbag::TopicQuery(bagTopic(names::kAgents)))) {
    if (const auto frame = readMessage<collision_forge::AgentArray>(instance)) {
      agents[frame->header.stamp] = *frame;
    }
  }
  Measured measured;
  for (const auto& instance : rosbag::View(bag, rosbag::TopicQuery(arguments.topic))) {
    const auto message = instance.instantiate<sensor_msgs::PointCloud2>();
    if (!message) throw BagError(arguments.topic + " has no sensor_msgs/PointCloud2");
    const SweepTiming timing{message->header.stamp.toSec(), options.sweep_time};
    const auto frame = agents.find(message->header.stamp);
    const auto sensor = frames.poseOf(frameName(message->header.frame_id), message->header.stamp);
    const PointCloud cloud = takeCloud(*message);
    measured.milliseconds.push_back(timeOfCar(cloud, timing));
    measured.points += cloud.pointCount();
    if (frame == agents.end() || !sensor) continue;
    for (const ReplacedVehicle& vehicle :
         replaceVehicles(cloud, timing, vehiclesIn(frame->second, *sensor), arguments.options)) {
      measured.vehicles.push_back(vehicle);
    }
  }
  return measured;
}

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? std::nan("") : values[values.size() / 2];
}

/// Returns the features of recorded and injected vehicles, grouped by vehicle.
TwoSamples samplesOf(const std::vector<ReplacedVehicle>& vehicles) {
  TwoSamples samples;
  for (const ReplacedVehicle& vehicle : vehicles) {
    samples.first.push_back(vehicle.recorded_features);
    samples.second.push_back(vehicle.injected_features);
    samples.groups.push_back(vehicle.id);
  }
  return samples;
}

/// Returns the area of separate() and the one by chance; "-" if there are too few vehicles.
std::string areaWords(const std::vector<ReplacedVehicle>& vehicles, std::uint64_t seed) {
  const auto area = separate(samplesOf(vehicles), seed);
  return area ? formatted("%.2f %6.2f", area->area, area->chance_area) : "   -      -";
}

/// Prints the area of each feature alone: the share of pairs of a recorded and an injected
/// vehicle in which the injected one has the larger value.
void printFeatures(const std::vector<ReplacedVehicle>& vehicles) {
  if (vehicles.empty()) return;
  std::cout << "area by one feature:";
  const char* separator = " ";
  for (std::size_t i = 0; i < std::size(kPointFeatures); ++i) {
    std::vector<double> recorded;
    std::vector<double> injected;
    for (const ReplacedVehicle& vehicle : vehicles) {
      recorded.push_back(vehicle.recorded_features[static_cast<Eigen::Index>(i)]);
      injected.push_back(vehicle.injected_features[static_cast<Eigen::Index>(i)]);
    }
    std::cout << separator << kPointFeatures[i]
              << formatted(" %.2f", areaUnderCurve(recorded, injected));
    separator = ", ";
  }
  std::cout << "\n";
}

/// Prints medians over some vehicles, and the area of a classifier (separate()).
void printRow(const std::string& name, const std::vector<ReplacedVehicle>& vehicles,
              std::uint64_t seed) {
  const auto median = [&](const auto& value) {
    std::vector<double> values;
    for (const ReplacedVehicle& vehicle : vehicles) values.push_back(value(vehicle));
    return medianOf(values);
  };
  const auto change = [](const ReplacedVehicle& vehicle) {
    return static_cast<double>(vehicle.injected) / static_cast<double>(vehicle.recorded) - 1.0;
  };
  std::cout << formatted(
      "%-24s %5zu %8.0f %8.0f %+7.0f %7.0f %8.2f %9.2f %9.2f %6.2f %6.2f %5.0f %5.0f  %s\n",
      name.c_str(), vehicles.size(),
      median([](const auto& v) { return static_cast<double>(v.recorded); }),
      median([](const auto& v) { return static_cast<double>(v.injected); }), 100.0 * median(change),
      100.0 * median([&](const auto& v) { return std::abs(change(v)); }),
      median([](const auto& v) { return v.ring_overlap; }),
      median([](const auto& v) { return v.recorded_share; }),
      median([](const auto& v) { return v.injected_share; }),
      median([](const auto& v) { return v.distance; }),
      median([](const auto& v) { return v.floor; }),
      median([](const auto& v) { return v.recorded_brightness; }),
      median([](const auto& v) { return v.injected_brightness; }),
      areaWords(vehicles, seed).c_str());
}

int measure(Arguments arguments) {
  const Config config = loadConfig(arguments.config);
  arguments.options.range_noise = config.lidar.range_noise;
  const Measured measured = readOpened(arguments.bag, [&](const rosbag::Bag& bag) {
    return measureIn(bag, arguments, config.lidar);
  });
  std::cout << "class, range m             n recorded injected change%  |change|% rings  share_rec "
               "share_inj chamfer floor intensity rec inj  area chance\n";
  constexpr double kRanges[] = {0.0, 10.0, 20.0, 30.0, 50.0, 200.0};  // m
  for (int i = 0; i <= static_cast<int>(kLastAgentClass); ++i) {
    for (std::size_t k = 0; k + 1 < std::size(kRanges); ++k) {
      std::vector<ReplacedVehicle> some;
      for (const ReplacedVehicle& vehicle : measured.vehicles) {
        if (vehicle.agent_class == static_cast<AgentClass>(i) && vehicle.range >= kRanges[k] &&
            vehicle.range < kRanges[k + 1]) {
          some.push_back(vehicle);
        }
      }
      if (some.empty()) continue;
      printRow(formatted("%s, %.0f to %.0f", toString(static_cast<AgentClass>(i)), kRanges[k],
                         kRanges[k + 1]),
               some, arguments.options.seed);
    }
  }
  printRow("all", measured.vehicles, arguments.options.seed);
  printFeatures(measured.vehicles);
  std::vector<double> milliseconds = measured.milliseconds;
  if (milliseconds.empty()) return kExitOk;
  std::sort(milliseconds.begin(), milliseconds.end());
  std::cout << formatted(
      "one car in a cloud: p50 %.1f ms, p99 %.1f ms of %zu clouds of %zu points\n",
      milliseconds[milliseconds.size() / 2], milliseconds[milliseconds.size() * 99 / 100],
      milliseconds.size(), measured.points / milliseconds.size());
  return kExitOk;
}

}  // namespace

void addMeasureLidar(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  arguments->topic = "/lidar_top";
  CLI::App& app = line.add(kMeasuring, "study measure lidar",
                           "Takes recorded vehicles out of lidar clouds, puts bodies in their "
                           "place and compares both.",
                           [arguments] { return measure(*arguments); });
  app.add_option("--bag", arguments->bag, "bag with clouds and agents")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--topic", arguments->topic, "topic of the clouds");
  app.add_option("--least-points", arguments->options.least_points,
                 "recorded points that a vehicle needs");
  addSeed(app, arguments->options.seed, "random seed of the returns");
  addConfig(app, arguments->config);
}

}  // namespace forge
