#include "collision_forge/io/logs/log_fingerprints.h"

#include <filesystem>

#include "collision_forge/base/files/file_fingerprint.h"

namespace forge {

std::map<std::string, std::string> logFingerprints(const std::string& path,
                                                   const std::string& version) {
  const std::string maps = path + "/maps";
  if (!std::filesystem::is_directory(maps)) return {{"logs", fingerprintOfTree(path)}};
  std::map<std::string, std::string> found;
  if (!version.empty()) found["tables"] = fingerprintOfTree(path + "/" + version, ".json");
  const std::string expansion = maps + "/expansion";
  if (std::filesystem::is_directory(expansion)) {
    found["maps"] = fingerprintOfTree(expansion, ".json");
  }
  return found;
}

}  // namespace forge
