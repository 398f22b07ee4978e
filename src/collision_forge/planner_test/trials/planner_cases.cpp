#include "collision_forge/planner_test/trials/planner_cases.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <stdexcept>

#include "collision_forge/base/files/fingerprint.h"
#include "collision_forge/io/json/input_line.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// A line of a scenario file.
struct ScenarioLine {
  std::string where;
  std::optional<Scenario> scenario;  ///< set if the line is valid
  std::string error;                 ///< otherwise the reason
};

struct ScenarioLines {
  std::vector<ScenarioLine> lines;
  std::string fingerprint;

  void add(const std::string& path, const InputLimits& limits) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    int number = 1;
    const auto where = [&] { return path + ": line " + std::to_string(number); };
    for (std::string text; readInputLine(file, text, where(), limits); ++number) {
      fingerprint = forge::fingerprint(text, fingerprint);
      try {
        lines.push_back({where(), readScenarioLine(where(), text, limits), ""});
      } catch (const JsonLineError& error) {
        lines.push_back({where(), std::nullopt, error.what()});
      }
    }
    if (number == 1) throw std::runtime_error(path + ": contains no scenarios");
  }
};

class ScenarioCases : public PlannerCases {
 public:
  ScenarioCases(const std::vector<std::string>& paths, const LogSource& logs,
                std::size_t scenes_kept, const AnswerOptions& options,
                const NuScenesProgress& on_progress)
      : options_(options) {
    std::set<std::string> sources;
    for (const std::string& path : paths) {
      const std::string source = fs::path(path).stem().string();
      if (!sources.insert(source).second) {
        throw std::runtime_error(
            "two scenario files have the same name, which names their cases; rename one: " +
            source);
      }
      const std::size_t before = read_.lines.size();
      read_.add(path, options.input_limits);
      for (std::size_t i = before; i < read_.lines.size(); ++i) {
        names_.push_back(source + ":" + std::to_string(i - before + 1));
        sources_.push_back(source);
      }
    }
    const auto known = readSceneNames(logs);
    known_.insert(known.begin(), known.end());
    const std::vector<std::string> wanted = wantedScenes();
    if (!wanted.empty()) {
      scenes_ = std::make_unique<SceneSource>(logs, wanted, options, scenes_kept, OnWarnings(),
                                              on_progress);
    }
  }

  const std::vector<std::string>& names() const override { return names_; }

  std::string fingerprint() const override {
    return std::to_string(names_.size()) + " scenarios, fingerprint " + read_.fingerprint;
  }

  PlannerCase at(std::size_t index) const override {
    const ScenarioLine& line = read_.lines[index];
    if (!line.scenario) throw std::runtime_error(line.error);
    const Scenario& scenario = *line.scenario;
    if (known_.count(scenario.asked.scene) == 0) {
      throw std::runtime_error(line.where + ": scene = \"" + scenario.asked.scene +
                               "\" is not in the data; check --source");
    }
    PlannerCase one = caseOfScenario(scenario, *scenes_->at(scenario.asked.scene), options_);
    one.name = names_[index];
    one.source = sources_[index];
    return one;
  }

 private:
  /// Loads the scenes that exist, for the valid lines in their order.
  std::vector<std::string> wantedScenes() const {
    std::vector<std::string> wanted;
    std::set<std::string> seen;
    for (const ScenarioLine& line : read_.lines) {
      if (!line.scenario) continue;
      const std::string& scene = line.scenario->asked.scene;
      if (known_.count(scene) > 0 && seen.insert(scene).second) wanted.push_back(scene);
    }
    return wanted;
  }

  const AnswerOptions& options_;
  ScenarioLines read_;
  std::vector<std::string> names_;
  std::vector<std::string> sources_;
  std::set<std::string> known_;
  std::unique_ptr<SceneSource> scenes_;
};

}  // namespace

std::set<std::string> readScenes(const std::vector<std::string>& paths, const InputLimits& limits) {
  ScenarioLines read;
  for (const std::string& path : paths) read.add(path, limits);
  std::set<std::string> scenes;
  for (const ScenarioLine& line : read.lines) {
    if (line.scenario) scenes.insert(line.scenario->asked.scene);
  }
  return scenes;
}

std::unique_ptr<PlannerCases> openScenarioCases(const std::vector<std::string>& paths,
                                                const LogSource& logs, std::size_t scenes_kept,
                                                const AnswerOptions& options,
                                                const NuScenesProgress& on_progress) {
  return std::make_unique<ScenarioCases>(paths, logs, scenes_kept, options, on_progress);
}

}  // namespace forge
