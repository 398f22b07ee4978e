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

/// The parts of the tables that recordings need, as rows that refer to each other by index. Samples
/// are complete; annotations and ego poses are limited to the selected scenes.
struct NuScenesTables {
  // A std::uint32_t below is an index into one of the lists at the end, whose order is the order of
  // the tables. Units as in NuScenesRecording.
  struct Scene {
    std::string name;
    std::string description;
    std::string location;
    bool is_wanted = false;
    std::vector<std::uint32_t> samples;
    std::vector<std::uint32_t> annotations;
    std::vector<std::uint32_t> sweeps;
  };
  struct Sample {
    std::int64_t timestamp_us = 0;
    std::uint32_t scene = 0;
  };
  struct Annotation {
    std::uint32_t sample = 0;
    std::uint32_t instance = 0;
    std::uint32_t attribute_set = 0;
    std::array<double, 3> translation{};
    std::array<double, 3> size{};      ///< width, length, height
    std::array<double, 4> rotation{};  ///< w, x, y, z
  };
  struct EgoPose {
    bool is_read = false;  ///< false for poses that no selected scene needs
    std::int64_t timestamp_us = 0;
    std::array<double, 3> translation{};
    std::array<double, 4> rotation{};  ///< w, x, y, z
  };

  std::string folder;  ///< folder of the tables
  TokenIndex scene_tokens;
  TokenIndex sample_tokens;
  TokenIndex instance_tokens;
  TokenIndex annotation_tokens;
  TokenIndex sweep_tokens;  ///< rows of sample_data with channel LIDAR_TOP
  TokenIndex ego_pose_tokens;
  std::vector<Scene> scenes;
  std::vector<Sample> samples;  ///< of all scenes
  std::vector<std::string> categories;
  std::vector<std::uint32_t> category_of_instance;
  std::vector<std::vector<std::string>> attribute_sets;  ///< names
  std::vector<Annotation> annotations;
  std::vector<std::uint32_t> ego_pose_of_sweep;
  std::vector<EgoPose> ego_poses;
};

/// Reads the tables in `folder`, each once. `only`: names of the selected scenes; empty: all.
/// Throws NuScenesError for a table that is missing or malformed, a row with a missing field or a
/// field of another type, a token that is duplicate or refers to no row, a box that is not finite
/// or has no size, and an unknown name in `only`. Does not check rows of other scenes.
NuScenesTables readNuScenesTables(const std::string& folder, const std::vector<std::string>& only,
                                  const NuScenesProgress& on_progress);

/// Throws NuScenesError for an unknown scene; the message lists the most similar names.
[[noreturn]] void throwUnknownScene(const NuScenesTables& tables, const std::string& name);

}  // namespace forge
