#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "collision_forge/io/logs/nuscenes_tokens.h"

namespace forge {

/// Receives the number of bytes read so far and in total, over all tables.
using NuScenesProgress = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// The parts of the tables that recordings need, as rows that refer to each other by index. Scenes,
/// samples and instances are complete; annotations, LIDAR_TOP sweeps and ego poses, with their
/// tokens, are only the rows that belong to the selected scenes.
struct NuScenesTables {
  // A std::uint32_t below is an index into one of the lists at the end, whose order is the order of
  // the tables (ego_poses and attribute_sets: of their first use). Units as in NuScenesRecording.
  /// A row of scene.json. Its lists of indices ascend, so they are in the order of the tables,
  /// which need not be the order of time.
  struct Scene {
    std::string name;
    std::string description;
    std::string location;    ///< name of the map
    bool is_wanted = false;  ///< true: a selected scene; the lists of other scenes are empty
    std::vector<std::uint32_t> samples;      ///< in `samples` of the tables
    std::vector<std::uint32_t> annotations;  ///< in `annotations`
    std::vector<std::uint32_t> sweeps;       ///< in `sweep_tokens` and `ego_pose_of_sweep`
  };
  /// A row of sample.json: a keyframe.
  struct Sample {
    std::int64_t timestamp_us = 0;  ///< microseconds since 1970
    std::uint32_t scene = 0;        ///< in `scenes`
  };
  /// A row of sample_annotation.json: one box in one sample.
  struct Annotation {
    std::uint32_t sample = 0;             ///< in `samples`
    std::uint32_t instance = 0;           ///< in `instance_tokens` and `category_of_instance`
    std::uint32_t attribute_set = 0;      ///< in `attribute_sets`
    std::array<double, 3> translation{};  ///< m, centre of the box in the map frame
    std::array<double, 3> size{};         ///< width, length, height, m, all > 0
    std::array<double, 4> rotation{};     ///< w, x, y, z
  };
  /// A row of ego_pose.json.
  struct EgoPose {
    bool is_read = false;                 ///< true for all poses after readNuScenesTables()
    std::int64_t timestamp_us = 0;        ///< microseconds since 1970
    std::array<double, 3> translation{};  ///< m, base_link in the map frame
    std::array<double, 4> rotation{};     ///< w, x, y, z
  };

  std::string folder;  ///< folder of the tables
  /// Tokens of the rows of the lists below: a token's number is its row's index.
  TokenIndex scene_tokens;
  TokenIndex sample_tokens;
  TokenIndex instance_tokens;
  TokenIndex annotation_tokens;
  /// Rows of sample_data of the selected scenes with channel LIDAR_TOP, as `ego_pose_of_sweep`.
  TokenIndex sweep_tokens;
  TokenIndex ego_pose_tokens;
  std::vector<Scene> scenes;
  std::vector<Sample> samples;                           ///< of all scenes
  std::vector<std::string> categories;                   ///< names
  std::vector<std::uint32_t> category_of_instance;       ///< in `categories`
  std::vector<std::vector<std::string>> attribute_sets;  ///< distinct lists of attribute names
  std::vector<Annotation> annotations;                   ///< of the selected scenes
  std::vector<std::uint32_t> ego_pose_of_sweep;          ///< in `ego_poses`
  std::vector<EgoPose> ego_poses;                        ///< at the sweeps
};

/// Reads the tables in `folder` (DATAROOT/VERSION), each once. Calls `on_progress`, if set, every
/// few megabytes. `only`: names of the selected scenes; empty: all. Throws NuScenesError for a
/// table that is missing or malformed, a row with a missing field or a field of another type, a
/// token that is duplicate or refers to no row, a box that is not finite or has no size, a rotation
/// of zeros, and an unknown name in `only`. Does not check rows of other scenes.
NuScenesTables readNuScenesTables(const std::string& folder, const std::vector<std::string>& only,
                                  const NuScenesProgress& on_progress);

/// Throws NuScenesError for an unknown scene `name`; the message lists the five most similar names.
[[noreturn]] void throwUnknownScene(const NuScenesTables& tables, const std::string& name);

}  // namespace forge
