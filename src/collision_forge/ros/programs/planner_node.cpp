#include <arpa/inet.h>
#include <collision_forge/LaneMap.h>
#include <netinet/in.h>
#include <ros/ros.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "collision_forge/base/files/worker_process.h"
#include "collision_forge/planner_test/planners/planner_protocol.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/nodes/external_planner.h"
#include "collision_forge/ros/nodes/node_support.h"

/// usage: planner_node TIMEOUT START_TIMEOUT COMMAND [NAME=VALUE...]
///
/// Lets a planner in a ROS node take part in `forge test`: speaks the line protocol of
/// planner_protocol.h on stdin and stdout, and the topics of ExternalPlanner with the node that the
/// shell command COMMAND starts. The node has a ROS master of its own, on a free port of this
/// machine, whose parameters are NAME=VALUE. TIMEOUT and START_TIMEOUT are in s of the wall clock:
/// for a plan, and until the node is connected. When stdin ends, node and master get SIGINT.
namespace forge {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPoll(20);
constexpr double kNodeGrace = 10.0;   // s after SIGINT until node or launch file are killed
constexpr double kMasterGrace = 0.0;  // s; a master keeps nothing

/// Returns a TCP port that is free now.
int freePort() {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  const bool found =
      socket >= 0 && bind(socket, generic, size) == 0 && getsockname(socket, generic, &size) == 0;
  close(socket);
  if (!found) throw std::runtime_error("no free TCP port on this machine");
  return ntohs(address.sin_port);
}

/// A process that gets SIGINT when its object ends. Its stdin is empty.
class Interrupted {
 public:
  Interrupted(const std::string& command, double grace)
      : process_({"/bin/sh", "-c", "exec < /dev/null; " + command}, WorkerStream::kOwn, grace) {}
  ~Interrupted() { process_.interrupt(); }
  bool hasEnded() const { return process_.hasEnded(); }

 private:
  WorkerProcess process_;
};

struct Arguments {
  double timeout = 0.0;        // s
  double start_timeout = 0.0;  // s
  std::string command;
  std::vector<std::string> parameters;  // NAME=VALUE
};

Arguments parse(int argc, char** argv) {
  if (argc < 4) throw std::runtime_error("usage: planner_node TIMEOUT START_TIMEOUT COMMAND ...");
  return {std::stod(argv[1]), std::stod(argv[2]), argv[3], {argv + 4, argv + argc}};
}

/// Waits until `is_done` returns true. Throws if `process` ends before or the time is over.
template <class IsDone>
void await(const IsDone& is_done, const Interrupted& process, Clock::time_point deadline,
           const std::string& what) {
  while (!is_done()) {
    if (process.hasEnded()) throw std::runtime_error(what + ": the process has ended");
    if (Clock::now() > deadline) throw std::runtime_error(what + ": not in time");
    std::this_thread::sleep_for(kPoll);
  }
}

void setParameters(const std::vector<std::string>& parameters) {
  for (const std::string& parameter : parameters) {
    const std::size_t separator = parameter.find('=');
    ros::param::set('/' + parameter.substr(0, separator),
                    std::stod(parameter.substr(separator + 1)));
  }
}

/// Answers the requests on stdin until it ends. Topics arrive in any order: a map has the time of
/// the first state of its case as its stamp, so that the node does not use the map of another case.
void serve(ExternalPlanner& planner, ExternalOptions options, ros::Publisher& maps) {
  std::shared_ptr<const LaneIndex> lanes;  // not published yet
  std::cout << readyLine() << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    try {
      const PlanRequest request = readPlanRequest(line);
      if (request.is_begin) {
        lanes = request.task.lanes;
        options.interval = request.interval;
        planner.setOptions(options);
        planner.initialize(request.task);
        std::cout << begunLine() << std::endl;
      } else {
        if (lanes) maps.publish(toMessage(lanes->map(), stampOf(request.observation.ego.time)));
        lanes.reset();
        std::cout << pointsLine(planner.plan(request.observation)) << std::endl;
      }
    } catch (const std::exception& error) {
      std::cout << errorLine(error) << std::endl;
    }
  }
}

void run(const Arguments& arguments) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(arguments.start_timeout));
  const std::string port = std::to_string(freePort());
  setenv("ROS_MASTER_URI", ("http://localhost:" + port).c_str(), 1);
  setenv("ROS_HOSTNAME", "localhost", 1);
  unsetenv("ROS_IP");
  const Interrupted master("exec rosmaster --core -p " + port, kMasterGrace);
  ros::init(ros::M_string(), "planner_node",
            ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
  await([] { return ros::master::check(); }, master, deadline, "the ROS master");
  setParameters(arguments.parameters);
  ros::NodeHandle node;
  Config config = loadConfig(packageConfig(""));
  config.planners.external.timeout = arguments.timeout;
  ExternalPlanner planner(node, config.planners.external, config.input_limits);
  ros::Publisher maps = node.advertise<collision_forge::LaneMap>(names::kTestedMap, 1, true);
  const Interrupted planner_node(arguments.command, kNodeGrace);
  await([&] { return planner.isConnected(); }, planner_node, deadline,
        "a node that subscribes to planning_state and publishes planned_trajectory");
  serve(planner, config.planners.external, maps);
  ros::shutdown();
}

}  // namespace
}  // namespace forge

int main(int argc, char** argv) {
  try {
    forge::run(forge::parse(argc, argv));
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cout << forge::errorLine(error) << std::endl;
    return EXIT_FAILURE;
  }
}
