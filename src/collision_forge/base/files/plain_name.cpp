#include "collision_forge/base/files/plain_name.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace forge {
namespace {

constexpr std::size_t kLongest = 200;  // bytes; file systems allow 255, and endings are appended
constexpr std::size_t kShown = 40;     // bytes of a name that is too long

bool isControl(char letter) {
  const auto code = static_cast<unsigned char>(letter);
  return code < 0x20 || code == 0x7f;
}

std::string quoted(const std::string& name) {
  std::string text;
  for (const char letter : name.substr(0, name.size() > kLongest ? kShown : name.size())) {
    char code[8];
    std::snprintf(code, sizeof(code), "\\x%02x", static_cast<unsigned char>(letter));
    text += isControl(letter) ? code : std::string(1, letter);
  }
  return "\"" + text + (name.size() > kLongest ? "...\"" : "\"");
}

const char* reasonAgainst(const std::string& name) {
  if (name.empty()) return "it is empty";
  if (name == "." || name == "..") return "it is the name of a folder";
  if (name.size() > kLongest) return "it is longer than 200 bytes";
  if (name.find('/') != std::string::npos) return "it contains '/'";
  if (std::any_of(name.begin(), name.end(), isControl)) return "it contains a control character";
  return nullptr;
}

}  // namespace

std::string nameFault(const std::string& name) {
  const char* reason = reasonAgainst(name);
  return reason == nullptr ? "" : quoted(name) + " is not a valid file name: " + reason;
}

std::string pathIn(const std::string& folder, const std::string& name) {
  const std::string fault = nameFault(name);
  if (!fault.empty()) throw std::runtime_error(folder + ": " + fault);
  return (std::filesystem::path(folder) / name).string();
}

}  // namespace forge
