#include "collision_forge/io/logs/nuscenes_tables.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace forge {
namespace {

Eigen::Vector3d vectorOf(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

Eigen::Quaterniond quaternionOf(const std::array<double, 4>& wxyz) {
  return Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).normalized();
}

/// Throws if two consecutive `rows`, sorted by time, have the same timestamp.
template <typename TimestampOf>
void checkInstantsDiffer(const std::vector<std::uint32_t>& rows, const TimestampOf& timestamp_of,
                         const std::string& path, const TokenIndex& tokens) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (timestamp_of(rows[i]) != timestamp_of(rows[i - 1])) continue;
    throw NuScenesError(path + ": token " + tokens.text(rows[i]) + ": field timestamp " +
                        std::to_string(timestamp_of(rows[i])) + " is also the timestamp of " +
                        tokens.text(rows[i - 1]) +
                        " in the same scene: check that timestamps are set, in microseconds");
  }
}

std::vector<NuScenesEgoPose> egoPosesOf(const NuScenesTables& tables,
                                        const NuScenesTables::Scene& scene) {
  std::vector<std::uint32_t> rows;
  for (const std::uint32_t sweep : scene.sweeps) rows.push_back(tables.ego_pose_of_sweep[sweep]);
  const auto timestamp = [&](std::uint32_t row) { return tables.ego_poses[row].timestamp_us; };
  std::sort(rows.begin(), rows.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::make_pair(timestamp(a), a) < std::make_pair(timestamp(b), b);
  });
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  checkInstantsDiffer(rows, timestamp, tables.folder + "/ego_pose.json", tables.ego_pose_tokens);

  std::vector<NuScenesEgoPose> poses;
  poses.reserve(rows.size());
  for (const std::uint32_t row : rows) {
    const NuScenesTables::EgoPose& pose = tables.ego_poses[row];
    poses.push_back({pose.timestamp_us, vectorOf(pose.translation), quaternionOf(pose.rotation)});
  }
  return poses;
}

NuScenesAnnotation annotationOf(const NuScenesTables& tables, std::uint32_t row) {
  const NuScenesTables::Annotation& from = tables.annotations[row];
  NuScenesAnnotation annotation;
  annotation.token = tables.annotation_tokens.text(row);
  annotation.instance = tables.instance_tokens.text(from.instance);
  annotation.category = tables.categories[tables.category_of_instance[from.instance]];
  annotation.attributes = tables.attribute_sets[from.attribute_set];
  annotation.translation = vectorOf(from.translation);
  annotation.size = {from.size[1], from.size[0], from.size[2]};
  annotation.rotation = quaternionOf(from.rotation);
  return annotation;
}

/// Returns the scene's keyframes by time, still without annotations; fills `frame_of_sample`.
std::vector<NuScenesFrame> emptyFramesOf(
    const NuScenesTables& tables, const NuScenesTables::Scene& scene,
    std::unordered_map<std::uint32_t, std::size_t>& frame_of_sample) {
  std::vector<std::uint32_t> rows = scene.samples;
  const auto timestamp = [&](std::uint32_t row) { return tables.samples[row].timestamp_us; };
  std::sort(rows.begin(), rows.end(),
            [&](std::uint32_t a, std::uint32_t b) { return timestamp(a) < timestamp(b); });
  checkInstantsDiffer(rows, timestamp, tables.folder + "/sample.json", tables.sample_tokens);

  std::vector<NuScenesFrame> frames;
  for (const std::uint32_t row : rows) {
    frame_of_sample[row] = frames.size();
    frames.push_back({tables.sample_tokens.text(row), timestamp(row), {}});
  }
  return frames;
}

/// Throws if an instance is annotated twice in one sample.
void checkInstancesDiffer(const NuScenesTables& tables, const NuScenesTables::Scene& scene) {
  std::vector<std::uint32_t> rows = scene.annotations;
  const auto key = [&](std::uint32_t row) {
    return std::make_pair(tables.annotations[row].sample, tables.annotations[row].instance);
  };
  std::sort(rows.begin(), rows.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  const auto twice = std::adjacent_find(
      rows.begin(), rows.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) == key(b); });
  if (twice == rows.end()) return;
  throw NuScenesError(tables.folder + "/sample_annotation.json: token " +
                      tables.annotation_tokens.text(*twice) + ": field instance_token '" +
                      tables.instance_tokens.text(key(*twice).second) +
                      "' is annotated twice in one sample");
}

}  // namespace

NuScenesRoot::NuScenesRoot(const std::string& dataroot, const std::string& version,
                           const NuScenesReadOptions& options) {
  const std::string folder = dataroot + "/" + version;
  if (!std::filesystem::is_directory(folder)) throw NuScenesError(folder + ": no such folder");
  tables_ = std::make_shared<const NuScenesTables>(
      readNuScenesTables(folder, options.only, options.on_progress));
}

std::vector<std::string> NuScenesRoot::sceneNames() const {
  std::vector<std::string> names;
  for (const NuScenesTables::Scene& scene : tables_->scenes) {
    if (scene.is_wanted) names.push_back(scene.name);
  }
  return names;
}

NuScenesRecording NuScenesRoot::readScene(const std::string& name) const {
  const auto scene = std::find_if(tables_->scenes.begin(), tables_->scenes.end(),
                                  [&](const auto& candidate) { return candidate.name == name; });
  if (scene == tables_->scenes.end()) throwUnknownScene(*tables_, name);
  const std::string where = tables_->folder + "/";
  if (!scene->is_wanted) {
    throw NuScenesError(where + "scene.json: " + name + " is not among the selected scenes");
  }
  if (scene->samples.empty()) throw NuScenesError(where + "sample.json: no sample of " + name);
  if (scene->sweeps.empty()) {
    throw NuScenesError(where + "sample_data.json: no sweep of LIDAR_TOP, hence no ego pose, of " +
                        name);
  }
  checkInstancesDiffer(*tables_, *scene);

  NuScenesRecording recording;
  recording.name = scene->name;
  recording.description = scene->description;
  recording.location = scene->location;
  recording.ego_poses = egoPosesOf(*tables_, *scene);
  std::unordered_map<std::uint32_t, std::size_t> frame_of_sample;
  recording.frames = emptyFramesOf(*tables_, *scene, frame_of_sample);
  for (const std::uint32_t row : scene->annotations) {
    const std::size_t frame = frame_of_sample.at(tables_->annotations[row].sample);
    recording.frames[frame].annotations.push_back(annotationOf(*tables_, row));
  }
  deriveVelocities(recording);
  return recording;
}

}  // namespace forge
