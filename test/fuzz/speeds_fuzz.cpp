#include "collision_forge/io/weights/speed_model_file.h"
#include "collision_forge/io/weights/speed_profiles_file.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

void readModel(const std::string& path) {
  writeSpeedModel(readSpeedModel(path), path);
  const std::string written = bytesOf(path);
  writeSpeedModel(readSpeedModel(path), path);
  requireSame(written, bytesOf(path));
}

}  // namespace

/// A speed model, whose lines are JSON, or recorded speed profiles.
bool fuzzSpeeds(const std::string& input) {
  const InputFolder folder;
  const std::string path = folder.write("speeds", input);
  return isTaken(path, [&] {
    if (!input.empty() && input.front() == '{') {
      readModel(path);
    } else {
      readSpeedProfiles(path, configuration().recorded_speeds);
    }
  });
}

}  // namespace forge
