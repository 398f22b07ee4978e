#include "collision_forge/io/weights/speed_model_file.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {

/// Input: a speed model, with lines of JSON.
bool fuzzSpeeds(const std::string& input) {
  const InputFolder folder;
  const std::string path = folder.write("speeds", input);
  return isTaken(path, [&] {
    writeSpeedModel(readSpeedModel(path), path);
    const std::string written = bytesOf(path);
    writeSpeedModel(readSpeedModel(path), path);
    requireSame(written, bytesOf(path));
  });
}

}  // namespace forge
