#pragma once

#include <torch/script.h>

#include <string>

#include "collision_forge/planner_test/planners/torchscript_planner.h"
#include "io/logs/nuscenes_fixture.h"
#include "planner_test/planners/planner_scenes.h"

namespace forge {

inline const char* const kContractArguments =
    "self, ego_history, agents, agents_mask, lanes, lanes_mask, route";

inline const char* const kTrafficArguments =
    "self, ego_history, agents, agents_mask, lanes, lanes_mask, step";

/// A forward() body of a traffic model in which every agent keeps its velocity.
inline const char* const kSteadyTraffic =
    "    now = agents[:, -1]\n"
    "    return torch.cat([now[:, 0:2] + step * now[:, 3:5], now[:, 2:3]], 1)\n";

/// A forward() body that keeps speed and heading.
inline const char* const kConstantVelocity =
    "    times = 0.1 * torch.arange(1, 81).float()\n"
    "    still = torch.zeros([80])\n"
    "    return torch.stack([ego_history[-1, 3] * times, still, still], 1)\n";

/// Creates a module whose forward() has these arguments and this body.
inline torch::jit::Module scriptOf(const std::string& body,
                                   const std::string& arguments = kContractArguments) {
  torch::jit::Module module("Planner");
  module.register_buffer("count", torch::zeros({1}));
  module.define("def forward(" + arguments + "):\n" + body);
  return module;
}

/// A folder that contains a file of such a module.
class ScriptFile {
 public:
  explicit ScriptFile(const std::string& body, const std::string& arguments = kContractArguments) {
    scriptOf(body, arguments).save(path());
  }

  std::string path() const { return folder_.path() + "/planner.pt"; }
  TorchscriptOptions options() const { return optionsOf(path()); }

  /// The shipped options with this file, on the processor.
  static TorchscriptOptions optionsOf(const std::string& path) {
    TorchscriptOptions options = shippedConfig().planners.torchscript;
    options.workers = std::make_shared<PlannerWorkers>();
    options.file = path;
    options.device = "cpu";
    return options;
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace forge
