#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/request_list.h"
#include "collision_forge/batch/progress_line.h"
#include "collision_forge/data/nuscenes_tables.h"
#include "collision_forge/data/request_file.h"
#include "collision_forge/settings/config.h"

namespace forge {
namespace {

constexpr double kMinStride = 0.01;  // s; shorter than between any two frames

struct Arguments {
  std::string dataroot;
  std::string version;
  std::vector<std::string> scenes;
  std::string out;
  std::string config;
  std::optional<double> stride;
  std::optional<double> min_ego_speed;
  std::vector<double> ttas;
  std::vector<std::string> types;
  Attackers attackers = Attackers::kAny;
  std::uint64_t seed = 0;
};

/// In their order, each once.
template <typename Value>
std::vector<Value> withoutRepeats(const std::vector<Value>& values) {
  std::vector<Value> once;
  for (const Value& value : values) {
    if (std::find(once.begin(), once.end(), value) == once.end()) once.push_back(value);
  }
  return once;
}

RequestListOptions listOptions(const Arguments& arguments, const Config& config) {
  RequestListOptions options = config.requests;
  options.stride = arguments.stride.value_or(options.stride);
  if (options.stride < kMinStride) {
    std::ostringstream complaint;
    complaint << "stride = " << options.stride << " s is less than " << kMinStride << " s";
    throw std::invalid_argument(complaint.str());
  }
  options.min_ego_speed = arguments.min_ego_speed.value_or(options.min_ego_speed);
  if (!arguments.ttas.empty()) options.ttas = arguments.ttas;
  if (!arguments.types.empty()) options.types.clear();
  for (const std::string& name : arguments.types) {
    options.types.push_back(collisionTypeFromString(name).value());
  }
  options.ttas = withoutRepeats(options.ttas);
  options.types = withoutRepeats(options.types);
  options.attackers = arguments.attackers;
  options.seed = arguments.seed;
  return options;
}

int makeRequests(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const RequestListOptions options = listOptions(arguments, config);
  const NuScenesRoot root(arguments.dataroot, arguments.version, {arguments.scenes, {}});
  const std::vector<std::string> names = root.sceneNames();
  std::vector<SceneRequest> requests;
  ProgressLine progress("scenes");
  std::size_t done = 0;
  for (const std::string& name : names) {
    const Scene scene = toScene(root.readScene(name), config.ego_vehicle, nullptr);
    for (SceneRequest& request :
         listRequests(scene, options, config.attack.prediction, config.crash.time_tolerance)) {
      requests.push_back(std::move(request));
    }
    progress.show(++done, names.size());
  }
  if (requests.empty()) {
    throw std::runtime_error("no request can be made of these scenes with these options");
  }
  writeRequests(arguments.out, requests);
  std::cout << requests.size() << " requests over " << names.size() << " scenes written to "
            << arguments.out << "\n";
  return kExitOk;
}

/// Accepts what is finite: CLI11's ranges let NaN pass.
std::string checkFinite(const std::string& text) {
  double number = 0.0;
  const bool is_number = CLI::detail::lexical_cast(text, number);
  return is_number && std::isfinite(number) ? "" : text + " is no finite number";
}

/// Accepts the names of collision types.
std::string checkType(const std::string& name) {
  return collisionTypeFromString(name) ? "" : name + " is no collision type";
}

}  // namespace

void addRequests(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMakingCollisions, "requests",
                           "Lists the collisions that can be asked for in nuScenes scenes.",
                           [arguments] { return makeRequests(*arguments); });
  addLogs(app, arguments->dataroot, arguments->version);
  addScenes(app, arguments->scenes);
  addOut(app, arguments->out, "list to write, for forge generate: one JSON a line");
  app.add_option("--stride", arguments->stride, "seconds between two instants; see requests.yaml")
      ->check(CLI::PositiveNumber)
      ->check(checkFinite);
  app.add_option("--types", arguments->types, "collision types; all by default")->check(checkType);
  app.add_option("--tta", arguments->ttas, "seconds from now to impact; see requests.yaml")
      ->check(CLI::PositiveNumber)
      ->check(checkFinite);
  app.add_option("--min-ego-speed", arguments->min_ego_speed, "m/s; see requests.yaml")
      ->check(CLI::NonNegativeNumber)
      ->check(checkFinite);
  addChoice<Attackers>(app, "--attackers", arguments->attackers,
                       {{"any", Attackers::kAny}, {"each", Attackers::kEach}},
                       "any agent, or a request for each possible one");
  addSeed(app, arguments->seed, "of every request");
  addConfig(app, arguments->config);
}

}  // namespace forge
