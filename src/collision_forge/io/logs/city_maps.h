#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Called with a subject and what is odd about it; on any thread, one at a time.
using OnWarnings =
    std::function<void(const std::string& subject, const std::vector<std::string>& warnings)>;

/// The maps of a nuScenes root, each read when it is first asked for. Thread-safe.
class CityMaps {
 public:
  CityMaps(const std::string& dataroot, const DataOptions& options, OnWarnings on_warnings = {});

  /// Throws as readNuScenesMap() and drivingSide().
  std::shared_ptr<const LaneIndex> at(const std::string& city);

 private:
  std::string dataroot_;
  DataOptions options_;
  OnWarnings on_warnings_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const LaneIndex>> maps_;
};

}  // namespace forge
