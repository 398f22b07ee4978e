#include "collision_forge/study/evaluation/clip_choice.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/io/collide/collide_clip.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

std::string nameOf(const std::string& path) { return fs::path(path).stem().string(); }

double nominalTtaOf(const CollideName& name) {
  return kCollideFrameInterval * (name.collision_frame - kCollideNowFrame);
}

/// Returns a text as "9 clips in trajectory/val".
std::string describe(const std::vector<std::string>& paths) {
  const std::string count = std::to_string(paths.size()) + " clips";
  return paths.empty() ? count : count + " in " + fs::path(paths.front()).parent_path().string();
}

}  // namespace

std::vector<std::string> drawClips(const std::vector<std::string>& paths, std::size_t count,
                                   double min_tta, std::uint64_t seed) {
  std::map<CollisionType, std::vector<std::string>> left;
  std::size_t fitting = 0;
  for (const std::string& path : paths) {
    const CollideName name = parseCollideName(path);
    if (nominalTtaOf(name) < min_tta) continue;
    left[name.type].push_back(path);
    ++fitting;
  }
  if (fitting < count) {
    throw std::invalid_argument("only " + std::to_string(fitting) + " of " + describe(paths) +
                                " are long enough; " + std::to_string(count) + " requested");
  }
  Random random(seed);
  std::vector<std::string> drawn;
  while (drawn.size() < count) {
    for (const CollisionType type : kCollisionTypes) {
      std::vector<std::string>& clips = left[type];
      if (clips.empty() || drawn.size() == count) continue;
      const auto place = clips.begin() + static_cast<std::ptrdiff_t>(random.index(clips.size()));
      drawn.push_back(*place);
      clips.erase(place);
    }
  }
  return drawn;
}

std::string clipNamed(const std::vector<std::string>& paths, const std::string& name) {
  std::vector<std::string> matches;
  for (const std::string& path : paths) {
    if (fs::path(path).filename() == name || nameOf(path) == name) return path;
    if (nameOf(path).find(name) != std::string::npos) matches.push_back(path);
  }
  if (matches.size() == 1) return matches.front();
  if (matches.empty()) {
    throw std::invalid_argument(
        "\"" + name + "\" matches none of " + describe(paths) +
        (paths.empty() ? "" : "; names look like " + nameOf(paths.front())));
  }
  throw std::invalid_argument("\"" + name + "\" matches " + std::to_string(matches.size()) +
                              " clips, e.g. " + nameOf(matches[0]) + " and " + nameOf(matches[1]) +
                              "; give a longer part of the name");
}

}  // namespace forge
