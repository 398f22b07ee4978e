#include "collision_forge/data/collide_set.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "collision_forge/data/collide_clip.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// FNV-1a, 64 bits, then the finalizer of splitmix64, so that the upper bits depend on all of it.
std::uint64_t hashOf(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char character : text) {
    hash = (hash ^ static_cast<unsigned char>(character)) * 0x100000001b3u;
  }
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
  return hash ^ (hash >> 31);
}

bool byFileName(const std::string& a, const std::string& b) {
  return fs::path(a).filename() < fs::path(b).filename();
}

}  // namespace

bool isHeldOutScene(const std::string& scene, double share) {
  return static_cast<double>(hashOf(scene) >> 11) * 0x1p-53 < share;
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
  if (paths.empty()) throw CollideError(folder.string() + ": holds no clip");
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

}  // namespace forge
