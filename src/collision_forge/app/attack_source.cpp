#include "collision_forge/app/attack_source.h"

#include <fstream>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>

#include "collision_forge/app/options.h"
#include "collision_forge/base/files/fingerprint.h"
#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/json/input_line.h"
#include "collision_forge/io/logs/nuscenes_map_layers.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"
#include "collision_forge/ros/bags/bag_reader.h"

namespace forge {
namespace {

/// Caches the arc geometry of the lanes by location. Logs other than nuScenes have none.
/// Thread-safe.
class ArcSource {
 public:
  ArcSource(LogSource logs, const InputLimits& limits) : logs_(std::move(logs)), limits_(limits) {}

  const LaneArcs& at(const std::string& location) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = arcs_.find(location);
    if (found != arcs_.end()) return found->second;
    if (logs_.format != &nuScenesFormat()) return arcs_[location];
    WarningCounter warnings;  // dropped: reading the lanes prints the same warnings
    const std::string path = pathIn(logs_.path + "/maps/expansion", location + ".json");
    return arcs_.emplace(location, readNuScenesMapLayers(path, limits_, warnings).arclines)
        .first->second;
  }

 private:
  LogSource logs_;
  const InputLimits& limits_;
  std::mutex mutex_;
  std::map<std::string, LaneArcs> arcs_;
};

/// The attacks of a scenario file.
struct AttackLines {
  struct Line {
    std::size_t number;  ///< from 1
    Scenario scenario;
  };
  std::string path;
  std::vector<Line> lines;
  std::vector<std::string> scenes;  ///< names, in order of first use
  std::size_t scenarios = 0;        ///< lines of the file
  std::string fingerprint;

  std::string where(std::size_t number) const { return path + ": line " + std::to_string(number); }
};

AttackLines readAttacks(const std::string& path, const InputLimits& limits) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  AttackLines found;
  found.path = path;
  std::set<std::string> seen;
  for (std::string text; readInputLine(file, text, found.where(found.scenarios + 1), limits);) {
    found.fingerprint = fingerprint(text, found.fingerprint);
    Scenario scenario = readScenarioLine(found.where(++found.scenarios), text, limits);
    if (scenario.answer.status.code != StatusCode::kOk) continue;
    if (seen.insert(scenario.asked.scene).second) found.scenes.push_back(scenario.asked.scene);
    found.lines.push_back({found.scenarios, std::move(scenario)});
  }
  if (found.lines.empty()) throw std::runtime_error(path + ": has no attacks");
  return found;
}

class ScenarioAttacks : public AttackSource {
 public:
  ScenarioAttacks(const std::string& path, const LogSource& logs, int jobs, const Config& config)
      : config_(config),
        logs_(logs),
        attacks_(readAttacks(path, config.input_limits)),
        scenes_(logs, attacks_.scenes, config, static_cast<std::size_t>(jobs) + 1, printWarnings,
                showReading()),
        arcs_(logs, config.input_limits) {}

  std::size_t count() const override { return attacks_.lines.size(); }

  std::size_t numberOf(std::size_t index) const override { return attacks_.lines[index].number; }

  std::string where(std::size_t index) const override { return attacks_.where(numberOf(index)); }

  std::string described() const override { return counted(attacks_.scenarios, "scenario"); }

  std::map<std::string, std::string> fingerprints() const override {
    std::map<std::string, std::string> found = fingerprintsOf(logs_);
    found["scenarios"] = described() + ", fingerprint " + attacks_.fingerprint;
    return found;
  }

  CrashRecord record(std::size_t index, double history) override {
    const Scenario& scenario = attacks_.lines[index].scenario;
    const auto indexed = scenes_.at(scenario.asked.scene);
    return crashRecord(scenario, numberOf(index), history,
                       {*indexed, arcs_.at(indexed->scene.map->location), config_.exports,
                        config_.attack.verification});
  }

 private:
  const Config& config_;
  LogSource logs_;
  const AttackLines attacks_;
  SceneSource scenes_;
  ArcSource arcs_;
};

class BagAttacks : public AttackSource {
 public:
  BagAttacks(std::vector<std::string> paths, const Config& config)
      : config_(config), paths_(std::move(paths)) {}

  std::size_t count() const override { return paths_.size(); }
  std::size_t numberOf(std::size_t index) const override { return index + 1; }
  std::string where(std::size_t index) const override { return paths_[index]; }
  std::string described() const override { return counted(paths_.size(), "bag"); }

  std::map<std::string, std::string> fingerprints() const override {
    std::map<std::string, std::string> found;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      found["bag " + std::to_string(i + 1)] = fingerprintOfFile(paths_[i]);
    }
    return found;
  }

  CrashRecord record(std::size_t index, double history) override {
    const std::string& path = paths_[index];
    const Scenario scenario = readAttack(path, config_, config_.crash);
    IndexedScene indexed{readBag(path, config_), nullptr};
    indexed.lanes = std::make_shared<LaneIndex>(indexed.scene.map);
    return crashRecord(scenario, numberOf(index), history,
                       {indexed, {}, config_.exports, config_.attack.verification});
  }

 private:
  const Config& config_;
  std::vector<std::string> paths_;
};

}  // namespace

std::unique_ptr<AttackSource> openScenarioAttacks(const std::string& path, const LogSource& logs,
                                                  int jobs, const Config& config) {
  return std::make_unique<ScenarioAttacks>(path, logs, jobs, config);
}

std::unique_ptr<AttackSource> openBagAttacks(const std::vector<std::string>& paths,
                                             const Config& config) {
  return std::make_unique<BagAttacks>(paths, config);
}

}  // namespace forge
