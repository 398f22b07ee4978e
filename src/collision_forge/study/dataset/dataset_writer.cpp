#include "collision_forge/study/dataset/dataset_writer.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/collide/collide_export.h"
#include "collision_forge/study/dataset/dataset_statistics.h"
#include "collision_forge/study/dataset/scene_split.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// Writes the files of a data set; see writeDataset().
class DatasetWriter {
 public:
  DatasetWriter(const std::string& folder, const std::string& path, const DatasetOptions& options,
                const InputLimits& limits, SceneSource& scenes)
      : folder_(folder), path_(path), options_(options), limits_(limits), scenes_(scenes) {}

  std::string write(const std::vector<Attempt>& attempts, const std::vector<std::size_t>& chosen) {
    deal(attempts, chosen);
    writeClips(chosen);
    return writeStatistics(attempts);
  }

 private:
  /// The open output of one split; the scenario file is renamed into place at the end.
  struct Store {
    std::unique_ptr<AsideFile> file;
    std::unique_ptr<CollideExporter> exporter;
  };

  void deal(const std::vector<Attempt>& attempts, const std::vector<std::size_t>& chosen) {
    std::vector<std::string> names;
    for (const std::size_t index : chosen) names.push_back(attempts[index].asked.scene);
    splits_ = splitByScene(names, options_.split);
  }

  void writeClips(const std::vector<std::size_t>& chosen) {
    fs::create_directories(fs::path(folder_) / "scenarios");
    std::ifstream file(path_);
    std::string line;
    std::size_t next = 0;
    ProgressLine progress("writing");
    for (std::size_t done = 0; done < chosen.size(); ++done) {
      for (; next <= chosen[done]; ++next) std::getline(file, line);
      writeClip(line, chosen[done]);
      progress.show(static_cast<double>(done + 1) / static_cast<double>(chosen.size()));
    }
    for (auto& [split, store] : stores_) {
      store.file->commit();
    }
  }

  void writeClip(const std::string& line, std::size_t index) {
    const std::string where = path_ + ": line " + std::to_string(index + 1);
    Scenario scenario = readScenarioLine(where, line, limits_);
    const auto indexed = scenes_.at(scenario.asked.scene);
    const std::string& split = splits_.at(scenario.asked.scene);
    Store& store = storeOf(split);
    store.file->stream() << line << "\n";
    store.exporter->add(scenario, indexed->scene, static_cast<int>(index));
    const CollisionReport& report = scenario.answer.report;
    clips_.push_back({split, scenario.asked.scene, indexed->scene.map->location,
                      scenario.asked.request.type, Attempt{scenario.asked}.length(),
                      report.relative_heading, report.off_road_share});
  }

  Store& storeOf(const std::string& split) {
    Store& store = stores_[split];
    if (!store.exporter) {
      const fs::path scenarios = fs::path(folder_) / "scenarios";
      store.file = std::make_unique<AsideFile>((scenarios / (split + ".jsonl")).string());
      store.exporter = std::make_unique<CollideExporter>(folder_, split);
    }
    return store;
  }

  std::string writeStatistics(const std::vector<Attempt>& attempts) const {
    std::map<CollisionType, Attempts> tried;
    for (const Attempt& attempt : attempts) {
      Attempts& sum = tried[attempt.asked.request.type];
      ++sum.tried;
      sum.valid += attempt.valid ? 1 : 0;
    }
    const std::string text = datasetMarkdown(clips_, tried);
    writeText((fs::path(folder_) / "statistics.csv").string(), datasetCsv(clips_));
    writeText((fs::path(folder_) / "statistics.md").string(), text);
    return text;
  }

  const std::string& folder_;
  const std::string& path_;
  const DatasetOptions& options_;
  const InputLimits& limits_;
  SceneSource& scenes_;
  std::map<std::string, std::string> splits_;
  std::map<std::string, Store> stores_;
  std::vector<DatasetClip> clips_;
};

}  // namespace

std::string writeDataset(const std::string& folder, const std::string& path,
                         const std::vector<Attempt>& attempts,
                         const std::vector<std::size_t>& chosen, const DatasetOptions& options,
                         const InputLimits& limits, SceneSource& scenes) {
  return DatasetWriter(folder, path, options, limits, scenes).write(attempts, chosen);
}

}  // namespace forge
