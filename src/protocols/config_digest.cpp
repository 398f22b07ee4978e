#include "protocols/config_digest.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace forge {
namespace {

std::string hashOfFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path.string() + ": cannot be read");
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (auto byte = std::istreambuf_iterator<char>(file); byte != std::istreambuf_iterator<char>();
       ++byte) {
    hash = (hash ^ static_cast<unsigned char>(*byte)) * 0x100000001b3u;
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace

std::vector<std::string> digestConfig(const std::string& directory) {
  std::vector<std::string> lines;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".yaml" || name == "drawing.yaml") continue;
    lines.push_back("config/" + name + " = " + hashOfFile(entry.path()));
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

}  // namespace forge
