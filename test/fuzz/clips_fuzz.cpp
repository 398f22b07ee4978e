#include <memory>

#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/io/collide/collide_scene.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

/// Returns the line as a file name without folders, shortened.
std::string plainName(const std::string& line) {
  constexpr std::size_t kLongest = 200;  // characters
  std::string name = line.substr(line.find_last_of('/') + 1);
  name = name.substr(0, std::min(name.find('\0'), kLongest));
  return name.empty() || name.front() == '.' ? "clip" : name;
}

}  // namespace

/// Input: a clip of COLLIDE, as a line with its file name, then the file's content.
bool fuzzClips(const std::string& input) {
  const InputFolder folder;
  const auto [line, rows] = firstLineOf(input);
  const std::string path = folder.write(plainName(line), rows);
  const StudyConfig& config = configuration();
  return isTaken(folder.path(), [&] {
    const CollideClip clip = readCollideClip(path, config.input_limits);
    const InputFolder copies;
    const std::string copy = copies.path() + "/" + composeCollideName(clip);
    writeCollideClip(copy, clip);
    const std::string written = bytesOf(copy);
    writeCollideClip(copy, readCollideClip(copy, config.input_limits));
    requireSame(written, bytesOf(copy));
    toScene(clip, config.evaluation.collide, std::make_shared<const LaneMap>());
  });
}

}  // namespace forge
