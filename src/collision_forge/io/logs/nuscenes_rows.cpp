#include "collision_forge/io/logs/nuscenes_rows.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/logs/nuscenes_json.h"

namespace forge {
namespace {

constexpr const char* kTables[] = {"log",      "scene",      "sensor",
                                   "category", "attribute",  "calibrated_sensor",
                                   "instance", "sample",     "sample_annotation",
                                   "ego_pose", "sample_data"};
constexpr const char* kEgoPoseChannel = "LIDAR_TOP";

std::string inQuotes(std::string_view text) { return "'" + std::string(text) + "'"; }

/// Reads the tables into `tables_`, in order; each step needs the earlier ones.
class TableReader {
 public:
  TableReader(const std::string& folder, const std::vector<std::string>& only,
              const NuScenesProgress& on_progress)
      : only_(only), on_progress_(on_progress) {
    tables_.folder = folder;
    for (const char* table : kTables) {
      std::error_code error;
      bytes_in_all_ += std::filesystem::file_size(pathOf(table), error);
      if (error) throw NuScenesError(pathOf(table) + ": cannot be read: " + error.message());
    }
  }

  NuScenesTables read() {
    readScenes();
    readSamples();
    readInstances();
    readAnnotations();
    readSweeps();
    readEgoPoses();
    return std::move(tables_);
  }

 private:
  std::string pathOf(const std::string& table) const {
    return tables_.folder + "/" + table + ".json";
  }

  void readRows(const std::string& table, const std::vector<std::string>& fields,
                const std::function<void(const JsonRow&)>& on_row) {
    std::uint64_t bytes = 0;
    readTable(pathOf(table), fields, on_row, [&](std::uint64_t bytes_so_far) {
      bytes = bytes_so_far;
      if (on_progress_) on_progress_(bytes_before_ + bytes, bytes_in_all_);
    });
    bytes_before_ += bytes;
  }

  static std::uint32_t addNew(TokenIndex& index, const JsonRow& row) {
    const auto [number, is_new] = index.add(row.token());
    if (!is_new) row.fail(0, "is a duplicate");
    return number;
  }

  static std::uint32_t follow(const TokenIndex& index, const JsonRow& row, std::size_t field,
                              std::string_view token, const char* table) {
    const auto number = index.find(token);
    if (!number) row.fail(field, inQuotes(token) + " is not a row of " + table + ".json");
    return *number;
  }

  static std::uint32_t follow(const TokenIndex& index, const JsonRow& row, std::size_t field,
                              const char* table) {
    return follow(index, row, field, row.text(field), table);
  }

  /// Returns a text that becomes part of file names; fails if it is not valid there.
  static std::string nameOfFiles(const JsonRow& row, std::size_t field) {
    std::string name(row.text(field));
    const std::string fault = nameFault(name);
    if (!fault.empty()) row.fail(field, fault);
    return name;
  }

  /// Reads a table of tokens with one text each, for instance names; returns the texts by token
  /// number.
  std::vector<std::string> readTexts(const std::string& table, const std::string& field,
                                     TokenIndex& index) {
    std::vector<std::string> texts;
    readRows(table, {"token", field}, [&](const JsonRow& row) {
      addNew(index, row);
      texts.emplace_back(row.text(1));
    });
    return texts;
  }

  void readScenes() {
    TokenIndex logs;
    std::vector<std::string> locations;
    readRows("log", {"token", "location"}, [&](const JsonRow& row) {
      addNew(logs, row);
      locations.push_back(nameOfFiles(row, 1));
    });
    std::map<std::string, std::size_t> scene_of_name;
    enum { kToken, kName, kDescription, kLog };
    readRows("scene", {"token", "name", "description", "log_token"}, [&](const JsonRow& row) {
      const std::uint32_t number = addNew(tables_.scene_tokens, row);
      NuScenesTables::Scene scene;
      scene.name = nameOfFiles(row, kName);
      scene.description = row.text(kDescription);
      scene.location = locations[follow(logs, row, kLog, "log")];
      scene.is_wanted = only_.empty();
      if (!scene_of_name.emplace(scene.name, number).second) {
        row.fail(kName, inQuotes(scene.name) + " is also the name of another scene");
      }
      tables_.scenes.push_back(std::move(scene));
    });
    for (const std::string& name : only_) {
      const auto entry = scene_of_name.find(name);
      if (entry == scene_of_name.end()) throwUnknownScene(tables_, name);
      tables_.scenes[entry->second].is_wanted = true;
    }
  }

  void readSamples() {
    enum { kToken, kTimestamp, kScene };
    readRows("sample", {"token", "timestamp", "scene_token"}, [&](const JsonRow& row) {
      const std::uint32_t number = addNew(tables_.sample_tokens, row);
      const std::uint32_t scene = follow(tables_.scene_tokens, row, kScene, "scene");
      tables_.samples.push_back({row.integer(kTimestamp), scene});
      if (tables_.scenes[scene].is_wanted) tables_.scenes[scene].samples.push_back(number);
    });
  }

  void readInstances() {
    TokenIndex categories;
    tables_.categories = readTexts("category", "name", categories);
    readRows("instance", {"token", "category_token"}, [&](const JsonRow& row) {
      addNew(tables_.instance_tokens, row);
      tables_.category_of_instance.push_back(follow(categories, row, 1, "category"));
    });
  }

  void readAnnotations() {
    TokenIndex attributes;
    const std::vector<std::string> names = readTexts("attribute", "name", attributes);
    std::map<std::vector<std::string>, std::uint32_t> set_of_names;
    enum { kToken, kSample, kInstance, kAttributes, kTranslation, kSize, kRotation };
    const std::vector<std::string> fields = {
        "token",       "sample_token", "instance_token", "attribute_tokens",
        "translation", "size",         "rotation"};
    readRows("sample_annotation", fields, [&](const JsonRow& row) {
      NuScenesTables::Annotation annotation;
      annotation.sample = follow(tables_.sample_tokens, row, kSample, "sample");
      NuScenesTables::Scene& scene = tables_.scenes[tables_.samples[annotation.sample].scene];
      if (!scene.is_wanted) return;
      scene.annotations.push_back(addNew(tables_.annotation_tokens, row));
      annotation.instance = follow(tables_.instance_tokens, row, kInstance, "instance");
      std::vector<std::string> attribute_set;
      for (const std::string_view token : row.texts(kAttributes)) {
        attribute_set.push_back(names[follow(attributes, row, kAttributes, token, "attribute")]);
      }
      const auto [entry, is_new] =
          set_of_names.emplace(attribute_set, static_cast<std::uint32_t>(set_of_names.size()));
      if (is_new) tables_.attribute_sets.push_back(std::move(attribute_set));
      annotation.attribute_set = entry->second;
      annotation.translation = row.numbers<3>(kTranslation);
      annotation.size = row.numbers<3>(kSize);
      for (const double side : annotation.size) {
        if (side <= 0.0) row.fail(kSize, "has a side that is not positive: " + numberText(side));
      }
      annotation.rotation = rotationOf(row, kRotation);
      tables_.annotations.push_back(annotation);
    });
  }

  static std::array<double, 4> rotationOf(const JsonRow& row, std::size_t field) {
    const std::array<double, 4> rotation = row.numbers<4>(field);
    const auto is_zero = [](double part) { return part == 0.0; };
    if (std::all_of(rotation.begin(), rotation.end(), is_zero)) row.fail(field, "is all zero");
    return rotation;
  }

  void readSweeps() {
    TokenIndex sensors;
    const std::vector<std::string> channels = readTexts("sensor", "channel", sensors);
    TokenIndex mounted_sensors;
    std::vector<bool> is_lidar;
    readRows("calibrated_sensor", {"token", "sensor_token"}, [&](const JsonRow& row) {
      addNew(mounted_sensors, row);
      is_lidar.push_back(channels[follow(sensors, row, 1, "sensor")] == kEgoPoseChannel);
    });
    enum { kToken, kSample, kEgoPose, kSensor };
    const std::vector<std::string> fields = {"token", "sample_token", "ego_pose_token",
                                             "calibrated_sensor_token"};
    readRows("sample_data", fields, [&](const JsonRow& row) {
      if (!is_lidar[follow(mounted_sensors, row, kSensor, "calibrated_sensor")]) return;
      const std::uint32_t sample = follow(tables_.sample_tokens, row, kSample, "sample");
      NuScenesTables::Scene& scene = tables_.scenes[tables_.samples[sample].scene];
      if (!scene.is_wanted) return;
      scene.sweeps.push_back(addNew(tables_.sweep_tokens, row));
      tables_.ego_pose_of_sweep.push_back(tables_.ego_pose_tokens.add(row.text(kEgoPose)).first);
    });
  }

  void readEgoPoses() {
    tables_.ego_poses.resize(tables_.ego_pose_tokens.size());
    enum { kToken, kTimestamp, kTranslation, kRotation };
    const std::vector<std::string> fields = {"token", "timestamp", "translation", "rotation"};
    readRows("ego_pose", fields, [&](const JsonRow& row) {
      const auto number = tables_.ego_pose_tokens.find(row.token());
      if (!number) return;
      NuScenesTables::EgoPose& pose = tables_.ego_poses[*number];
      if (pose.is_read) row.fail(kToken, "is a duplicate");
      pose.is_read = true;
      pose.timestamp_us = row.integer(kTimestamp);
      pose.translation = row.numbers<3>(kTranslation);
      pose.rotation = rotationOf(row, kRotation);
    });
    for (std::uint32_t sweep = 0; sweep < tables_.ego_pose_of_sweep.size(); ++sweep) {
      const std::uint32_t number = tables_.ego_pose_of_sweep[sweep];
      if (tables_.ego_poses[number].is_read) continue;
      throw NuScenesError(pathOf("sample_data") + ": token " + tables_.sweep_tokens.text(sweep) +
                          ": field ego_pose_token " +
                          inQuotes(tables_.ego_pose_tokens.text(number)) +
                          " is not a row of ego_pose.json");
    }
  }

  const std::vector<std::string>& only_;
  const NuScenesProgress& on_progress_;
  NuScenesTables tables_;
  std::uint64_t bytes_before_ = 0;
  std::uint64_t bytes_in_all_ = 0;
};

}  // namespace

NuScenesTables readNuScenesTables(const std::string& folder, const std::vector<std::string>& only,
                                  const NuScenesProgress& on_progress) {
  return TableReader(folder, only, on_progress).read();
}

void throwUnknownScene(const NuScenesTables& tables, const std::string& name) {
  constexpr std::size_t kNamed = 5;
  std::vector<std::pair<std::size_t, std::string>> nearest;
  for (const NuScenesTables::Scene& scene : tables.scenes) {
    nearest.emplace_back(editDistance(name, scene.name), scene.name);
  }
  std::sort(nearest.begin(), nearest.end());
  std::string message = tables.folder + "/scene.json: no scene is named " + inQuotes(name) +
                        "; the most similar of " + std::to_string(nearest.size()) + ":";
  for (std::size_t i = 0; i < std::min(kNamed, nearest.size()); ++i) {
    message += " " + nearest[i].second;
  }
  throw NuScenesError(message);
}

}  // namespace forge
