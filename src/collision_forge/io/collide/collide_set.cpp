#include "collision_forge/io/collide/collide_set.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "collision_forge/base/files/fingerprint.h"
#include "collision_forge/io/collide/collide_clip.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

bool byFileName(const std::string& a, const std::string& b) {
  return fs::path(a).filename() < fs::path(b).filename();
}

}  // namespace

bool isHeldOutScene(const std::string& scene, double share) {
  return static_cast<double>(mixed(hashOf(scene)) >> 11) * 0x1p-53 < share;
}

std::vector<std::string> listCollideClips(const std::string& directory, const std::string& split) {
  const fs::path folder = fs::path(directory) / "trajectory" / split;
  if (!fs::is_directory(folder)) throw CollideError(folder.string() + ": no such folder");
  std::vector<std::string> paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string path = entry.path().string();
    parseCollideName(path);
    paths.push_back(path);
  }
  if (paths.empty()) throw CollideError(folder.string() + ": has no clip");
  std::sort(paths.begin(), paths.end(), byFileName);
  return paths;
}

std::vector<std::string> listCollideClipsByScene(const std::string& directory,
                                                 const std::string& split, double held_out_share) {
  if (split != "train" && split != "val") {
    throw std::invalid_argument("the split by scene has train and val, not " + split);
  }
  std::vector<std::string> paths;
  for (const char* published : {"train", "val"}) {
    for (const std::string& path : listCollideClips(directory, published)) {
      const bool held_out = isHeldOutScene(parseCollideName(path).scene, held_out_share);
      if (held_out == (split == "val")) paths.push_back(path);
    }
  }
  if (paths.empty()) {
    throw CollideError(directory + ": no clips in " + split + " of the split by scene");
  }
  std::sort(paths.begin(), paths.end(), byFileName);
  return paths;
}

ClipHalves halvesByScene(const std::vector<std::string>& paths) {
  std::map<std::string, std::vector<std::string>> scenes;
  for (const std::string& path : paths) scenes[parseCollideName(path).scene].push_back(path);
  ClipHalves halves;
  bool is_first = true;
  for (const auto& [scene, clips] : scenes) {
    std::vector<std::string>& half = is_first ? halves.first : halves.second;
    half.insert(half.end(), clips.begin(), clips.end());
    is_first = !is_first;
  }
  if (halves.second.empty())
    throw CollideError("cannot form two halves: all clips are of one scene");
  return halves;
}

}  // namespace forge
