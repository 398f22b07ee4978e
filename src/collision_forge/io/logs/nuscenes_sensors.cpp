#include "collision_forge/io/logs/nuscenes_sensors.h"

#include <rapidjson/document.h>
#include <rapidjson/istreamwrapper.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <tuple>
#include <utility>

#include "collision_forge/io/logs/nuscenes_tokens.h"

namespace forge {
namespace {

/// Reads the tables that lead from sensor files to scenes.
class SensorTables {
 public:
  SensorTables(std::string dataroot, const std::string& version)
      : dataroot_(std::move(dataroot)), folder_(dataroot_ + "/" + version) {}

  std::map<std::string, NuScenesSensorScene> read(const std::vector<std::string>& only) {
    readScenes(only);
    readSensors();
    readFiles();
    for (auto& [_, scene] : scenes_) {
      scene.dataroot = dataroot_;
      std::sort(scene.files.begin(), scene.files.end(), [](const auto& a, const auto& b) {
        return std::tie(a.timestamp_us, a.sensor) < std::tie(b.timestamp_us, b.sensor);
      });
    }
    return std::move(scenes_);
  }

 private:
  /// A row of calibrated_sensor.json, and its place in the scenes that use it.
  struct Mounted {
    NuScenesSensor sensor;
    std::map<const NuScenesSensorScene*, std::uint32_t> places;
  };

  template <typename OnRow>
  void readRows(const char* table, const std::vector<std::string>& fields, const OnRow& on_row) {
    readTable(folder_ + "/" + table + ".json", fields, on_row);
  }

  static std::uint32_t follow(const TokenIndex& index, const JsonRow& row, std::size_t field,
                              const char* table) {
    if (const auto number = index.find(row.text(field))) return *number;
    row.fail(field, "'" + std::string(row.text(field)) + "' is not a row of " + table + ".json");
  }

  void readScenes(const std::vector<std::string>& only) {
    TokenIndex scene_tokens;
    std::vector<NuScenesSensorScene*> scene_of_row;
    readRows("scene", {"token", "name"}, [&](const JsonRow& row) {
      scene_tokens.add(row.token());
      const std::string name(row.text(1));
      const bool is_wanted =
          only.empty() || std::find(only.begin(), only.end(), name) != only.end();
      scene_of_row.push_back(is_wanted ? &scenes_[name] : nullptr);
    });
    readRows("sample", {"token", "scene_token"}, [&](const JsonRow& row) {
      sample_tokens_.add(row.token());
      scene_of_sample_.push_back(scene_of_row[follow(scene_tokens, row, 1, "scene")]);
    });
  }

  void readSensors() {
    TokenIndex sensor_tokens;
    std::vector<std::pair<std::string, std::string>> sensors;
    readRows("sensor", {"token", "channel", "modality"}, [&](const JsonRow& row) {
      sensor_tokens.add(row.token());
      sensors.emplace_back(row.text(1), row.text(2));
    });
    enum { kToken, kSensor, kTranslation, kRotation };
    const std::vector<std::string> fields = {"token", "sensor_token", "translation", "rotation"};
    readRows("calibrated_sensor", fields, [&](const JsonRow& row) {
      mounted_tokens_.add(row.token());
      NuScenesSensor sensor;
      std::tie(sensor.channel, sensor.modality) =
          sensors[follow(sensor_tokens, row, kSensor, "sensor")];
      const auto translation = row.numbers<3>(kTranslation);
      const auto rotation = row.numbers<4>(kRotation);
      sensor.translation = {translation[0], translation[1], translation[2]};
      sensor.rotation = {rotation[0], rotation[1], rotation[2], rotation[3]};
      mounted_.push_back({sensor, {}});
    });
    readIntrinsics();
  }

  /// Reads the camera matrices, which are nested arrays, empty for other sensors.
  void readIntrinsics() {
    std::ifstream file(folder_ + "/calibrated_sensor.json");
    rapidjson::IStreamWrapper stream(file);
    rapidjson::Document rows;
    rows.ParseStream(stream);
    for (rapidjson::SizeType row = 0; rows.IsArray() && row < rows.Size(); ++row) {
      const auto matrix = rows[row].FindMember("camera_intrinsic");
      if (matrix == rows[row].MemberEnd() || !matrix->value.IsArray()) continue;
      std::size_t place = 0;
      for (const auto& line : matrix->value.GetArray()) {
        if (!line.IsArray()) break;
        for (const auto& number : line.GetArray()) {
          auto& intrinsic = mounted_[row].sensor.intrinsic;
          if (place < intrinsic.size() && number.IsNumber())
            intrinsic[place++] = number.GetDouble();
        }
      }
    }
  }

  void readFiles() {
    enum { kToken, kSample, kMounted, kTimestamp, kFile, kWidth, kHeight };
    const std::vector<std::string> fields = {"token",     "sample_token", "calibrated_sensor_token",
                                             "timestamp", "filename",     "width",
                                             "height"};
    readRows("sample_data", fields, [&](const JsonRow& row) {
      NuScenesSensorScene* scene = scene_of_sample_[follow(sample_tokens_, row, kSample, "sample")];
      if (!scene) return;
      Mounted& mounted = mounted_[follow(mounted_tokens_, row, kMounted, "calibrated_sensor")];
      const auto [place, is_new] =
          mounted.places.try_emplace(scene, static_cast<std::uint32_t>(scene->sensors.size()));
      if (is_new) scene->sensors.push_back(mounted.sensor);
      NuScenesSensorFile file;
      file.timestamp_us = row.integer(kTimestamp);
      file.sensor = place->second;
      file.path = dataroot_ + "/" + std::string(row.text(kFile));
      file.width = static_cast<std::uint32_t>(row.integer(kWidth));
      file.height = static_cast<std::uint32_t>(row.integer(kHeight));
      scene->files.push_back(std::move(file));
    });
  }

  std::string dataroot_;
  std::string folder_;
  std::map<std::string, NuScenesSensorScene> scenes_;
  TokenIndex sample_tokens_;
  std::vector<NuScenesSensorScene*> scene_of_sample_;  ///< null: not wanted
  TokenIndex mounted_tokens_;
  std::vector<Mounted> mounted_;
};

}  // namespace

std::map<std::string, NuScenesSensorScene> readNuScenesSensors(
    const std::string& dataroot, const std::string& version, const std::vector<std::string>& only) {
  return SensorTables(dataroot, version).read(only);
}

}  // namespace forge
