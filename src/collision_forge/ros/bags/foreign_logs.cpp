#include "collision_forge/ros/bags/foreign_logs.h"

#include <filesystem>
#include <mutex>
#include <utility>
#include <vector>

#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/io/maps/map_file.h"
#include "collision_forge/ros/bags/bag_reader.h"
#include "collision_forge/ros/bags/foreign_bag.h"
#include "collision_forge/ros/bags/log_sources.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

class ForeignLogs : public SceneReader {
 public:
  ForeignLogs(const std::string& bags, ForeignBags how, SceneReading reading)
      : bags_{bags, "", &bagFormat()},
        how_(std::move(how)),
        reading_(std::move(reading)),
        names_(wantedScenes(bags_, reading_.scenes)) {}

  std::vector<std::string> names() const override { return names_; }

  LoggedScene recording(const std::string& name) override {
    const std::string path =
        std::filesystem::is_directory(bags_.path) ? pathIn(bags_.path, name + ".bag") : bags_.path;
    std::vector<std::string> warnings;
    LoggedScene logged;
    logged.recording = readForeignBag(path, how_.mapping, reading_.options.ego_vehicle, &warnings);
    keepWithin(logged.recording, reading_.options, &warnings);
    if (reading_.on_warnings && !warnings.empty()) reading_.on_warnings(name, warnings);
    logged.lanes = lanesOf(path);
    logged.recording.location = logged.lanes->map().location;
    return logged;
  }

  IndexedScene read(const std::string& name) override {
    return flattened(recording(name), reading_);
  }

 private:
  std::shared_ptr<const LaneIndex> lanesOf(const std::string& path) {
    if (!how_.map.empty()) return lanesOfMap();
    if (how_.without_lanes) return std::make_shared<const LaneIndex>(std::make_shared<LaneMap>());
    const auto map = readLaneMap(path, reading_.options.input_limits);
    if (map) return std::make_shared<const LaneIndex>(map);
    throw BagError(path + ": no message on " + bagTopic(names::kLaneMap) +
                   "; --map gives the map, --without-lanes converts without one");
  }

  /// Returns the lanes of the map file, read at the first call.
  std::shared_ptr<const LaneIndex> lanesOfMap() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (lanes_) return lanes_;
    std::vector<std::string> warnings;
    lanes_ = std::make_shared<const LaneIndex>(
        std::make_shared<const LaneMap>(readMapFile(how_.map, reading_.options, &warnings)));
    if (reading_.on_warnings && !warnings.empty()) {
      reading_.on_warnings("map " + lanes_->map().location, warnings);
    }
    return lanes_;
  }

  LogSource bags_;
  ForeignBags how_;
  SceneReading reading_;
  std::vector<std::string> names_;
  std::mutex mutex_;
  std::shared_ptr<const LaneIndex> lanes_;
};

}  // namespace

std::unique_ptr<SceneReader> openForeignBags(const std::string& bags, ForeignBags how,
                                             SceneReading reading) {
  return std::make_unique<ForeignLogs>(bags, std::move(how), std::move(reading));
}

}  // namespace forge
