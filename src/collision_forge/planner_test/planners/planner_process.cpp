#include "collision_forge/planner_test/planners/planner_process.h"

#include <charconv>
#include <stdexcept>
#include <utility>

#include "collision_forge/planner_test/planners/planner_protocol.h"

namespace forge {
namespace {

// s until a process is killed that has lost its input: a node ends its master and its launch file
constexpr double kProcessGrace = 1.0;
constexpr double kNodeGrace = 15.0;
constexpr double kNodeDelay = 1.0;  // s; planner_node reports the timeout of its node before
constexpr std::size_t kLongestLine = 16000000;  // bytes; a plan of 5000 points has less than 1 MB

std::string shortest(double value) {
  char digits[32];
  return std::string(digits, std::to_chars(digits, digits + sizeof(digits), value).ptr);
}

std::vector<std::string> commandOf(const PlannerProcessOptions& options) {
  std::vector<std::string> command;
  if (options.is_node) {
    command = {packageProgram("planner_node"), shortest(options.timeout),
               shortest(options.start_timeout), options.command};
  } else {
    command = {"/usr/bin/env"};
  }
  for (const auto& [name, value] : options.parameters) {
    command.push_back(name + "=" + shortest(value));
  }
  if (!options.is_node) command.insert(command.end(), {"/bin/sh", "-c", options.command});
  return command;
}

}  // namespace

std::string processKey(const PlannerProcessOptions& options) {
  std::string key = (options.is_node ? "node " : "process ") + options.command;
  for (const auto& [name, value] : options.parameters) key += '\n' + name + '=' + shortest(value);
  return key;
}

PlannerProcess::PlannerProcess(const PlannerProcessOptions& options)
    : options_(options),
      key_(processKey(options)),
      process_(commandOf(options), WorkerStream::kStandard,
               options.is_node ? kNodeGrace : kProcessGrace) {
  if (options_.is_node) {
    options_.timeout += kNodeDelay;
    options_.start_timeout += kNodeDelay;
  }
  try {
    process_.setTimeout(options_.start_timeout);
    checkReadyLine(process_.receiveLine(kLongestLine));
  } catch (const std::exception& error) {
    throw PlannerFileError(options_.command + ": before its first line: " + error.what());
  }
}

void PlannerProcess::begin(const DrivingTask& task, double interval) {
  ask(beginLine(task, interval));
}

std::vector<TrajectoryPoint> PlannerProcess::plan(const Observation& observation) {
  return ask(planLine(observation));
}

std::vector<TrajectoryPoint> PlannerProcess::ask(const std::string& line) {
  is_usable_ = false;
  try {
    process_.setTimeout(options_.timeout);
    const std::string request = line + '\n';
    process_.send(request.data(), request.size());
    std::vector<TrajectoryPoint> points = readPlanResponse(process_.receiveLine(kLongestLine));
    is_usable_ = true;
    return points;
  } catch (const WorkerTimeout& error) {
    throw PlannerTimeout(options_.command + ": " + error.what());
  } catch (const PlannerTimeout& error) {
    throw PlannerTimeout(options_.command + ": " + error.what());
  } catch (const LatePlan& error) {
    throw LatePlan(options_.command + ": " + error.what());
  } catch (const std::exception& error) {
    throw std::runtime_error(options_.command + ": " + error.what());
  }
}

ProcessPlanner::~ProcessPlanner() { giveBack(); }

void ProcessPlanner::giveBack() {
  if (process_) options_.processes->giveBack(std::move(process_));
}

void ProcessPlanner::start() {
  if (options_.command.empty()) {
    throw PlannerFileError(
        "the planner external needs --planner-command (a process that uses the line protocol) or "
        "--planner-node (a ROS node)");
  }
  giveBack();
  process_ = options_.processes->take(options_, processKey(options_));
}

void ProcessPlanner::initialize(const DrivingTask& task) {
  start();
  process_->begin(task, options_.interval);
}

std::vector<TrajectoryPoint> ProcessPlanner::plan(const Observation& observation) {
  return process_->plan(observation);
}

}  // namespace forge
