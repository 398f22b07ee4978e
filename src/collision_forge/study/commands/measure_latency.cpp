#include <collision_forge/GenerateCollision.h>
#include <ros/ros.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/planner_test/statistics/statistics.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/study/commands/study_commands.h"

namespace forge {
namespace {

struct Arguments {
  collision_forge::GenerateCollision::Request request;
  Mode mode = Mode::kHistory;
  int calls = 1000;
};

int measure(const Arguments& arguments) {
  ros::init(ros::M_string(), "forge", ros::init_options::AnonymousName);
  ros::NodeHandle node;
  const std::string service = node.resolveName(names::kGenerateCollision);
  if (!ros::service::waitForService(service, ros::Duration(10.0))) {
    throw std::runtime_error("the service " + service +
                             " did not appear within 10 s; start collision_forge.launch first");
  }
  std::vector<double> milliseconds;
  std::map<int, int> codes;
  int failures = 0;
  ProgressLine progress("calls");
  for (int i = 0; i < arguments.calls; ++i) {
    progress.show(static_cast<std::size_t>(i), static_cast<std::size_t>(arguments.calls));
    collision_forge::GenerateCollision call;
    call.request = arguments.request;
    call.request.mode = toString(arguments.mode);
    call.request.seed = static_cast<std::uint64_t>(i);
    const auto start = std::chrono::steady_clock::now();
    if (!ros::service::call(service, call)) {
      ++failures;
      continue;
    }
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    milliseconds.push_back(elapsed.count());
    ++codes[call.response.code];
  }
  if (milliseconds.empty()) {
    throw std::runtime_error("all " + std::to_string(arguments.calls) + " calls of " + service +
                             " failed");
  }
  std::cout << "first " << milliseconds.front() << " ms";
  std::sort(milliseconds.begin(), milliseconds.end());
  std::cout << ", p50 " << quantile(milliseconds, 0.5) << " ms, p99 "
            << quantile(milliseconds, 0.99) << " ms of " << arguments.calls << " calls; failed "
            << failures << "; codes:";
  for (const auto& [code, count] : codes) std::cout << " " << code << " x" << count;
  std::cout << "\n";
  return kExitOk;
}

}  // namespace

void addMeasureLatency(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMeasuring, "study measure latency",
                           "Measures the latency of the service generate_collision over TCPROS.",
                           [arguments] { return measure(*arguments); });
  auto& request = arguments->request;
  request.collision_type = "rear_end";
  request.tta = 4.0;
  app.add_option("--type", request.collision_type, "requested collision type")
      ->check(checkType)
      ->capture_default_str();
  app.add_option("--tta", request.tta, "time to attack, s: time from t0 to contact")
      ->capture_default_str();
  addMode(app, arguments->mode, false);
  app.add_option("--calls", arguments->calls, "number of calls, with seeds 0, 1, ...")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

}  // namespace forge
