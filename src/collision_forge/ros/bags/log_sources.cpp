#include "collision_forge/ros/bags/log_sources.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <utility>

#include "collision_forge/io/logs/scenario_net_logs.h"
#include "collision_forge/io/logs/unknown_source.h"
#include "collision_forge/io/maps/common_road_logs.h"
#include "collision_forge/ros/bags/bag_reader.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

bool isBag(const fs::path& path) { return path.extension() == ".bag" && fs::is_regular_file(path); }

/// Returns the paths of the bag or of the bags in the folder, sorted.
std::vector<fs::path> bagsAt(const std::string& path) {
  if (isBag(path)) return {path};
  std::vector<fs::path> bags;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(path, ignored)) {
    if (isBag(entry.path())) bags.push_back(entry.path());
  }
  std::sort(bags.begin(), bags.end());
  return bags;
}

bool hasBags(const std::string& path) { return !bagsAt(path).empty(); }

std::string nameOf(const fs::path& bag) { return bag.stem().string(); }

std::vector<std::string> namesIn(const LogSource& source) {
  std::vector<std::string> names;
  for (const fs::path& bag : bagsAt(source.path)) names.push_back(nameOf(bag));
  if (names.empty()) throw BagError(unknownSourceText(source.path));
  return names;
}

class BagLogs : public SceneReader {
 public:
  BagLogs(const LogSource& source, SceneReading reading)
      : reading_(std::move(reading)),
        names_(wantedScenes(source, reading_.scenes)),
        folder_(isBag(source.path) ? fs::path(source.path).parent_path() : fs::path(source.path)) {}

  std::vector<std::string> names() const override { return names_; }

  IndexedScene read(const std::string& name) override {
    std::vector<std::string> warnings;
    Scene scene =
        readBagAsWritten((folder_ / (name + ".bag")).string(), reading_.options, &warnings);
    if (reading_.on_warnings && !warnings.empty()) reading_.on_warnings(name, warnings);
    auto lanes = std::make_shared<const LaneIndex>(scene.map);
    return {std::move(scene), std::move(lanes)};
  }

  LoggedScene recording(const std::string& name) override {
    read(name);
    throw std::runtime_error("is a bag of this suite; only --to scenarionet can convert it");
  }

 private:
  SceneReading reading_;
  std::vector<std::string> names_;
  fs::path folder_;
};

std::unique_ptr<SceneReader> openBags(const LogSource& source, const SceneReading& reading) {
  return std::make_unique<BagLogs>(source, reading);
}

}  // namespace

const LogFormat& bagFormat() {
  static const LogFormat format{"bags", hasBags, namesIn, openBags};
  return format;
}

LogSource logSourceAt(const std::string& path, const std::string& version) {
  for (const LogFormat* format : {&bagFormat(), &scenarioNetFormat(), &commonRoadFormat()}) {
    if (format->accepts(path)) return {path, version, format};
  }
  return {path, version};
}

}  // namespace forge
