#include "collision_forge/io/logs/city_maps.h"

#include <utility>

#include "collision_forge/io/logs/nuscenes_map.h"

namespace forge {

CityMaps::CityMaps(const std::string& dataroot, const DataOptions& options, OnWarnings on_warnings)
    : dataroot_(dataroot), options_(options), on_warnings_(std::move(on_warnings)) {}

std::shared_ptr<const LaneIndex> CityMaps::at(const std::string& city) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::shared_ptr<const LaneIndex>& lanes = maps_[city];
  if (lanes) return lanes;
  std::vector<std::string> warnings;
  lanes = std::make_shared<const LaneIndex>(std::make_shared<const LaneMap>(readNuScenesMap(
      dataroot_, city, drivingSide(options_, city),
      {options_.conversion.centerline_resolution, options_.input_limits}, &warnings)));
  if (on_warnings_ && !warnings.empty()) on_warnings_("map " + city, warnings);
  return lanes;
}

}  // namespace forge
