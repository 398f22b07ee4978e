#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "collision_forge/base/config/config_file.h"
#include "collision_forge/base/config/config_folder.h"
#include "collision_forge/planner_test/trials/planner_grid.h"
#include "collision_forge/ros/bags/topic_mapping.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

/// Reads one file of a folder of configuration.
using ReadFile = std::function<void(const std::string& folder, const std::string& name)>;

/// A file of one section.
template <class Options>
ReadFile sectionOf() {
  return [](const std::string& folder, const std::string& name) {
    Options options;
    readConfigFile(folder, name, options);
  };
}

template <class Options>
ReadFile crashSectionOf() {
  return [](const std::string& folder, const std::string& name) {
    Options options;
    readConfigFile(folder, name, options, configuration().attack.search.time_margin);
  };
}

void readAttack(const std::string& folder, const std::string& /*name*/) {
  AttackOptions options;
  readAttackOptions(folder, options);
}

void readTopics(const std::string& folder, const std::string& name) {
  readTopicMapping(folder + "/" + name + ".yaml");
}

void readPlanners(const std::string& folder, const std::string& name) {
  TrialOptions options;
  readConfigFile(openConfigFile(folder, name + ".yaml"), options,
                 configuration().attack.verification.limits);
}

/// Reads the grid and its values in planners.yaml, and requires that writing them changes nothing.
void readTuning(const std::string& folder, const std::string& name) {
  const std::string path = folder + "/planners.yaml";
  const std::string text = bytesOf(path);
  const PlannerGrid grid = readPlannerGrid(folder + "/" + name + ".yaml", "pdm");
  const PlannerValues values = readPlannerValues(path, text, grid);
  requireSame(text, withPlannerValues(path, text, values));
}

/// Returns the reader of each file that can be read alone, or with few others.
const std::map<std::string, ReadFile>& readers() {
  static const std::map<std::string, ReadFile> by_name = {
      {"adaptive", sectionOf<AdaptiveOptions>()},
      {"attacked_bag", sectionOf<AttackedBagOptions>()},
      {"believability", readAttack},
      {"conversion", sectionOf<ConversionOptions>()},
      {"crash_definition", crashSectionOf<CrashDefinition>()},
      {"drawing", sectionOf<DrawingOptions>()},
      {"ego_futures", readAttack},
      {"ego_vehicle", sectionOf<EgoVehicle>()},
      {"encoding", sectionOf<EncodingOptions>()},
      {"input_limits", sectionOf<InputLimits>()},
      {"live", sectionOf<LiveOptions>()},
      {"categories", sectionOf<std::map<std::string, AgentClass>>()},
      {"locations", sectionOf<std::map<std::string, DrivingSide>>()},
      {"models", sectionOf<ModelOptions>()},
      {"planners", readPlanners},
      {"prediction", readAttack},
      {"report", sectionOf<ReportOptions>()},
      {"requests", sectionOf<RequestListOptions>()},
      {"search", readAttack},
      {"severity", readAttack},
      {"topics_autoware", readTopics},
      {"topics_carla", readTopics},
      {"topics_derived_object", readTopics},
      {"tuning", readTuning},
      {"vehicle_limits", readAttack},
  };
  return by_name;
}

/// A copy of config/, in which one file at a time is replaced.
class ConfigCopy {
 public:
  ConfigCopy() {
    std::filesystem::copy(COLLISION_FORGE_SOURCE_DIR "/config", folder_.path(),
                          std::filesystem::copy_options::recursive);
    const ConfigFolder copied(folder_.path());
    for (const char* part : {"", "study"}) {
      for (const std::string& name : copied.files(part)) shipped_.insert(name);
    }
  }

  bool has(const std::string& name) const { return shipped_.count(name + ".yaml") > 0; }

  template <class Read>
  bool with(const std::string& name, const std::string& text, const Read& read) const {
    const std::string path = folder_.path() + "/" + name + ".yaml";
    const std::string shipped = bytesOf(path);
    const auto write = [&](const std::string& bytes) { folder_.write(name + ".yaml", bytes); };
    write(text);
    try {
      const bool is_taken = isTaken(folder_.path(), [&] { read(folder_.path(), name); });
      write(shipped);
      return is_taken;
    } catch (const Finding&) {
      write(shipped);  // the driver may continue
      throw;
    }
  }

 private:
  InputFolder folder_;
  std::set<std::string> shipped_;  // names
};

}  // namespace

/// Input: a file of config/, as a line with its name, then its text.
bool fuzzConfig(const std::string& input) {
  static const ConfigCopy copy;
  const auto [name, text] = firstLineOf(input);
  const auto reader = readers().find(name);
  if (reader != readers().end()) return copy.with(name, text, reader->second);
  if (!copy.has(name)) return false;
  return copy.with(name, text,
                   [](const auto& folder, const auto& /*name*/) { loadStudyConfig(folder); });
}

}  // namespace forge
